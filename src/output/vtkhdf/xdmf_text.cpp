#include "src/output/vtkhdf/xdmf_text.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "src/output/files/safe_text.hpp"

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

// Rows of a dataset, and one component of them or all (-1).
struct Slab {
  std::int64_t first, rows;
  int component = -1;
};

void write_slab(Out out, const XdmfIndex& index, const Dataset& data, const Slab& slab) {
  const bool one = slab.component >= 0;
  fmt::format_to(out, "\n    <DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">\n",
                 one ? fmt::format("{} 1", slab.rows) : shape_text(slab.rows, data.components));
  if (data.components == 1) {
    fmt::format_to(out, "     <DataItem Dimensions=\"3 1\" Format=\"XML\">{} 1 {}</DataItem>\n     ", slab.first,
                   slab.rows);
  } else {
    fmt::format_to(out, "     <DataItem Dimensions=\"3 2\" Format=\"XML\">{} {} 1 1 {} {}</DataItem>\n     ",
                   slab.first, one ? slab.component : 0, slab.rows, one ? 1 : data.components);
  }
  write_dataset(out, index, data);
  fmt::format_to(out, "\n    </DataItem>");
}

// Rows of a grid, and whether its fields are labelled: names with units, tensors by component.
struct Grid {
  MeshExtent rows;
  bool labelled = false;
};

constexpr std::array tensor_components{"xx", "yy", "zz", "xy", "yz", "zx"};

constexpr const char* positions_name = "Points";  // no field has this name

std::string path_of(const XdmfField& field) {
  if (field.name == positions_name) return positions_name;
  return fmt::format("{}/{}", field.place == FieldPlace::node ? "PointData" : "CellData", field.name);
}

// The rows of a grid in one frame, within a dataset that holds those of all nodes or elements in all frames.
// component: the only requested one; -1: all.
void write_frame_rows(Out out, const XdmfIndex& index, const Grid& grid, const XdmfField& field, std::size_t frame,
                      int component = -1) {
  const bool on_nodes = field.place == FieldPlace::node;
  const std::int64_t all = on_nodes ? index.mesh.nodes : index.mesh.elements;
  const std::int64_t first = on_nodes ? grid.rows.first_node : grid.rows.first_element;
  const std::int64_t rows = on_nodes ? grid.rows.nodes : grid.rows.elements;
  const Dataset data{"VTKHDF/" + path_of(field), field.bytes == 1 ? "UChar" : "Float", field.bytes, field.components,
                     static_cast<std::int64_t>(index.times.size()) * all};
  write_slab(out, index, data, {static_cast<std::int64_t>(frame) * all + first, rows, component});
}

// Six components are a matrix, not a Tensor6, whose order in XDMF (xx, xy, xz, yy, yz, zz) is another one.
const char* attribute_type(int components) {
  return components == 1 ? "Scalar" : components == 3 ? "Vector" : "Matrix";
}

void open_attribute(Out out, const std::string& name, int components, FieldPlace place) {
  fmt::format_to(out, "   <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">", name, attribute_type(components),
                 place == FieldPlace::node ? "Node" : "Cell");
}

// Whole numbers that all frames share.
void write_ids(Out out, const XdmfIndex& index, const Grid& grid, const std::string& name, FieldPlace place) {
  open_attribute(out, name, 1, place);
  const bool on_nodes = place == FieldPlace::node;
  const std::int64_t all = on_nodes ? index.mesh.nodes : index.mesh.elements;
  const std::int64_t rows = on_nodes ? grid.rows.nodes : grid.rows.elements;
  const Dataset ids{"VTKHDF/" + path_of({name, place}), "Int", 8, 1, all};
  if (rows == all) {
    write_dataset(out, index, ids);
  } else {
    write_slab(out, index, ids, {on_nodes ? grid.rows.first_node : grid.rows.first_element, rows});
  }
  fmt::format_to(out, "</Attribute>\n");
}

void write_topology(Out out, const XdmfIndex& index, const Grid& grid) {
  const MeshExtent& rows = grid.rows;
  const bool mixed = rows.is_mixed();
  const auto used = std::find_if(rows.of_topology.begin(), rows.of_topology.end(), [](auto n) { return n > 0; });
  const auto only = static_cast<std::size_t>(used - rows.of_topology.begin()) % topology_count;
  const std::string_view kind = mixed ? "Mixed" : topologies[only].xdmf_name;
  fmt::format_to(out, "   <Topology TopologyType=\"{}\" NumberOfElements=\"{}\"", kind, rows.elements);
  if (!mixed && topologies[only].is_line())
    fmt::format_to(out, " NodesPerElement=\"{}\"", topologies[only].corner_count);
  // The corners in the file are numbers of nodes of the whole mesh.
  if (rows.first_node > 0) fmt::format_to(out, " BaseOffset=\"{}\"", rows.first_node);
  fmt::format_to(out, ">");
  // As a slab, though it may be the whole: VTK's reader would take text here for the name of a file whose mesh it may
  // reuse for the next frame, and complain that the points have no such name.
  const auto count = [mixed](const MeshExtent& e) { return mixed ? e.mixed_size() : e.corners(); };
  write_slab(out, index, {mixed ? "percuss/xdmf_topology" : "VTKHDF/Connectivity", "Int", 8, 1, count(index.mesh)},
             {mixed ? rows.first_mixed : rows.first_corner, count(rows)});
  fmt::format_to(out, "</Topology>\n");
}

void write_field(Out out, const XdmfIndex& index, const Grid& grid, const XdmfField& field, std::size_t frame) {
  const std::string unit = grid.labelled && !field.unit.empty() ? fmt::format(" [{}]", field.unit) : "";
  if (!grid.labelled || field.components != 6) {
    open_attribute(out, field.name + unit, field.components, field.place);
    write_frame_rows(out, index, grid, field, frame);
    fmt::format_to(out, "</Attribute>\n");
    return;
  }
  // ParaView 6.1 takes a matrix of all elements for one long tuple.
  for (int c = 0; c < 6; ++c) {
    open_attribute(out, fmt::format("{}_{}{}", field.name, tensor_components[static_cast<std::size_t>(c)], unit), 1,
                   field.place);
    write_frame_rows(out, index, grid, field, frame, c);
    fmt::format_to(out, "</Attribute>\n");
  }
}

void write_frame(Out out, const XdmfIndex& index, const Grid& grid, std::size_t frame) {
  fmt::format_to(out, "  <Grid Name=\"frame {}\" GridType=\"Uniform\">\n   <Time Value=\"{}\"/>\n", frame,
                 index.times[frame]);
  write_topology(out, index, grid);
  fmt::format_to(out, "   <Geometry GeometryType=\"XYZ\">");
  write_frame_rows(out, index, grid, {positions_name, FieldPlace::node, 3}, frame);
  fmt::format_to(out, "</Geometry>\n");
  for (const auto& field : index.fields) write_field(out, index, grid, field, frame);
  write_ids(out, index, grid, "node_id", FieldPlace::node);
  write_ids(out, index, grid, "element_id", FieldPlace::element);
  write_ids(out, index, grid, "part", FieldPlace::element);
  fmt::format_to(out, "  </Grid>\n");
}

// All frames of a grid.
void write_grid(Out out, const XdmfIndex& index, const Grid& grid, const std::string& name) {
  fmt::format_to(out, " <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", escape_xml(name));
  for (std::size_t frame = 0; frame < index.times.size(); ++frame) write_frame(out, index, grid, frame);
  fmt::format_to(out, " </Grid>\n");
}

// Writes what applies to all grids, for people and for programs that look for it: readers of XDMF pass over it.
void write_information(Out out, const XdmfIndex& index) {
  const auto write = [&](const std::string& name, const std::string& value) {
    fmt::format_to(out, "  <Information Name=\"{}\" Value=\"{}\"/>\n", name, escape_xml(value));
  };
  write("title", index.title);
  write("units", index.units);
  for (std::size_t part = 0; part < index.parts.size(); ++part) write(fmt::format("part {}", part), index.parts[part]);
  for (const auto& field : index.fields) {
    if (!field.unit.empty()) write("unit of " + field.name, field.unit);
  }
  for (std::size_t w = 0; w < index.walls.size(); ++w) {
    const Vec3 &point = index.walls[w].point, &normal = index.walls[w].normal;
    write(fmt::format("wall {}", w), fmt::format("point {} {} {}, normal {} {} {}", point[0], point[1], point[2],
                                                 normal[0], normal[1], normal[2]));
  }
}

template <class WriteGrids>
std::string make_text(const XdmfIndex& index, const WriteGrids& write_grids) {
  std::string text;
  const Out out(text);
  fmt::format_to(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n");
  write_information(out, index);
  write_grids(out);
  fmt::format_to(out, " </Domain>\n</Xdmf>\n");
  return text;
}

// A part with several kinds of elements has them in another dataset, with whose numbers readers do not use BaseOffset:
// its grid refers to all nodes.
MeshExtent extend_to_nodes(const XdmfIndex& index, MeshExtent part) {
  if (part.is_mixed()) {
    part.first_node = 0;
    part.nodes = index.mesh.nodes;
  }
  return part;
}

}  // namespace

std::string make_xdmf_text(const XdmfIndex& index) {
  return make_text(index, [&](Out out) { write_grid(out, index, {index.mesh}, "percuss"); });
}

std::string make_xdmf_text_by_parts(const XdmfIndex& index) {
  return make_text(index, [&](Out out) {
    // Parts of frames, not frames of parts: readers give every grid of one name in the file another number, and the
    // blocks would change their names from frame to frame.
    fmt::format_to(out, " <Grid Name=\"percuss\" GridType=\"Collection\" CollectionType=\"Spatial\">\n");
    for (std::size_t p = 0; p < index.parts.size(); ++p)
      write_grid(out, index, {extend_to_nodes(index, index.extents[p]), true}, index.parts[p]);
    fmt::format_to(out, " </Grid>\n");
  });
}

}  // namespace percuss
