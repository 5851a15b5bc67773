// One partition for all ranks.

#include <gtest/gtest.h>

#include "comm/partition/graph_partition.hpp"

namespace percuss::test {

namespace {

Graph make_ring(int count) {
  Graph ring;
  for (int v = 0; v < count; ++v) {
    ring.first.push_back(2 * v);
    ring.neighbours.push_back((v + count - 1) % count);
    ring.neighbours.push_back((v + 1) % count);
  }
  ring.first.push_back(2 * count);
  ring.edge_weights.assign(ring.neighbours.size(), 1);
  ring.vertex_weights.assign(static_cast<std::size_t>(count), 1);
  return ring;
}

}  // namespace

TEST(PartitionForRanks, IsThatOfRankZeroEverywhere) {
  const Communicator world = Communicator::world();
  const Graph ring = make_ring(100);
  const Partition expected = partition_graph(ring, world.size());
  const Partition partition = partition_for_ranks(world, world.rank() == 0 ? ring : Graph{{0}, {}, {}, {}});
  EXPECT_EQ(partition.parts, expected.parts);
  EXPECT_EQ(partition.imbalance, expected.imbalance);
  EXPECT_EQ(partition.cut, expected.cut);
  EXPECT_EQ(partition.empty_parts, 0);
}

TEST(PartitionForRanks, TellsEveryRankOfEmptyParts) {
  const Communicator world = Communicator::world();
  EXPECT_EQ(partition_for_ranks(world, make_ring(1)).empty_parts, world.size() - 1);
}

}  // namespace percuss::test
