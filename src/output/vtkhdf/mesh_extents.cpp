#include "src/output/vtkhdf/mesh_extents.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "comm/all_reduce.hpp"

namespace percuss {
namespace {

/// Nodes of elements of parts that share some: from the lowest to the highest number.
void widen_to_joints(const ChunkedMesh& chunked, const Communicator& ranks, std::vector<MeshExtent>& extents) {
  const Mesh& mesh = chunked.mesh;
  std::vector<std::int64_t> lowest(extents.size(), std::numeric_limits<std::int64_t>::max()), negative(lowest);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto part = static_cast<std::size_t>(mesh.part_of(e));
    for (const int node : mesh.corners(e)) {
      const std::int64_t number = mesh.node_numbers[static_cast<std::size_t>(node)];
      lowest[part] = std::min(lowest[part], number);
      negative[part] = std::min(negative[part], -number);
    }
  }
  all_reduce(ranks, Reduce::least, lowest);
  all_reduce(ranks, Reduce::least, negative);
  for (std::size_t p = 0; p < extents.size(); ++p) {
    extents[p].first_node = lowest[p];
    extents[p].nodes = 1 - negative[p] - lowest[p];
  }
}

}  // namespace

std::vector<MeshExtent> find_part_extents(const ChunkedMesh& chunked, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  std::vector<std::int64_t> counts(topology_count * mesh.parts.size());  // elements of each part, by topology
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const ElementBlock& block = mesh.block_of(e);
    ++counts[topology_count * static_cast<std::size_t>(block.part) + static_cast<std::size_t>(block.topology)];
  }
  all_reduce(ranks, Reduce::sum, counts);
  const Numbering& numbering = chunked.numbering;
  std::vector<MeshExtent> extents(mesh.parts.size());
  MeshExtent before;
  for (std::size_t p = 0; p < extents.size(); ++p) {
    MeshExtent& part = extents[p];
    part.first_element = before.first_element + before.elements;
    part.first_node = before.first_node + before.nodes;
    part.first_corner = before.first_corner + before.corners();
    part.first_mixed = before.first_mixed + before.mixed_size();
    std::copy_n(&counts[topology_count * p], topology_count, part.of_topology.begin());
    part.elements = std::accumulate(part.of_topology.begin(), part.of_topology.end(), std::int64_t{0});
    // The first chunk of the next part begins where this one ends.
    const auto& first = numbering.first_element;
    const auto end = std::lower_bound(first.begin(), first.end(), part.first_element + part.elements) - first.begin();
    part.nodes = numbering.first_node[static_cast<std::size_t>(end)] - part.first_node;
    before = part;
  }
  if (!mesh.joints.empty()) widen_to_joints(chunked, ranks, extents);
  return extents;
}

MeshExtent join_extents(const std::vector<MeshExtent>& parts) {
  MeshExtent all;
  for (const MeshExtent& part : parts) {
    all.nodes = std::max(all.nodes, part.first_node + part.nodes);
    all.elements += part.elements;
    for (std::size_t k = 0; k < topology_count; ++k) all.of_topology[k] += part.of_topology[k];
  }
  return all;
}

std::vector<std::int64_t> list_cell_rows(const Mesh& mesh) {
  std::vector<std::int64_t> rows(cell_row * mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    auto entry = rows.begin() + static_cast<std::ptrdiff_t>(cell_row * e);
    *entry++ = static_cast<std::int64_t>(mesh.block_of(e).topology);
    for (const int node : mesh.corners(e)) *entry++ = mesh.node_numbers[static_cast<std::size_t>(node)];
  }
  return rows;
}

Cells list_cells(std::span<const std::int64_t> rows) {
  Cells cells;
  for (std::size_t first = 0; first < rows.size(); first += cell_row) {
    cells.kinds.push_back(static_cast<TopologyKind>(rows[first]));
    const Topology& topology = find_topology(cells.kinds.back());
    for (std::size_t c = 0; c < static_cast<std::size_t>(topology.corner_count); ++c)
      cells.corners.push_back(rows[first + 1 + static_cast<std::size_t>(topology.vtk_corners[c])]);
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
  }
  return cells;
}

std::vector<std::int64_t> list_mixed_topology(const Cells& cells) {
  std::vector<std::int64_t> topology;
  std::int64_t first = 0;
  for (std::size_t e = 0; e < cells.kinds.size(); ++e) {
    topology.push_back(find_topology(cells.kinds[e]).xdmf_type);
    if (find_topology(cells.kinds[e]).is_line()) topology.push_back(cells.ends[e] - first);
    topology.insert(topology.end(), cells.corners.begin() + first, cells.corners.begin() + cells.ends[e]);
    first = cells.ends[e];
  }
  return topology;
}

}  // namespace percuss
