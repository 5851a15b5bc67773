#pragma once
// Constraints from the deck to the model.

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds the nodes of all constraints and the groups that move equally. Call when the rigid bodies, the welds and the
/// held directions of the model are built. Collective. Throws InputError with the deck's place, the same on all ranks:
/// sides that are no counterparts, nodes of rigid bodies, welded nodes, nodes that are held to differ.
void build_constraints(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
