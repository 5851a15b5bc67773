#pragma once
// The nodes that springs or welds connect: every node of the first end, and the nearest node of the second.

#include <array>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/nearest_items.hpp"

namespace percuss {

/// The ends of an entry of the deck.
struct PairOfEnds {
  std::string name;
  std::array<SpringEndDeck, 2> between;
  Place place;
};

struct NodePair {
  Item first, second;
};

/// [entries] the pairs of each, in the order of their first nodes; the same on all ranks. kind: what messages call an
/// entry ("spring"). Collective. Throws InputError with the deck's place, the same on all ranks.
std::vector<std::vector<NodePair>> find_node_pairs(const Deck& deck, const ChunkedMesh& chunked,
                                                   const std::vector<PairOfEnds>& entries, const std::string& kind);

}  // namespace percuss
