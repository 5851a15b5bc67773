#pragma once
// Nodes that parts have in common: those of one mesh file, and those that `join` of the deck merges because they lie at
// one place. All that follows knows nodes by keys, so that a joint is a list of keys that are one node.

#include "src/deck/deck.hpp"
#include "src/mesh/parts/scene_parts.hpp"

namespace percuss {

/// Share of the diagonal of the joined parts that `join` takes for its tolerance if the deck gives none.
inline constexpr double join_share = 1e-6;

/// Fills scene.joined and scene.joints, the same on every rank; every part has its keys. A merged node has the place
/// and the id of the one with the lowest key. Nothing is done for a deck whose parts share nothing. Throws InputError,
/// on every rank, if a joint merges nothing of one of its parts or two nodes of one part. Collective.
void join_parts(const Deck& deck, const Communicator& ranks, SceneParts& scene);

}  // namespace percuss
