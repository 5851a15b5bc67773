#pragma once
// `place` of the deck: parts that are turned until a corner, an edge or a face of them is lowest, and moved until they
// rest on a wall or on another part.

#include "src/deck/deck.hpp"
#include "src/mesh/parts/scene_parts.hpp"

namespace percuss {

/// Moves the parts of each entry of Deck::placements, in their order, and notes where they went. Rank 0 finds the
/// motion, all have its bits. Nothing is done where a part is wrong, which is reported later. Throws InputError, on
/// every rank: sets that do not exist, directions that lead past the wall or the part. Collective.
void place_groups(const Deck& deck, const Communicator& ranks, SceneParts& scene);

}  // namespace percuss
