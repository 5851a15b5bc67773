// The halo on random chunks: sums over nodes have the bits of one rank that holds everything.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "comm/halo/halo_plan.hpp"
#include "comm/halo/halo_swap.hpp"
#include "comm/halo/node_copies.hpp"
#include "kernels/core/views.hpp"
#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

/// Chunks of a make-believe mesh: each has nodes, each node of a chunk a slot with a force.
struct Chunks {
  std::vector<std::vector<int>> nodes;  // [chunks] global nodes, distinct
  std::vector<int> ranks;               // [chunks]
  int node_count = 0;
};

Chunks make_chunks(int rank_count, std::uint64_t seed) {
  Random random(seed);
  Chunks chunks;
  chunks.node_count = 200;
  for (int c = 0; c < 40; ++c) {
    std::vector<int> nodes;
    const int middle = random.below(chunks.node_count);
    for (int i = 0; i < 20; ++i) nodes.push_back((middle + random.below(40)) % chunks.node_count);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    chunks.nodes.push_back(nodes);
    chunks.ranks.push_back(random.below(rank_count));
  }
  return chunks;
}

/// Force of a slot: numbers of very different size, so that another order of addition shows in the bits.
double find_force(int chunk, int node, int direction) {
  Random random(static_cast<std::uint64_t>(chunk * 1'000'000 + node * 10 + direction));
  return random.between(-1, 1) * std::pow(10.0, random.below(12));
}

/// The force of every node, as one rank adds it up: by ascending chunk.
std::vector<std::array<double, 3>> add_serially(const Chunks& chunks) {
  std::vector<std::array<double, 3>> forces(static_cast<std::size_t>(chunks.node_count), {0, 0, 0});
  for (std::size_t c = 0; c < chunks.nodes.size(); ++c) {
    for (const int node : chunks.nodes[c]) {
      for (int k = 0; k < 3; ++k)
        forces[static_cast<std::size_t>(node)][static_cast<std::size_t>(k)] += find_force(static_cast<int>(c), node, k);
    }
  }
  return forces;
}

/// What one rank has: its chunks in ascending order, its nodes by first use.
struct RankPart {
  std::vector<std::int64_t> node_ids;
  LocalSlots slots;
  std::vector<int> first_slot{0};  // [local chunks + 1]
  std::vector<int> chunk_ids;      // [local chunks]
};

RankPart take_part(const Chunks& chunks, int rank) {
  RankPart part;
  std::map<int, int> local;
  for (std::size_t c = 0; c < chunks.nodes.size(); ++c) {
    if (chunks.ranks[c] != rank) continue;
    for (const int node : chunks.nodes[c]) {
      const auto [place, is_new] = local.emplace(node, static_cast<int>(part.node_ids.size()));
      if (is_new) part.node_ids.push_back(node);
      part.slots.nodes.push_back(place->second);
      part.slots.orders.push_back(static_cast<std::int64_t>(c));
    }
    part.first_slot.push_back(static_cast<int>(part.slots.nodes.size()));
    part.chunk_ids.push_back(static_cast<int>(c));
  }
  return part;
}

/// Slot forces with the remote part spoilt.
Rows3<double> fill_slots(const RankPart& part, const HaloPlan& plan) {
  const Rows3<double> values("slots", static_cast<std::size_t>(plan.slot_count()));
  const auto host = Kokkos::create_mirror_view(values);
  Kokkos::deep_copy(host, std::nan(""));
  for (std::size_t s = 0; s < part.slots.nodes.size(); ++s) {
    for (int k = 0; k < 3; ++k) {
      const auto node = part.node_ids[static_cast<std::size_t>(part.slots.nodes[s])];
      host(s, k) = find_force(static_cast<int>(part.slots.orders[s]), static_cast<int>(node), k);
    }
  }
  Kokkos::deep_copy(values, host);
  return values;
}

double add_slots(const SlotLists& lists, const HostMirror<Rows3<double>>& values, std::size_t node, int direction) {
  double sum = 0;
  for (int s = lists.first[node]; s < lists.first[node + 1]; ++s) {
    sum += values(lists.slots[static_cast<std::size_t>(s)], direction);
  }
  return sum;
}

class HaloTest : public testing::Test {
 protected:
  const Communicator world_ = Communicator::world();
  UnstructuredExchange exchange_{world_};
};

using HaloSwapTest = HaloTest;
using NodeCopiesTest = HaloTest;

}  // namespace

TEST_F(HaloSwapTest, GivesEveryCopyTheBitsOfOneRank) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Chunks chunks = make_chunks(world_.size(), seed);
    const RankPart part = take_part(chunks, world_.rank());
    const Halo halo = build_halo(exchange_, find_shared_nodes(exchange_, part.node_ids), part.slots);
    HaloSwap swap(world_, halo.plan);
    const auto expected = add_serially(chunks);
    for (int repeat = 0; repeat < 3; ++repeat) {
      const Rows3<double> values = fill_slots(part, halo.plan);
      swap.begin(ExecSpace(), values);
      swap.end();
      const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), values);
      for (std::size_t n = 0; n < part.node_ids.size(); ++n) {
        for (int k = 0; k < 3; ++k) {
          EXPECT_EQ(add_slots(halo.nodes_to_slots, host, n, k),
                    expected[static_cast<std::size_t>(part.node_ids[n])][static_cast<std::size_t>(k)]);
        }
      }
    }
  }
}

TEST_F(HaloSwapTest, KnowsWhichChunksCanGoOnMeanwhile) {
  const Chunks chunks = make_chunks(world_.size(), 3);
  const RankPart part = take_part(chunks, world_.rank());
  const Halo halo = build_halo(exchange_, find_shared_nodes(exchange_, part.node_ids), part.slots);
  std::vector<std::vector<char>> holds(static_cast<std::size_t>(world_.size()));     // [ranks][nodes] has a slot there
  const auto node_count = static_cast<std::size_t>(std::max(chunks.node_count, 0));  // GCC 14 takes it for negative
  for (auto& row : holds) row.assign(node_count, 0);
  for (std::size_t c = 0; c < chunks.nodes.size(); ++c) {
    for (const int node : chunks.nodes[c])
      holds[static_cast<std::size_t>(chunks.ranks[c])][static_cast<std::size_t>(node)] = 1;
  }
  const auto is_shared = [&](std::int64_t node) {
    return std::count_if(holds.begin(), holds.end(),
                         [&](const auto& row) { return row[static_cast<std::size_t>(node)] != 0; }) > 1;
  };
  const std::vector<char> sends = mark_sending_chunks(halo.plan, part.first_slot);
  ASSERT_EQ(sends.size(), part.chunk_ids.size());
  for (std::size_t c = 0; c < sends.size(); ++c) {
    const auto& nodes = chunks.nodes[static_cast<std::size_t>(part.chunk_ids[c])];
    EXPECT_EQ(sends[c] != 0, std::any_of(nodes.begin(), nodes.end(), is_shared));
  }
}

// Pressure faces have slots after those of the chunks; their order comes after every chunk's.
TEST_F(HaloSwapTest, PutsOtherSlotsAfterThoseOfAllChunks) {
  const std::int64_t after_chunks = 1000;
  RankPart part;
  part.node_ids = {42};
  part.slots = {{0, 0}, {world_.rank(), after_chunks + world_.rank()}};
  const Halo halo = build_halo(exchange_, find_shared_nodes(exchange_, part.node_ids), part.slots);
  const Rows3<double> values("slots", static_cast<std::size_t>(halo.plan.slot_count()));
  values(0, 0) = world_.rank();
  values(1, 0) = static_cast<double>(after_chunks + world_.rank());
  HaloSwap swap(world_, halo.plan);
  swap.begin(ExecSpace(), values);
  swap.end();
  std::vector<double> in_order, expected;
  for (const int slot : halo.nodes_to_slots.slots) in_order.push_back(values(slot, 0));
  for (int r = 0; r < world_.size(); ++r) expected.push_back(r);
  for (int r = 0; r < world_.size(); ++r) expected.push_back(static_cast<double>(after_chunks + r));
  EXPECT_EQ(in_order, expected);
  EXPECT_EQ(mark_sending_chunks(halo.plan, {0, 1}), std::vector<char>{world_.size() > 1});
}

TEST_F(HaloSwapTest, OfARankWithoutChunksIsEmpty) {
  Chunks chunks = make_chunks(world_.size(), 5);
  for (int& rank : chunks.ranks) rank = world_.size() - 1;
  const RankPart part = take_part(chunks, world_.rank());
  const Halo halo = build_halo(exchange_, find_shared_nodes(exchange_, part.node_ids), part.slots);
  EXPECT_EQ(halo.plan.slot_count(), static_cast<int>(part.slots.nodes.size()));
  HaloSwap swap(world_, halo.plan);
  swap.begin(ExecSpace(), fill_slots(part, halo.plan));
  swap.end();
  EXPECT_EQ(swap.traffic().messages, 0);
}

TEST_F(NodeCopiesTest, HaveTheValueOfTheLowestRankThatHoldsTheNode) {
  const Chunks chunks = make_chunks(world_.size(), 9);
  const RankPart part = take_part(chunks, world_.rank());
  const SharedNodes shared = find_shared_nodes(exchange_, part.node_ids);
  const Rows3<double> values("values", part.node_ids.size());
  for (std::size_t n = 0; n < part.node_ids.size(); ++n) {
    for (int k = 0; k < 3; ++k) values(n, k) = static_cast<double>(part.node_ids[n] * 10 + k) + 0.001 * world_.rank();
  }
  NodeCopies copies(world_, shared);
  copies.begin(ExecSpace(), values);
  copies.end(ExecSpace(), values);
  Kokkos::fence();
  for (std::size_t n = 0; n < part.node_ids.size(); ++n) {
    int owner = world_.size();
    for (std::size_t c = 0; c < chunks.nodes.size(); ++c) {
      const auto& nodes = chunks.nodes[c];
      const bool holds = std::binary_search(nodes.begin(), nodes.end(), static_cast<int>(part.node_ids[n]));
      if (holds) owner = std::min(owner, chunks.ranks[c]);
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(values(n, k), static_cast<double>(part.node_ids[n] * 10 + k) + 0.001 * owner);
    }
  }
}

// Two fields in one message, of the owners with even ranks alone.
TEST_F(NodeCopiesTest, HaveAllFieldsOfTheChosenOwnersAndKeepTheirOwnOfOthers) {
  const Chunks chunks = make_chunks(world_.size(), 9);
  const RankPart part = take_part(chunks, world_.rank());
  const SharedNodes shared = find_shared_nodes(exchange_, part.node_ids);
  const std::vector<Rows3<double>> fields{Rows3<double>("first", part.node_ids.size()),
                                          Rows3<double>("second", part.node_ids.size())};
  const auto fill = [&](std::size_t f, std::size_t n, int k, int rank) {
    return static_cast<double>(part.node_ids[n] * 10 + k) + 0.25 * static_cast<double>(f) + 0.001 * rank;
  };
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t n = 0; n < part.node_ids.size(); ++n)
      for (int k = 0; k < 3; ++k) fields[f](n, k) = fill(f, n, k, world_.rank());
  NodeCopies copies(world_, shared, 2);
  copies.choose_sources([](int rank) { return rank % 2 == 0; });
  copies.begin(ExecSpace(), std::vector<Rows3<const double>>(fields.begin(), fields.end()));
  copies.end(ExecSpace(), fields);
  Kokkos::fence();
  std::vector<int> owners(part.node_ids.size(), world_.rank());
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    const int owner = shared.owners[n];
    if (owner >= 0 && owner % 2 == 0) owners[n] = owner;
  }
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t n = 0; n < part.node_ids.size(); ++n)
      for (int k = 0; k < 3; ++k) EXPECT_EQ(fields[f](n, k), fill(f, n, k, owners[n]));
  const bool sends = world_.rank() % 2 == 0;
  EXPECT_LE(copies.traffic().messages, sends ? world_.size() - 1 : 0);
}

}  // namespace percuss::test
