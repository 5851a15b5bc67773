#pragma once
// Nodes embedded in solids, from the deck to the model.

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds the solid of each node and the weights of its corners. Call when the rigid bodies, the welds and the
/// constraints of the model are built. Collective. Throws InputError with the deck's place, the same on all ranks:
/// hosts without solids, entries of which no node is within a solid, nodes that something else moves.
void build_embedded(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
