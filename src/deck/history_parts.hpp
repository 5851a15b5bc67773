#pragma once
// Parts with their own energies in the history, beside the points that it follows.

#include "src/deck/deck.hpp"

namespace percuss {

/// Whether a point of the deck is not a node or an element, which have a place or an id, but its part, or every part.
inline bool names_parts(const HistoryPoint& point) { return !point.near && !point.id; }

}  // namespace percuss
