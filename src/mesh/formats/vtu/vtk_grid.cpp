#include "src/mesh/formats/vtu/vtk_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>

#include "src/mesh/files/unread_words.hpp"

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
const VtkArray* find_array(const std::vector<VtkArray>& arrays, const Names& names, bool of_integers) {
  for (const std::string_view name : names) {
    for (const VtkArray& array : arrays)
      if (simplify(array.name) == name && array.components == 1 && (array.has_integers || !of_integers)) return &array;
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

}  // namespace

VtkGridMesh::VtkGridMesh(const TextNames& names, const VtkGrid& grid) : names_(names), grid_(grid) {}

std::unique_ptr<MeshFile> VtkGridMesh::take_mesh() {
  read();
  to_.kinds = "triangles, quadrilaterals, tetrahedra of four or ten nodes, pyramids, wedges, hexahedra and lines";
  return std::make_unique<TextMesh>(std::move(to_));
}

FileResults VtkGridMesh::take_results(const ResultsWish& wish) {
  read();
  FileResults results;
  results.blocks = to_.blocks;
  results.corners = to_.corners;
  results.element_ids = to_.element_ids;
  results.node_ids = to_.node_ids;
  std::vector<std::size_t> cells, points(grid_.points.size());
  for (const Block& block : blocks_) cells.insert(cells.end(), block.cells.begin(), block.cells.end());
  std::iota(points.begin(), points.end(), std::size_t{0});
  for (const VtkArray& array : grid_.of_cells)
    take_array({array, grid_.cell_count(), cells, wish.of_elements}, results.element_names, results.of_elements);
  for (const VtkArray& array : grid_.of_points)
    take_array({array, grid_.points.size(), points, wish.of_nodes}, results.node_names, results.of_nodes);
  for (auto& [name, column] : results.of_elements) column.is_lacking.assign(blocks_.size(), 0);
  return results;
}

void VtkGridMesh::take_array(const ArrayRows& of, std::vector<std::string>& names,
                             std::map<std::string, ResultsColumn>& columns) {
  const std::vector<std::string> components = name_result_components(of.array.name, of.array.components);
  names.insert(names.end(), components.begin(), components.end());
  const auto is_wished = [&](const std::string& name) {
    return std::find(of.wish.begin(), of.wish.end(), name) != of.wish.end();
  };
  if (std::none_of(components.begin(), components.end(), is_wished)) return;
  const std::vector<double> values = of.array.read_reals(of.count * components.size());
  for (std::size_t k = 0; k < components.size(); ++k) {
    if (!is_wished(components[k])) continue;
    ResultsColumn& column = columns[components[k]];
    column.values.clear();
    for (const std::size_t row : of.rows) column.values.push_back(values[row * components.size() + k]);
  }
}

/// Counted from 1 where the file gives none.
template <class Names>
std::vector<std::int64_t> VtkGridMesh::read_ids(const std::vector<VtkArray>& arrays, const Names& names,
                                                std::size_t count) {
  if (const VtkArray* array = find_array(arrays, names, true)) {
    known_.insert(array->name);
    return array->read_integers(count);
  }
  std::vector<std::int64_t> ids(count);
  std::iota(ids.begin(), ids.end(), std::int64_t{1});
  return ids;
}

/// The points of all cells, counted from 1.
std::vector<std::int64_t> VtkGridMesh::number_points() const {
  std::int64_t last = 0;
  for (std::size_t e = 0; e < grid_.cell_count(); ++e) {
    if (grid_.ends[e] < last)
      names_.refuse(grid_.place, fmt::format("the offset of cell {} is below the one before", e));
    last = grid_.ends[e];
  }
  if (grid_.points.empty() && last > 0) names_.refuse(grid_.place, "cells have points, but the grid has none");
  std::vector<std::int64_t> numbers = grid_.connectivity;
  for (std::int64_t& point : numbers) {
    if (point < 0 || static_cast<std::size_t>(point) >= grid_.points.size())
      names_.refuse(grid_.place,
                    fmt::format("a cell has point {} (there are the points 0 to {})", point, grid_.points.size() - 1));
    ++point;
  }
  return numbers;
}

int VtkGridMesh::find_block(std::int64_t id, std::int64_t type, std::size_t nodes) {
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

void VtkGridMesh::add_cell(std::size_t cell, std::int64_t block_id, std::span<const std::int64_t> points) {
  const std::int64_t type = grid_.types[cell];
  const auto kind = find_kind_of_cell(type);
  const std::size_t expected = !kind ? 0
                               : type == quadratic_tetrahedron
                                   ? tet10_nodes
                                   : static_cast<std::size_t>(find_topology(*kind).corner_count);
  if (kind && points.size() != expected)
    names_.refuse(grid_.place,
                  fmt::format("cell {} has {} points (a cell of type {} has {})", cell, points.size(), type, expected));
  Block& block = blocks_[static_cast<std::size_t>(find_block(block_id, type, points.size()))];
  if (!kind) return;
  const bool is_turned = *kind == TopologyKind::wedge6 && !looks_along(to_.nodes, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    block.nodes.push_back(points[is_turned ? static_cast<std::size_t>(wedge6_topology.vtk_corners[i]) : i]);
}

void VtkGridMesh::read() {
  const std::size_t count = grid_.cell_count();
  to_.nodes = grid_.points;
  to_.node_ids = read_ids(grid_.of_points, node_id_arrays, grid_.points.size());
  const std::vector<std::int64_t> numbers = number_points();
  const std::vector<std::int64_t> ids = read_ids(grid_.of_cells, element_id_arrays, count);
  std::vector<std::int64_t> block_ids(count, 1);
  if (const VtkArray* array = find_array(grid_.of_cells, block_arrays, true)) {
    known_.insert(array->name);
    block_ids = array->read_integers(count);
  }
  std::vector<double> thicknesses;
  if (const VtkArray* array = find_array(grid_.of_cells, thickness_arrays, false)) {
    known_.insert(array->name);
    thicknesses = array->read_reals(count);
  }
  std::size_t skipped = 0;
  for (std::size_t e = 0; e < count; ++e) {
    const auto first = static_cast<std::size_t>(e == 0 ? 0 : grid_.ends[e - 1]);
    const std::span points(numbers.data() + first, static_cast<std::size_t>(grid_.ends[e]) - first);
    const std::int64_t type = grid_.types[e];
    skipped += type == vertex || type == vertices ? 1 : 0;
    if (type == vertex || type == vertices) continue;
    add_cell(e, block_ids[e], points);
    Block& block = blocks_[static_cast<std::size_t>(find_block(block_ids[e], type, points.size()))];
    block.ids.push_back(ids[e]);
    block.cells.push_back(e);
    const bool is_shell = block.head.topology && find_topology(*block.head.topology).is_surface();
    if (!thicknesses.empty() && is_shell) block.thicknesses.push_back(thicknesses[e]);
  }
  finish_blocks();
  note_arrays(skipped);
}

void VtkGridMesh::finish_blocks() {
  for (Block& block : blocks_)
    to_.add_block(block.head, block.ids, std::move(block.nodes), std::move(block.thicknesses));
}

void VtkGridMesh::note_arrays(std::size_t skipped) {
  std::set<std::string> others;
  for (const std::vector<VtkArray>* arrays : {&grid_.of_points, &grid_.of_cells})
    for (const VtkArray& array : *arrays)
      if (!known_.contains(array.name)) others.insert(array.name);
  if (skipped > 0) to_.notes.push_back(fmt::format("{} cells that are points are left out", skipped));
  if (!others.empty()) to_.notes.push_back(describe_unread(others, ""));
}

}  // namespace percuss
