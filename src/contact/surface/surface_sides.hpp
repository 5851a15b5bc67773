#pragma once
// Faces around a node that lie on the same side of the surface: of a shell's two sides only one continues around a
// fold.
//
// A walk over shared edges: two faces on one side of a surface pass their common edge in opposite directions, for any
// angle between them. It ends where a shell ends and where more than two meet.

#include <array>
#include <vector>

#include "kernels/core/counting_sort.hpp"

namespace percuss {

/// The other faces, by face and corner (4 f + i), around the corner on the side of face f.
struct SideRings {
  std::vector<int> first;  // [4 faces + 1]
  std::vector<int> faces;
  std::vector<int> is_open;  // [4 faces] 1: a shell that ends there, at an edge that no other face has
};

/// corners: [faces][4] indexes of nodes, outward; -1: not here, then the rings of the face are short. offset: [faces]
/// half the thickness of shells, 0 of solids, of whose faces all around a node belong together. node_faces: faces
/// around each node, ascending.
SideRings find_side_rings(const std::vector<std::array<int, 4>>& corners, const std::vector<double>& offset,
                          const Buckets& node_faces);

}  // namespace percuss
