#pragma once
// Who may touch whom: the deck's named surfaces as classes of nodes and faces and a table of pairs.

#include <array>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// A class is one combination of named surfaces on which nodes or faces lie together.
struct SurfacePairs {
  int num_classes = 1;
  std::vector<int> node_class;   // by contact node
  std::vector<int> face_class;   // by contact face
  std::vector<double> friction;  // [classes of nodes * classes of faces]; -1: may not touch
};

/// faces: the contact faces; corners: their corners as contact nodes. Throws InputError for unknown surfaces.
SurfacePairs find_surface_pairs(const Mesh& mesh, const Deck& deck, const std::vector<ElementFace>& faces,
                                const std::vector<std::array<int, 4>>& corners, std::size_t num_nodes);

}  // namespace percuss
