#include "src/mesh/formats/vtu/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/mesh/files/passed_over.hpp"
#include "src/mesh/files/text_mesh.hpp"
#include "src/mesh/files/text_numbers.hpp"
#include "src/mesh/formats/vtu/vtu_arrays.hpp"
#include "src/mesh/formats/vtu/xml_scanner.hpp"

namespace percuss {
namespace {

/// Arrays that number blocks, the first of which that a file has counts; in small letters, letters and digits alone.
constexpr std::array block_arrays{
    "part",        "partid",   "parts",        "block",         "blockid",  "blockids", "elementblockids", "materialid",
    "materialids", "material", "gmshphysical", "cellentityids", "objectid", "mediref",  "region",          "regionid"};
constexpr std::array node_id_arrays{"globalnodeid", "globalnodeids", "globalpointids", "nodeid", "nodeids"};
constexpr std::array element_id_arrays{"globalelementid", "globalelementids", "globalcellids", "elementid",
                                       "elementids"};
constexpr std::array thickness_arrays{"thickness"};

constexpr std::int64_t vertex = 1, vertices = 2, quadratic_tetrahedron = 24;

std::string simplify(const std::string& name) {
  std::string simple;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') simple += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) simple += c;
  }
  return simple;
}

template <class Names>
const VtuArray* find_array(const std::vector<VtuArray>& arrays, const Names& names, bool of_integers) {
  for (const std::string_view name : names) {
    for (const VtuArray& array : arrays)
      if (simplify(array.name) == name && array.components == 1 && (array.has_integers() || !of_integers))
        return &array;
  }
  return nullptr;
}

std::optional<TopologyKind> find_kind_of_cell(std::int64_t type) {
  for (std::size_t kind = 0; kind < topology_count; ++kind)
    if (topologies[kind].vtk_type == type) return static_cast<TopologyKind>(kind);
  return type == quadratic_tetrahedron ? std::optional(TopologyKind::tet4) : std::nullopt;
}

Vec3 mean_of(const std::vector<Vec3>& points, std::span<const std::int64_t> numbers) {
  Vec3 mean{};
  for (const std::int64_t n : numbers)
    for (std::size_t k = 0; k < 3; ++k)
      mean[k] += points[static_cast<std::size_t>(n - 1)][k] / static_cast<double>(numbers.size());
  return mean;
}

/// Whether the second triangle of a wedge lies where the corners of the first run counter-clockwise. Writers do not
/// agree.
bool looks_along(const std::vector<Vec3>& points, std::span<const std::int64_t> wedge) {
  const Vec3 &a = points[static_cast<std::size_t>(wedge[0] - 1)], &b = points[static_cast<std::size_t>(wedge[1] - 1)],
             &c = points[static_cast<std::size_t>(wedge[2] - 1)];
  const Vec3 from = mean_of(points, wedge.first(3)), to = mean_of(points, wedge.last(3));
  double volume = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    volume += ((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])) * (to[k] - from[k]);
  }
  return volume >= 0;
}

class VtuReader {
 public:
  explicit VtuReader(const std::string& path) : source_(path, names_), scanner_(source_.text(), names_) {}

  std::unique_ptr<MeshFile> read() {
    read_tags();
    if (has_piece_) read_mesh();
    to_.kinds = "triangles, quadrilaterals, tetrahedra of four or ten nodes, pyramids, wedges, hexahedra and lines";
    return std::make_unique<TextMesh>(std::move(to_));
  }

  FileResults read_results(const ResultsWish& wish) {
    read_tags();
    if (!has_piece_) names_.refuse({0, 1}, "the file has no cells");
    read_mesh();
    FileResults results;
    results.blocks = to_.blocks;
    results.corners = to_.corners;
    results.element_ids = to_.element_ids;
    results.node_ids = to_.node_ids;
    std::vector<std::size_t> cells, points(point_count_);
    for (const Block& block : blocks_) cells.insert(cells.end(), block.cells.begin(), block.cells.end());
    std::iota(points.begin(), points.end(), std::size_t{0});
    for (const VtuArray& array : found_["CellData"])
      take_array({array, cell_count_, cells, wish.of_elements}, results.element_names, results.of_elements);
    for (const VtuArray& array : found_["PointData"])
      take_array({array, point_count_, points, wish.of_nodes}, results.node_names, results.of_nodes);
    for (auto& [name, column] : results.of_elements) column.is_lacking.assign(blocks_.size(), 0);
    return results;
  }

 private:
  /// An array of results with the places of its rows, in the order of the mesh.
  struct ArrayRows {
    const VtuArray& array;
    std::size_t count;
    const std::vector<std::size_t>& rows;
    const std::vector<std::string>& wish;
  };

  void take_array(const ArrayRows& of, std::vector<std::string>& names, std::map<std::string, ResultsColumn>& columns) {
    const std::vector<std::string> components = name_result_components(of.array.name, of.array.components);
    names.insert(names.end(), components.begin(), components.end());
    const auto is_wished = [&](const std::string& name) {
      return std::find(of.wish.begin(), of.wish.end(), name) != of.wish.end();
    };
    if (std::none_of(components.begin(), components.end(), is_wished)) return;
    const std::vector<double> values = arrays_.read_reals(of.array, of.count * components.size());
    for (std::size_t k = 0; k < components.size(); ++k) {
      if (!is_wished(components[k])) continue;
      ResultsColumn& column = columns[components[k]];
      column.values.clear();
      for (const std::size_t row : of.rows) column.values.push_back(values[row * components.size() + k]);
    }
  }

  void read_tags() {
    XmlTag tag;
    bool is_vtk = false;
    while (scanner_.next(tag)) {
      if (scanner_.open_tags().size() <= 1 && !tag.closes && !std::exchange(is_vtk, true) && tag.name != "VTKFile")
        names_.refuse(tag.place, fmt::format("the file begins with <{}> (<VTKFile> is expected)", tag.name));
      if (!tag.closes) read_tag(tag);
    }
    if (!is_vtk) names_.refuse({0, 1}, "the file has no <VTKFile>");
  }

  struct Cells {
    std::vector<std::int64_t> connectivity, offsets, types;
  };
  struct Block {
    FileBlock head;
    std::vector<std::int64_t> nodes, ids;
    std::vector<double> thicknesses;
    std::vector<std::size_t> cells;  // of the piece
  };

  void read_tag(const XmlTag& tag) {
    if (tag.name == "VTKFile") arrays_.read_file_tag(tag);
    if (tag.name == "AppendedData") arrays_.read_appended_tag(tag);
    if (tag.name == "Piece") read_piece(tag);
    if (tag.name != "DataArray" || !takes_arrays_) return;
    const auto& open = scanner_.open_tags();
    const std::string_view section = open.size() < 2 ? std::string_view() : open[open.size() - 2];
    if (section == "Points" || section == "Cells" || section == "PointData" || section == "CellData")
      found_[std::string(section)].push_back(arrays_.read_array_tag(tag));
  }

  /// Pieces without cells are passed over.
  void read_piece(const XmlTag& tag) {
    const auto count = [&](const char* key) {
      constexpr std::int64_t most = std::int64_t{1} << 40;
      const auto value = parse_integer(tag.attribute(key));
      if (!value || *value < 0 || *value > most)
        names_.refuse(tag.place,
                      fmt::format("{} is {} (a whole number is expected)", key, quote_field(tag.attribute(key))));
      return static_cast<std::size_t>(*value);
    };
    takes_arrays_ = count("NumberOfCells") > 0;
    if (!takes_arrays_) return;
    if (has_piece_) names_.refuse(tag.place, "the file has several pieces (one is read): merge them into one");
    has_piece_ = true;
    point_count_ = count("NumberOfPoints");
    cell_count_ = count("NumberOfCells");
    place_ = tag.place;
  }

  const VtuArray& find_of_cells(const char* name) {
    for (const VtuArray& array : found_["Cells"])
      if (array.name == name) return array;
    names_.refuse(place_, fmt::format("the piece has no array '{}' of its cells", name));
  }

  void read_points() {
    if (found_["Points"].empty()) names_.refuse(place_, "the piece has no array of points");
    const VtuArray& array = found_["Points"].front();
    if (array.components != 3 && array.components != 1)
      names_.refuse(array.place, fmt::format("points have {} components (3 are expected)", array.components));
    const std::vector<double> x = arrays_.read_reals(array, 3 * point_count_);
    to_.nodes.resize(point_count_);
    for (std::size_t n = 0; n < point_count_; ++n) to_.nodes[n] = {x[3 * n], x[3 * n + 1], x[3 * n + 2]};
    to_.node_ids = read_ids("PointData", node_id_arrays, point_count_);
  }

  /// Counted from 1 where the file gives none.
  template <class Names>
  std::vector<std::int64_t> read_ids(const char* section, const Names& names, std::size_t count) {
    if (const VtuArray* array = find_array(found_[section], names, true)) {
      known_.insert(array->name);
      return arrays_.read_integers(*array, count);
    }
    std::vector<std::int64_t> ids(count);
    for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<std::int64_t>(i) + 1;
    return ids;
  }

  Cells read_cells() {
    Cells cells;
    const VtuArray &offsets = find_of_cells("offsets"), &connectivity = find_of_cells("connectivity");
    cells.offsets = arrays_.read_integers(offsets, cell_count_);
    cells.types = arrays_.read_integers(find_of_cells("types"), cell_count_);
    std::int64_t last = 0;
    for (std::size_t e = 0; e < cell_count_; ++e) {
      if (cells.offsets[e] < last)
        names_.refuse(offsets.place, fmt::format("the offset of cell {} is below the one before", e));
      last = cells.offsets[e];
    }
    cells.connectivity = arrays_.read_integers(connectivity, static_cast<std::size_t>(last));
    if (point_count_ == 0 && last > 0) names_.refuse(connectivity.place, "cells have points, but the piece has none");
    for (std::int64_t& point : cells.connectivity) {
      if (point < 0 || static_cast<std::size_t>(point) >= point_count_)
        names_.refuse(connectivity.place,
                      fmt::format("a cell has point {} (there are the points 0 to {})", point, point_count_ - 1));
      ++point;
    }
    return cells;
  }

  int find_block(std::int64_t id, std::int64_t type, std::size_t nodes) {
    const auto [found, is_new] = block_numbers_.emplace(std::pair(id, type), static_cast<int>(blocks_.size()));
    if (!is_new) return found->second;
    FileBlock& head = blocks_.emplace_back().head;
    head.id = id;
    head.name = fmt::format("block_{}", id);
    head.topology = find_kind_of_cell(type);
    head.kind = head.topology ? std::string(find_topology(*head.topology).noun) : fmt::format("VTK cell type {}", type);
    head.nodes_per_element = head.topology ? static_cast<std::int64_t>(nodes) : 0;
    return found->second;
  }

  void add_cell(std::size_t cell, std::int64_t type, std::int64_t block_id, std::span<const std::int64_t> points) {
    const auto kind = find_kind_of_cell(type);
    const std::size_t expected = !kind ? 0
                                 : type == quadratic_tetrahedron
                                     ? tet10_nodes
                                     : static_cast<std::size_t>(find_topology(*kind).corner_count);
    if (kind && points.size() != expected)
      names_.refuse(
          place_, fmt::format("cell {} has {} points (a cell of type {} has {})", cell, points.size(), type, expected));
    Block& block = blocks_[static_cast<std::size_t>(find_block(block_id, type, points.size()))];
    if (!kind) return;
    const bool is_turned = *kind == TopologyKind::wedge6 && !looks_along(to_.nodes, points);
    for (std::size_t i = 0; i < points.size(); ++i)
      block.nodes.push_back(points[is_turned ? static_cast<std::size_t>(wedge6_topology.vtk_corners[i]) : i]);
  }

  void read_mesh() {
    read_points();
    const Cells cells = read_cells();
    std::vector<std::int64_t> ids = read_ids("CellData", element_id_arrays, cell_count_), block_ids(cell_count_, 1);
    if (const VtuArray* array = find_array(found_["CellData"], block_arrays, true)) {
      known_.insert(array->name);
      block_ids = arrays_.read_integers(*array, cell_count_);
    }
    std::vector<double> thicknesses;
    if (const VtuArray* array = find_array(found_["CellData"], thickness_arrays, false)) {
      known_.insert(array->name);
      thicknesses = arrays_.read_reals(*array, cell_count_);
    }
    std::size_t skipped = 0;
    for (std::size_t e = 0; e < cell_count_; ++e) {
      const auto first = static_cast<std::size_t>(e == 0 ? 0 : cells.offsets[e - 1]);
      const std::span points(cells.connectivity.data() + first, static_cast<std::size_t>(cells.offsets[e]) - first);
      const std::int64_t type = cells.types[e];
      skipped += type == vertex || type == vertices ? 1 : 0;
      if (type == vertex || type == vertices) continue;
      add_cell(e, type, block_ids[e], points);
      Block& block = blocks_[static_cast<std::size_t>(find_block(block_ids[e], type, points.size()))];
      block.ids.push_back(ids[e]);
      block.cells.push_back(e);
      const bool is_shell = block.head.topology && find_topology(*block.head.topology).is_surface();
      if (!thicknesses.empty() && is_shell) block.thicknesses.push_back(thicknesses[e]);
    }
    finish_blocks();
    note_arrays(skipped);
  }

  void finish_blocks() {
    for (Block& block : blocks_) {
      block.head.elements = static_cast<std::int64_t>(block.ids.size());
      block.head.first_element = static_cast<std::int64_t>(to_.element_ids.size()) + 1;
      to_.element_ids.insert(to_.element_ids.end(), block.ids.begin(), block.ids.end());
      to_.blocks.push_back(block.head);
      to_.corners.push_back(std::move(block.nodes));
      to_.thicknesses.push_back(std::move(block.thicknesses));
    }
  }

  void note_arrays(std::size_t skipped) {
    std::set<std::string> others;
    for (const char* section : {"PointData", "CellData"})
      for (const VtuArray& array : found_[section])
        if (!known_.contains(array.name)) others.insert(array.name);
    if (skipped > 0) to_.notes.push_back(fmt::format("{} cells that are points are left out", skipped));
    if (!others.empty()) to_.notes.push_back(describe_passed_over(others, ""));
  }

  TextNames names_;
  TextSource source_;
  XmlScanner scanner_;
  VtuArrays arrays_{names_};
  std::map<std::string, std::vector<VtuArray>> found_;  // by section
  std::set<std::string> known_;                         // names of arrays that are read
  std::size_t point_count_ = 0, cell_count_ = 0;
  TextPlace place_{0, 1};  // of the piece
  bool has_piece_ = false, takes_arrays_ = false;
  std::map<std::pair<std::int64_t, std::int64_t>, int> block_numbers_;  // by id and type of cells
  std::vector<Block> blocks_;
  TextContents to_;
};

}  // namespace

bool is_vtu_file(std::string_view first_bytes) { return first_bytes.find("<VTKFile") != std::string_view::npos; }

std::unique_ptr<MeshFile> open_vtu_file(const std::string& path) { return VtuReader(path).read(); }

FileResults read_vtu_results(const std::string& path, const ResultsWish& wish) {
  return VtuReader(path).read_results(wish);
}

}  // namespace percuss
