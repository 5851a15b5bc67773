#pragma once
// The glue of a scene: which node is glued to which face, by the ties of the deck that are cohesive.

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Builds Model::glue, with slots after all others. Throws InputError, on all ranks, as find_ties() does, for too many
/// nodes, and for nodes in the middle of a shell. Collective.
void build_glue(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model);

/// Glue lies half a shell off the nodes of side a that can turn, and at the others. Call when inertia and rigid bodies
/// of the model are built. Collective.
void move_glue_off_nodes(Model& model);

}  // namespace percuss
