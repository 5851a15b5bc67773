#pragma once
// Nodes that several ranks hold as carbon copies (section 3 of the paper), found from global node ids alone.
//
// No rank holds a list of all nodes. Ids are dealt to home ranks in equal ranges; each home tells the holders of an id
// about each other.

#include <cstdint>
#include <vector>

#include "comm/exchange/unstructured_exchange.hpp"

namespace percuss {

/// The nodes that this rank shares, neighbour by neighbour; const after set-up.
struct SharedNodes {
  std::vector<int> ranks;   // [neighbours] ascending: those that hold a node of this rank too
  std::vector<int> first;   // [neighbours + 1] into nodes
  std::vector<int> nodes;   // local nodes shared with a neighbour, in ascending global id: the same order on both sides
  std::vector<int> owners;  // [local nodes] lowest rank that holds the node; callers with other owners put theirs
};

/// Finds who shares what. node_ids: [local nodes] global ids, none negative, each at most once on a rank. Collective.
/// Throws MpiError.
SharedNodes find_shared_nodes(UnstructuredExchange& exchange, const std::vector<std::int64_t>& node_ids);

}  // namespace percuss
