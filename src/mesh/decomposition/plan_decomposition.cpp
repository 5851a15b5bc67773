#include "src/mesh/decomposition/plan_decomposition.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "kernels/core/counting_sort.hpp"
#include "src/index.hpp"
#include "src/mesh/decomposition/chunk_graph.hpp"
#include "src/mesh/pieces/check_pieces.hpp"
#include "src/mesh/pieces/join_pieces.hpp"

namespace percuss {
namespace {

/// Adds up what the slots of one node after the other mean for the ranks that hold it.
class NodeCount {
 public:
  explicit NodeCount(std::vector<RankPlan>& ranks)
      : ranks_(ranks), neighbours_(ranks.size()), receivers_(ranks.size()) {}

  /// ranks: of each slot of a node; the first is that of the lowest chunk, which owns the node.
  void add(std::vector<int>& ranks) {
    const int owner = ranks.front();
    std::sort(ranks.begin(), ranks.end());
    holders_ = ranks;
    holders_.erase(std::unique(holders_.begin(), holders_.end()), holders_.end());
    for (const int holder : holders_) ++ranks_[at(holder)].nodes;
    if (holders_.size() == 1) return;
    const auto others = static_cast<std::int64_t>(holders_.size()) - 1;
    for (const int rank : ranks) ranks_[at(rank)].slots_sent += others;
    ranks_[at(owner)].copies_sent += others;
    for (const int holder : holders_) {
      ++ranks_[at(holder)].shared_nodes;
      for (const int other : holders_) {
        if (other != holder) neighbours_[at(holder)].insert(other);
      }
      if (holder != owner) receivers_[at(owner)].insert(holder);
    }
  }

  void end() {
    for (std::size_t r = 0; r < ranks_.size(); ++r) {
      ranks_[r].neighbours = static_cast<int>(neighbours_[r].size());
      ranks_[r].copy_receivers = static_cast<int>(receivers_[r].size());
    }
  }

 private:
  std::vector<RankPlan>& ranks_;
  std::vector<std::set<int>> neighbours_, receivers_;
  std::vector<int> holders_;  // ascending
};

}  // namespace

DecompositionPlanner::DecompositionPlanner(const Deck& deck) {
  const Communicator self(MPI_COMM_SELF);
  SceneParts scene = describe_parts(deck, self);
  ChunkPieces pieces = make_pieces(scene, 0, 1);
  join_pieces(self, scene, pieces);
  check_pieces(deck, self, pieces, scene);
  NumberedChunks numbered = number_chunks(deck, self, scene, pieces);
  graph_ = std::move(numbered.graph);
  work_ = std::move(numbered.work);
  elements_.resize(at(scene.chunk_count()));
  for (std::size_t c = 0; c < elements_.size(); ++c) {
    elements_[c] = scene.first_element[c + 1] - scene.first_element[c];
  }
  // Ascending, and so are the chunks of each node.
  BucketsOf<int, std::int64_t> uses =
      collect_buckets<int, std::int64_t>(static_cast<std::size_t>(numbered.numbering.node_count()), [&](auto&& put) {
        for (std::size_t c = 0; c < pieces.chunks.size(); ++c)
          for (int n = pieces.first_node[c]; n < pieces.first_node[c + 1]; ++n)
            put(static_cast<std::size_t>(numbered.numbers[at(n)]), pieces.chunks[c]);
      });
  first_use_ = std::move(uses.first);
  chunks_ = std::move(uses.items);
}

DecompositionPlan DecompositionPlanner::plan(int rank_count) const {
  DecompositionPlan plan;
  plan.partition = partition_graph(graph_, rank_count);
  plan.ranks.resize(at(rank_count));
  const std::vector<int>& ranks = plan.partition.parts;
  for (std::size_t c = 0; c < ranks.size(); ++c) {
    ++plan.ranks[at(ranks[c])].chunks;
    plan.ranks[at(ranks[c])].elements += elements_[c];
    plan.ranks[at(ranks[c])].work += work_[c];
  }
  NodeCount count(plan.ranks);
  std::vector<int> slots;
  for (std::size_t n = 0; n + 1 < first_use_.size(); ++n) {
    slots.clear();
    for (auto i = first_use_[n]; i < first_use_[n + 1]; ++i) {
      slots.push_back(ranks[at(chunks_[static_cast<std::size_t>(i)])]);
    }
    count.add(slots);
  }
  count.end();
  return plan;
}

DecompositionPlan plan_decomposition(const Deck& deck, int rank_count) {
  return DecompositionPlanner(deck).plan(rank_count);
}

}  // namespace percuss
