#include "src/output/xdmf_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "src/output/safe_text.hpp"

namespace percuss {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string shape_text(std::int64_t rows, int components) {
  return components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
}

// A dataset of the HDF5 file, row by row.
struct Dataset {
  std::string path;  // within the file
  const char* number;
  int bytes, components;
  std::int64_t rows;  // all of them
};

void write_dataset(Out out, const XdmfIndex& index, const Dataset& data) {
  fmt::format_to(out, R"(<DataItem Dimensions="{}" NumberType="{}" Precision="{}" Format="HDF">{}:/{}</DataItem>)",
                 shape_text(data.rows, data.components), data.number, data.bytes, index.file, data.path);
}

// Some rows of a dataset.
void write_slab(Out out, const XdmfIndex& index, const Dataset& data, std::int64_t first, std::int64_t rows) {
  fmt::format_to(out, "\n    <DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">\n", shape_text(rows, data.components));
  if (data.components == 1) {
    fmt::format_to(out, "     <DataItem Dimensions=\"3 1\" Format=\"XML\">{} 1 {}</DataItem>\n     ", first, rows);
  } else {
    fmt::format_to(out, "     <DataItem Dimensions=\"3 2\" Format=\"XML\">{} 0 1 1 {} {}</DataItem>\n     ", first,
                   rows, data.components);
  }
  write_dataset(out, index, data);
  fmt::format_to(out, "\n    </DataItem>");
}

// The rows of one frame within a dataset that holds those of all frames.
void write_frame_rows(Out out, const XdmfIndex& index, const std::string& path, std::int64_t rows, int components,
                      int bytes, std::size_t frame) {
  const auto all = static_cast<std::int64_t>(index.times.size()) * rows;
  write_slab(out, index, {"VTKHDF/" + path, bytes == 1 ? "UChar" : "Float", bytes, components, all},
             static_cast<std::int64_t>(frame) * rows, rows);
}

// Six components are a matrix, not a Tensor6, whose order in XDMF (xx, xy, xz, yy, yz, zz) is another one.
const char* attribute_type(int components) {
  return components == 1 ? "Scalar" : components == 3 ? "Vector" : "Matrix";
}

void open_attribute(Out out, const std::string& name, int components, FieldPlace place) {
  fmt::format_to(out, "   <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">", name, attribute_type(components),
                 place == FieldPlace::node ? "Node" : "Cell");
}

std::string path_of(const std::string& name, FieldPlace place) {
  return fmt::format("{}/{}", place == FieldPlace::node ? "PointData" : "CellData", name);
}

// Whole numbers that all frames share.
void write_ids(Out out, const XdmfIndex& index, const std::string& name, FieldPlace place) {
  open_attribute(out, name, 1, place);
  const auto items = place == FieldPlace::node ? index.nodes : index.elements;
  write_dataset(out, index, {"VTKHDF/" + path_of(name, place), "Int", 8, 1, items});
  fmt::format_to(out, "</Attribute>\n");
}

void write_mesh(Out out, const XdmfIndex& index, std::size_t frame) {
  const bool mixed =
      (index.shells > 0 && index.shells < index.elements) || (index.triangles > 0 && index.triangles < index.elements);
  const char* kind = mixed                 ? "Mixed"
                     : index.triangles > 0 ? "Triangle"
                     : index.shells > 0    ? "Quadrilateral"
                                           : "Hexahedron";
  fmt::format_to(out, "   <Topology TopologyType=\"{}\" NumberOfElements=\"{}\">", kind, index.elements);
  // As a slab, though it is the whole: VTK's reader would take text here for the name of a file whose mesh it may reuse
  // for the next frame, and complain that the points have no such name.
  const std::int64_t ids = 8 * index.elements - 4 * index.shells - index.triangles + (mixed ? index.elements : 0);
  write_slab(out, index, {mixed ? "percuss/xdmf_topology" : "VTKHDF/Connectivity", "Int", 8, 1, ids}, 0, ids);
  fmt::format_to(out, "</Topology>\n   <Geometry GeometryType=\"XYZ\">");
  write_frame_rows(out, index, "Points", index.nodes, 3, 8, frame);
  fmt::format_to(out, "</Geometry>\n");
}

void write_frame(Out out, const XdmfIndex& index, std::size_t frame) {
  fmt::format_to(out, "  <Grid Name=\"frame {}\" GridType=\"Uniform\">\n   <Time Value=\"{}\"/>\n", frame,
                 index.times[frame]);
  write_mesh(out, index, frame);
  for (const auto& field : index.fields) {
    open_attribute(out, field.name, field.components, field.place);
    const auto items = field.place == FieldPlace::node ? index.nodes : index.elements;
    write_frame_rows(out, index, path_of(field.name, field.place), items, field.components, field.bytes, frame);
    fmt::format_to(out, "</Attribute>\n");
  }
  write_ids(out, index, "node_id", FieldPlace::node);
  write_ids(out, index, "element_id", FieldPlace::element);
  write_ids(out, index, "part", FieldPlace::element);
  fmt::format_to(out, "  </Grid>\n");
}

}  // namespace

std::string make_xdmf_text(const XdmfIndex& index) {
  std::string text;
  const Out out(text);
  fmt::format_to(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n");
  fmt::format_to(out, "  <Information Name=\"title\" Value=\"{}\"/>\n", escape_xml(index.title));
  fmt::format_to(out, "  <Information Name=\"units\" Value=\"{}\"/>\n", escape_xml(index.units));
  for (std::size_t part = 0; part < index.parts.size(); ++part)
    fmt::format_to(out, "  <Information Name=\"part {}\" Value=\"{}\"/>\n", part, escape_xml(index.parts[part]));
  fmt::format_to(out, " <Grid Name=\"percuss\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
  for (std::size_t frame = 0; frame < index.times.size(); ++frame) write_frame(out, index, frame);
  fmt::format_to(out, " </Grid>\n </Domain>\n</Xdmf>\n");
  return text;
}

}  // namespace percuss
