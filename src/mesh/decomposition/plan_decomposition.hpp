#pragma once
// What a decomposition over many ranks would be, found by one process.

#include <cstdint>
#include <vector>

#include "comm/partition/graph_partition.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// A force of a halo slot on its way: three doubles.
inline constexpr std::int64_t halo_slot_bytes = 24;

/// Elements, nodes and messages of one planned rank.
struct RankPlan {
  int chunks = 0;
  std::int64_t elements = 0;
  std::int64_t work = 0;          // of its elements, on the scale of hexahedron_cost
  std::int64_t nodes = 0;         // of its elements
  std::int64_t shared_nodes = 0;  // nodes that other ranks hold too
  int neighbours = 0;             // ranks that it shares nodes with
  std::int64_t slots_sent = 0;    // a chunk's contribution to a shared node, to every other rank that holds the node
  std::int64_t copies_sent = 0;   // a shared node that it owns, to every other rank that holds the node
  int copy_receivers = 0;         // ranks that hold shared nodes that it owns
  std::int64_t bytes_sent() const { return slots_sent * halo_slot_bytes; }
};

struct DecompositionPlan {
  Partition partition;  // by which load_mesh() on so many ranks divides the chunks
  std::vector<RankPlan> ranks;
};

/// The chunks of a scene and who uses which node: made once, for plans of any number of ranks.
class DecompositionPlanner {
 public:
  /// Takes memory for the whole mesh while it is made. MPI must be up. Throws what load_mesh() throws.
  explicit DecompositionPlanner(const Deck& deck);

  /// The decomposition of the mesh over `rank_count` ranks, without them.
  DecompositionPlan plan(int rank_count) const;

  const Graph& graph() const { return graph_; }  // of the chunks

 private:
  Graph graph_;
  std::vector<std::int64_t> elements_, work_;  // [chunks]
  std::vector<std::int64_t> first_use_;        // [nodes + 1] into chunks_
  std::vector<int> chunks_;                    // that use each node, ascending: a slot each
};

/// One plan alone.
DecompositionPlan plan_decomposition(const Deck& deck, int rank_count);

}  // namespace percuss
