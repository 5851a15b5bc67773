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
  bool are_counterparts = false;  // the second end is looked at as if its mean place were that of the first
};

struct NodePair {
  Item first, second;
};

/// The nodes of an end or a set on all ranks, ascending. own: those that this rank owns, in its share. Collective.
std::vector<Item> gather_nodes(const ChunkedMesh& chunked, const std::vector<int>& own);

/// An end, and the entry of the deck that it belongs to.
struct NamedEnd {
  std::string name;
  SpringEndDeck end;
};

/// [ends] the nodes of each, ascending; the same on all ranks. kind: as for find_node_pairs(). Collective. Throws
/// InputError with the deck's place, the same on all ranks.
std::vector<std::vector<Item>> find_end_nodes(const Deck& deck, const ChunkedMesh& chunked,
                                              const std::vector<NamedEnd>& ends, const std::string& kind);

/// Each of the first nodes with the nearest of the second ones, as are_counterparts of PairOfEnds says. place, entry:
/// of the deck, for messages. Collective. Throws as find_node_pairs() does.
std::vector<NodePair> pair_nodes(const ChunkedMesh& chunked, const PairOfEnds& entry, const std::string& place,
                                 const std::string& kind, const std::array<std::vector<Item>, 2>& nodes);

/// [entries] the pairs of each, in the order of their first nodes; the same on all ranks. kind: what messages call an
/// entry ("spring"). Collective. Throws InputError with the deck's place, the same on all ranks: counterparts must be
/// as many, each of one node.
std::vector<std::vector<NodePair>> find_node_pairs(const Deck& deck, const ChunkedMesh& chunked,
                                                   const std::vector<PairOfEnds>& entries, const std::string& kind);

}  // namespace percuss
