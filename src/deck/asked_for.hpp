#pragma once
// What a deck requests, where several stages request it.

#include <algorithm>
#include <array>

#include "src/deck/deck.hpp"

namespace percuss {

/// Directions of conditions, loads and motions, in the order of ConditionDeck::active.
inline constexpr std::array<const char*, 6> direction_names{"x", "y", "z", "rx", "ry", "rz"};

/// Whether a point of the deck is not a node or an element, which have a place or an id, but its part, or every part.
inline bool names_parts(const HistoryPoint& point) { return !point.near && !point.id; }

/// Whether elements of a part, or of any part, can fail.
inline bool can_fail(const Deck& deck, const PartDeck& part) {
  return !part.rigid && std::any_of(deck.materials.begin(), deck.materials.end(), [&](const MaterialDeck& material) {
    return material.name == part.material && material.failure.has_value();
  });
}
inline bool can_fail(const Deck& deck) {
  return std::any_of(deck.materials.begin(), deck.materials.end(),
                     [](const MaterialDeck& material) { return material.failure.has_value(); });
}

}  // namespace percuss
