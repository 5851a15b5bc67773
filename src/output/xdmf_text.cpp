#include "src/output/xdmf_text.hpp"

#include <fmt/format.h>

#include <iterator>

namespace percuss {
namespace {

using Out = std::back_insert_iterator<std::string>;

// Text as an attribute value of XML. Control characters have no place in XML 1.0 at all.
std::string escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      default: escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string shape_text(std::int64_t rows, int components) {
  return components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
}

// A whole dataset that all frames share.
void write_static_item(Out out, const XdmfIndex& index, const char* dataset, std::int64_t count) {
  fmt::format_to(out, R"(<DataItem Dimensions="{}" NumberType="Int" Precision="8" Format="HDF">{}:/VTKHDF/{}</DataItem>)",
                 count, index.file, dataset);
}

// The rows of one frame within a dataset that holds those of all frames.
void write_frame_item(Out out, const XdmfIndex& index, const std::string& dataset, std::int64_t rows, int components,
                      int bytes, std::size_t frame) {
  const auto first = static_cast<std::int64_t>(frame) * rows;
  const auto all = static_cast<std::int64_t>(index.times.size()) * rows;
  fmt::format_to(out, "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">\n", shape_text(rows, components));
  if (components == 1) {
    fmt::format_to(out, R"(     <DataItem Dimensions="3 1" Format="XML">{} 1 {}</DataItem>)", first, rows);
  } else {
    fmt::format_to(out, R"(     <DataItem Dimensions="3 2" Format="XML">{} 0 1 1 {} {}</DataItem>)", first, rows,
                   components);
  }
  fmt::format_to(out,
                 "\n     <DataItem Dimensions=\"{}\" NumberType=\"Float\" Precision=\"{}\" "
                 "Format=\"HDF\">{}:/VTKHDF/{}</DataItem>\n    </DataItem>",
                 shape_text(all, components), bytes, index.file, dataset);
}

// Six components are a matrix, not a Tensor6, whose order in XDMF (xx, xy, xz, yy, yz, zz) is another one.
const char* attribute_type(int components) {
  return components == 1 ? "Scalar" : components == 3 ? "Vector" : "Matrix";
}

void write_ids(Out out, const XdmfIndex& index, const char* name, FieldPlace place) {
  const bool on_nodes = place == FieldPlace::node;
  fmt::format_to(out, "   <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"{}\">", name,
                 on_nodes ? "Node" : "Cell");
  write_static_item(out, index, fmt::format("{}/{}", on_nodes ? "PointData" : "CellData", name).c_str(),
                    on_nodes ? index.nodes : index.elements);
  fmt::format_to(out, "</Attribute>\n");
}

void write_frame(Out out, const XdmfIndex& index, std::size_t frame) {
  fmt::format_to(out, "  <Grid Name=\"frame {}\" GridType=\"Uniform\">\n   <Time Value=\"{}\"/>\n", frame,
                 index.times[frame]);
  fmt::format_to(out, "   <Topology TopologyType=\"Hexahedron\" NumberOfElements=\"{}\">", index.elements);
  write_static_item(out, index, "Connectivity", 8 * index.elements);
  fmt::format_to(out, "</Topology>\n   <Geometry GeometryType=\"XYZ\">");
  write_frame_item(out, index, "Points", index.nodes, 3, 8, frame);
  fmt::format_to(out, "</Geometry>\n");
  for (const auto& field : index.fields) {
    const bool on_nodes = field.place == FieldPlace::node;
    fmt::format_to(out, "   <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">", field.name,
                   attribute_type(field.components), on_nodes ? "Node" : "Cell");
    write_frame_item(out, index, fmt::format("{}/{}", on_nodes ? "PointData" : "CellData", field.name),
                     on_nodes ? index.nodes : index.elements, field.components, field.bytes, frame);
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
  fmt::format_to(out, "  <Information Name=\"title\" Value=\"{}\"/>\n", escape(index.title));
  fmt::format_to(out, "  <Information Name=\"units\" Value=\"{}\"/>\n", escape(index.units));
  for (std::size_t part = 0; part < index.parts.size(); ++part)
    fmt::format_to(out, "  <Information Name=\"part {}\" Value=\"{}\"/>\n", part, escape(index.parts[part]));
  fmt::format_to(out, " <Grid Name=\"percuss\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
  for (std::size_t frame = 0; frame < index.times.size(); ++frame) write_frame(out, index, frame);
  fmt::format_to(out, " </Grid>\n </Domain>\n</Xdmf>\n");
  return text;
}

}  // namespace percuss
