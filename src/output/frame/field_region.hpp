#pragma once
// What an output of fields shows of the mesh, as a mesh of its own: some elements, or faces as surface elements.
//
// Files are written of it as of any mesh. Nodes and elements keep their order, chunks and owners, so that the files do
// not depend on the number of ranks, and a node has the values that its owner has. A rank may own nodes that only
// elements of other ranks use.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

struct FieldRegion {
  /// Mesh of this rank: numbers of nodes and elements, parts and sets are those of the region. Chunks keep their
  /// numbers; one without elements is not among them.
  ChunkedMesh chunked;
  std::vector<int> nodes;     // [nodes] each in this rank's share of the whole mesh, ascending
  std::vector<int> elements;  // [elements] likewise; of a face that to which it belongs
  bool are_faces = false;     // whether several elements may have the same id
};

/// An element of a region.
struct RegionCell {
  int element = 0;  // in this rank's share of the whole mesh
  TopologyKind topology{};
  std::array<int, most_corners> corners{};  // as many as the topology has

  std::span<const int> nodes() const {
    return {corners.data(), static_cast<std::size_t>(find_topology(topology).corner_count)};
  }
};

/// Elements that are marked. marks: [elements]
std::vector<RegionCell> list_marked_cells(const Mesh& mesh, std::span<const char> marks);

/// Faces as quadrilaterals and triangles; a shell once, whichever of its faces are given. faces: ascending, unique.
std::vector<RegionCell> list_face_cells(const Mesh& mesh, std::span<const ElementFace> faces);

/// The region of these cells, ascending by element; some rank must have one. Collective. Throws MpiError.
std::unique_ptr<FieldRegion> make_field_region(const ChunkedMesh& whole, std::span<const RegionCell> cells,
                                               const Communicator& ranks);

}  // namespace percuss
