#pragma once
// Keys of one node or element, by its place or its id.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// The nearest to a place or the one with an id, maybe only of a part.
Keys<HistoryPoint> point_keys();

/// Checks that a point has one of near and id. Notes its place in the deck.
bool check_point(const Reader& reader, const Node& node, HistoryPoint& point);

}  // namespace percuss
