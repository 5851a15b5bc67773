#pragma once
// Parts that come from one mesh: they name the same file, and stand in the same place. They share its nodes and its
// ids.

#include <cstddef>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/parts/scene_parts.hpp"

namespace percuss {

/// [parts] the first part of the same mesh; of a part that shares none the part itself.
std::vector<std::size_t> find_first_sharers(const Deck& deck);

/// Gives each part its ids. Those of files are raised where an earlier mesh has them; parts of one mesh keep the same
/// ids for the nodes that they share. Rank 0 alone. An element that two parts have is an error of the later one.
void assign_ids(const Deck& deck, SceneParts& scene);

}  // namespace percuss
