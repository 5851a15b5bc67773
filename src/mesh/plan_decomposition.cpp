#include "src/mesh/plan_decomposition.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

#include "src/mesh/check_pieces.hpp"
#include "src/mesh/chunk_graph.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A slot: a chunk of this rank uses that node.
struct Slot {
  std::int64_t node = 0;
  int rank = 0;
};

/// All slots, node by node and rank by rank.
std::vector<Slot> list_slots(const ChunkPieces& pieces, const std::vector<std::int64_t>& numbers,
                             const std::vector<int>& ranks) {
  std::vector<Slot> slots;
  slots.reserve(numbers.size());
  for (std::size_t c = 0; c < pieces.chunks.size(); ++c) {
    for (int n = pieces.first_node[c]; n < pieces.first_node[c + 1]; ++n) {
      slots.push_back({numbers[at(n)], ranks[at(pieces.chunks[c])]});
    }
  }
  std::sort(slots.begin(), slots.end(),
            [](const Slot& a, const Slot& b) { return a.node != b.node ? a.node < b.node : a.rank < b.rank; });
  return slots;
}

/// What the slots of one node add to the ranks that hold it.
class NodeCount {
 public:
  NodeCount(std::vector<RankPlan>& ranks, std::vector<std::set<int>>& neighbours)
      : ranks_(ranks), neighbours_(neighbours) {}

  void add(const Slot& slot) {
    if (holders_.empty() || holders_.back() != slot.rank) {
      holders_.push_back(slot.rank);
      slots_.push_back(0);
    }
    ++slots_.back();
  }

  void end() {
    for (std::size_t h = 0; h < holders_.size(); ++h) {
      RankPlan& rank = ranks_[at(holders_[h])];
      ++rank.nodes;
      if (holders_.size() == 1) break;
      ++rank.shared_nodes;
      rank.slots_sent += slots_[h] * static_cast<std::int64_t>(holders_.size() - 1);
      for (const int other : holders_) {
        if (other != holders_[h]) neighbours_[at(holders_[h])].insert(other);
      }
    }
    holders_.clear();
    slots_.clear();
  }

 private:
  std::vector<RankPlan>& ranks_;
  std::vector<std::set<int>>& neighbours_;
  std::vector<int> holders_;         // ascending
  std::vector<std::int64_t> slots_;  // [holders]
};

}  // namespace

DecompositionPlan plan_decomposition(const Deck& deck, int rank_count) {
  const Communicator self(MPI_COMM_SELF);
  SceneParts scene = describe_parts(deck, self);
  const ChunkPieces pieces = make_pieces(scene, 0, 1);
  check_pieces(deck, self, pieces, scene);
  NumberedChunks numbered = number_chunks(deck, self, scene, pieces);

  DecompositionPlan plan;
  plan.graph = std::move(numbered.graph);
  plan.partition = partition_graph(plan.graph, rank_count);
  plan.ranks.resize(at(rank_count));
  const std::vector<int>& ranks = plan.partition.parts;
  for (std::size_t c = 0; c < ranks.size(); ++c) {
    ++plan.ranks[at(ranks[c])].chunks;
    plan.ranks[at(ranks[c])].elements += scene.first_element[c + 1] - scene.first_element[c];
  }
  std::vector<std::set<int>> neighbours(plan.ranks.size());
  NodeCount count(plan.ranks, neighbours);
  std::int64_t node = -1;
  for (const Slot& slot : list_slots(pieces, numbered.numbers, ranks)) {
    if (slot.node != node) count.end();
    node = slot.node;
    count.add(slot);
  }
  count.end();
  for (std::size_t r = 0; r < plan.ranks.size(); ++r) plan.ranks[r].neighbours = static_cast<int>(neighbours[r].size());
  return plan;
}

}  // namespace percuss
