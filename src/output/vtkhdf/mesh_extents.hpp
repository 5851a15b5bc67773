#pragma once
// Where each part of the mesh lies in the datasets of fields.vtkhdf, and what they hold of its elements.
//
// Elements and nodes are numbered chunk after chunk and part after part, so a part is one run of elements and of
// corners in Connectivity, and of nodes, if it shares none. The run of a part that shares nodes is from its first to
// its last.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Runs of rows that belong together: a part, or the whole mesh.
struct MeshExtent {
  std::int64_t first_node = 0, nodes = 0;
  std::int64_t first_element = 0, elements = 0;
  std::array<std::int64_t, topology_count> of_topology{};  // of the elements
  std::int64_t first_corner = 0;                           // row in Connectivity
  std::int64_t first_mixed = 0;                            // place in list_mixed_topology() of all

  std::int64_t corners() const {
    std::int64_t count = 0;
    for (std::size_t k = 0; k < topology_count; ++k) count += topologies[k].corner_count * of_topology[k];
    return count;
  }
  /// Numbers of list_mixed_topology().
  std::int64_t mixed_size() const {
    std::int64_t count = corners() + elements;
    for (std::size_t k = 0; k < topology_count; ++k) count += topologies[k].is_line() ? of_topology[k] : 0;
    return count;
  }
  /// Whether there are elements of several topologies.
  bool is_mixed() const {
    return std::count_if(of_topology.begin(), of_topology.end(), [](auto count) { return count > 0; }) > 1;
  }
};

/// [parts] of the whole mesh, the same on every rank. Collective. Throws MpiError.
std::vector<MeshExtent> find_part_extents(const ChunkedMesh& chunked, const Communicator& ranks);

/// All parts together.
MeshExtent join_extents(const std::vector<MeshExtent>& parts);

/// Numbers of an element on its way to the rank that writes it: its topology, then its corners as they are numbered in
/// the whole mesh.
inline constexpr std::size_t cell_row = 1 + most_corners;

/// [elements][cell_row] of this rank.
std::vector<std::int64_t> list_cell_rows(const Mesh& mesh);

/// Cells of a run of elements, their corners in the order of VTK.
struct Cells {
  std::vector<std::int64_t> corners, ends;  // ends: place behind the corners of each element, from the block's first
  std::vector<TopologyKind> kinds;

  std::vector<std::uint8_t> list_vtk_types() const {
    std::vector<std::uint8_t> types;
    for (const TopologyKind kind : kinds) types.push_back(find_topology(kind).vtk_type);
    return types;
  }
};

/// rows: [elements][cell_row]
Cells list_cells(std::span<const std::int64_t> rows);

/// Cells as XDMF wants those of several kinds: each begins with its type, a line also with the number of its nodes.
std::vector<std::int64_t> list_mixed_topology(const Cells& cells);

}  // namespace percuss
