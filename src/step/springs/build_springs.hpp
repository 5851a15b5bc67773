#pragma once
// Springs of a model, from the deck and the mesh.

#include "comm/halo/halo_plan.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds the springs of the deck: every node of a first end with the nearest node of the second, in the order of the
/// deck and then of the first node in the whole mesh. The same on all ranks. Collective. Throws InputError with the
/// deck's place, the same on all ranks: unknown sets or ids, distances that overflow, a spring between a node and
/// itself, two springs of one name, too many springs.
SpringModel find_springs(const Deck& deck, const ChunkedMesh& chunked);

/// Builds springs, and gives each of their nodes that this rank owns a slot, after those of loads on nodes, at the end
/// of `slots` and of the sum of the node.
void build_springs(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model);

}  // namespace percuss
