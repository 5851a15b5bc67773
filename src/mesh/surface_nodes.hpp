#pragma once
// What a selector means where the nodes of a surface count: those of faces, or a set of nodes as the edge of a shell.

#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

struct SurfaceNodes {
  std::vector<int> nodes;          // ascending
  std::vector<ElementFace> faces;  // exterior, ascending: those selected, or around the nodes of a set
  bool is_node_set = false;
};

/// Faces that the selector means, with their corners; if it names a set of nodes alone, these with the exterior faces
/// around them. Throws InputError as select_faces() and select_nodes() do. Collective over Mesh::ranks.
SurfaceNodes select_surface_nodes(const Mesh& mesh, const Deck& deck, const Selector& selector);

}  // namespace percuss
