#pragma once
// Where each part of the mesh lies in the datasets of fields.vtkhdf.
//
// Elements and nodes are numbered chunk after chunk and part after part, and parts share no node, so a part is one run
// of elements, of corners in Connectivity and of nodes.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Runs of rows that belong together: a part, or the whole mesh.
struct MeshExtent {
  std::int64_t first_node = 0, nodes = 0;
  std::int64_t first_element = 0, elements = 0;
  std::int64_t shells = 0, triangles = 0;  // of the elements; triangles are shells too
  std::int64_t first_corner = 0;           // row in Connectivity

  std::int64_t corners() const { return 8 * elements - 4 * shells - triangles; }
  /// Whether there are elements of several kinds: hexahedra, quadrilaterals, triangles.
  bool is_mixed() const { return (shells > 0 && shells < elements) || (triangles > 0 && triangles < elements); }
};

/// [parts] of the whole mesh, the same on every rank. Collective. Throws MpiError.
std::vector<MeshExtent> find_part_extents(const ChunkedMesh& chunked, const Communicator& ranks);

/// All parts together.
MeshExtent join_extents(const std::vector<MeshExtent>& parts);

}  // namespace percuss
