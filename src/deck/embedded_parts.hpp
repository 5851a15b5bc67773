#pragma once
// Parts that are embedded in solids.

#include <algorithm>
#include <string>

#include "src/deck/deck.hpp"

namespace percuss {

/// Whether an entry of `embedded` names a part as a whole.
inline bool is_embedded(const Deck& deck, const std::string& part) {
  return std::any_of(deck.embedded.begin(), deck.embedded.end(), [&](const EmbeddedDeck& embedded) {
    return !embedded.nodes.inside && embedded.nodes.name == part;
  });
}

}  // namespace percuss
