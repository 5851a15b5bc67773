#pragma once
// What a decomposition over many ranks would be, found by one process.

#include <cstdint>
#include <vector>

#include "comm/graph_partition.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// A force of a halo slot on its way: three doubles.
inline constexpr std::int64_t halo_slot_bytes = 24;

/// What one rank would hold and send in every step.
struct RankPlan {
  int chunks = 0;
  std::int64_t elements = 0;
  std::int64_t nodes = 0;         // of its elements
  std::int64_t shared_nodes = 0;  // those that other ranks hold too
  int neighbours = 0;             // ranks that it shares nodes with
  std::int64_t slots_sent = 0;    // a chunk's contribution to a shared node, to every other rank that holds the node
  std::int64_t bytes_sent() const { return slots_sent * halo_slot_bytes; }
};

struct DecompositionPlan {
  Graph graph;          // of the chunks
  Partition partition;  // by which load_mesh() on so many ranks divides them
  std::vector<RankPlan> ranks;
};

/// The decomposition of the deck's mesh over `rank_count` ranks, without them. Takes memory for the whole mesh. MPI
/// must be up. Throws what load_mesh() throws.
DecompositionPlan plan_decomposition(const Deck& deck, int rank_count);

}  // namespace percuss
