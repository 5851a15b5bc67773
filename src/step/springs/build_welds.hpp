#pragma once
// Welds from the deck to the model.

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds the nodes of all welds. Call when the rigid bodies of the model are built. Collective. Throws InputError with
/// the deck's place, the same on all ranks: ends without nodes, nodes of rigid bodies, a weld whose direction is
/// needed and not given.
void build_welds(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
