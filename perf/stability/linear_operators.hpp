#pragma once
// Stiffness and damping matrices of the parts of a scene, found from the forces of the elements themselves.
//
// With the elements unstressed at positions X, a displacement e u in a step so long that no rate matters gives the
// force -e K u, and a velocity e u at X in a step of no length gives -e C u; central differences in e leave out what is
// of second order. No formula of an element is repeated here, so that every kind of element is measured alike.

#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// One part of the scene: n x n x n elements, degrees of freedom by node (z fastest) and direction.
struct LinearPart {
  double bound = 0;                        // smallest step bound of its elements
  std::vector<double> mass;                // [dofs]
  std::vector<double> stiffness, damping;  // [dofs x dofs] by column: force per displacement and per velocity
};

/// Where the nodes of the parts are and how they move, in place of what the deck says.
struct LinearShape {
  std::vector<Vec3> nodes;  // [(n + 1)^3] by part, the node (i, j, k) of its lattice at (i (n + 1) + j) (n + 1) + k
  double compression = 0;   // tr D = -3 compression in every element, about which damping is found
};

/// Every part of the deck is a box of side 1 at the origin with equal numbers of cells, at most 64 of them; shapes: one
/// a part. Throws what building the model throws.
std::vector<LinearPart> find_linear_parts(const Deck& deck, const std::vector<LinearShape>& shapes);

}  // namespace percuss
