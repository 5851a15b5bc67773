#pragma once
// The chunks that use each node, without a list of all nodes on any rank: home ranks own equal ranges of keys, and the
// home of a node receives all the chunks that use it.

#include <cstdint>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/item_exchange.hpp"
#include "comm/partition/graph_partition.hpp"

namespace percuss {

class NodeHomes {
 public:
  /// keys: [uses] nodes that chunks of this rank use, 0 <= key < key_count; chunks: [uses] by whom, a pair of both at
  /// most once on all ranks. Collective. Throws MpiError.
  NodeHomes(const Communicator& ranks, const std::vector<std::int64_t>& keys, const std::vector<int>& chunks,
            std::int64_t key_count);

  /// [uses] the lowest chunk that uses the node. Collective. Throws MpiError.
  std::vector<int> find_owners();

  /// Gives every use of a node the number that the use by its owner has; numbers: [uses], those of other uses do not
  /// count. Collective. Throws MpiError.
  std::vector<std::int64_t> share_numbers(const std::vector<std::int64_t>& numbers);

  /// Pairs of chunks that share nodes and how many, on rank 0; empty on the others. Collective. Throws MpiError.
  std::vector<GraphEdge> gather_edges();

 private:
  struct Use {
    std::int64_t key = 0;
    int chunk = 0;
    int place = 0;  // in what was received
  };

  template <class T>
  std::vector<T> send_back(const std::vector<T>& answers);
  std::vector<GraphEdge> count_shared() const;

  UnstructuredExchange exchange_;
  DataExchange data_;
  SendOrder order_;        // of the uses of this rank
  ExchangePlan plan_;      // to the homes
  std::vector<Use> uses_;  // of the nodes at home here, ascending by key and chunk
};

}  // namespace percuss
