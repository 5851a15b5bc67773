// Graph and partition of chunks on one rank.

#include "comm/partition/graph_partition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comm/partition/even_out.hpp"
#include "tests/comm/random_numbers.hpp"
#include "tests/expect_error.hpp"

namespace percuss::test {

using testing::ElementsAre;

namespace {

/// An nx by ny grid of vertices of one cost; edges along the grid.
Graph make_grid(int nx, int ny) {
  Graph graph;
  graph.first.push_back(0);
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      if (y > 0) graph.neighbours.push_back((y - 1) * nx + x);
      if (x > 0) graph.neighbours.push_back(y * nx + x - 1);
      if (x + 1 < nx) graph.neighbours.push_back(y * nx + x + 1);
      if (y + 1 < ny) graph.neighbours.push_back((y + 1) * nx + x);
      graph.first.push_back(static_cast<int>(graph.neighbours.size()));
    }
  }
  graph.edge_weights.assign(graph.neighbours.size(), 1);
  graph.vertex_weights.assign(static_cast<std::size_t>(nx * ny), 1);
  return graph;
}

/// Cut and heaviest part, counted from scratch.
long long count_cut(const Graph& graph, const std::vector<int>& parts) {
  long long twice = 0;
  for (std::size_t v = 0; v < parts.size(); ++v) {
    for (int e = graph.first[v]; e < graph.first[v + 1]; ++e) {
      const auto edge = static_cast<std::size_t>(e);
      if (parts[static_cast<std::size_t>(graph.neighbours[edge])] != parts[v]) twice += graph.edge_weights[edge];
    }
  }
  return twice / 2;
}

}  // namespace

TEST(BuildGraph, ListsEachEdgeAtBothItsEndsInAscendingOrder) {
  const Graph graph = build_graph({{0, 1, 2}, {0, 2, 1}, {1, 2, 1}}, {7, 8, 9});
  EXPECT_THAT(graph.first, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(graph.neighbours, ElementsAre(1, 2, 0, 2, 0, 1));
  EXPECT_THAT(graph.edge_weights, ElementsAre(2, 1, 2, 1, 1, 1));
  EXPECT_THAT(graph.vertex_weights, ElementsAre(7, 8, 9));
}

TEST(Partition, OfAStripIsTheShortCut) {
  const Partition partition = partition_graph(make_grid(40, 4), 2);
  EXPECT_EQ(partition.cut, 4);
  EXPECT_EQ(partition.imbalance, 1.0);
  EXPECT_EQ(partition.empty_parts, 0);
}

TEST(Partition, IsEvenAndHasTheCutThatItReports) {
  const Graph grid = make_grid(60, 50);
  for (const int parts : {1, 2, 3, 7, 8, 9, 31, 64}) {
    const Partition partition = partition_graph(grid, parts);
    EXPECT_LE(partition.imbalance, 1.05) << parts;
    EXPECT_EQ(partition.cut, count_cut(grid, partition.parts));
    EXPECT_EQ(partition.empty_parts, 0);
    // Squares of vertices, each side counted for both its parts, cut less than 2 sqrt(parts * vertices) edges.
    EXPECT_LE(static_cast<double>(partition.cut), 2 * std::sqrt(3000.0 * parts)) << parts;
  }
}

TEST(Partition, IsTheSameEveryTime) {
  const Graph grid = make_grid(37, 23);
  EXPECT_EQ(partition_graph(grid, 13).parts, partition_graph(grid, 13).parts);
}

TEST(Partition, BalancesCostsAndNotCounts) {
  Graph grid = make_grid(40, 10);
  for (std::size_t v = 0; v < 400; ++v) grid.vertex_weights[v] = v % 40 < 10 ? 30 : 10;
  const Partition partition = partition_graph(grid, 5);
  EXPECT_LE(partition.imbalance, 1.05);
}

TEST(Partition, WithFewerVerticesThanPartsSaysHowManyPartsAreEmpty) {
  const Partition partition = partition_graph(make_grid(3, 1), 5);
  EXPECT_THAT(partition.parts, ElementsAre(0, 1, 2));
  EXPECT_EQ(partition.empty_parts, 2);
  EXPECT_DOUBLE_EQ(partition.imbalance, 5.0 / 3);
}

TEST(Partition, OfNothingIsAllEmptyParts) {
  const Partition partition = partition_graph(Graph{{0}, {}, {}, {}}, 4);
  EXPECT_TRUE(partition.parts.empty());
  EXPECT_EQ(partition.empty_parts, 4);
}

TEST(Partition, LeavesNoPartEmptyWithHardlyMoreVerticesThanParts) {
  for (int parts = 2; parts < 12; ++parts) {
    EXPECT_EQ(partition_graph(make_grid(12, 1), parts).empty_parts, 0) << parts;
  }
}

TEST(Partition, DividesChunksThatShareNothing) {
  Graph islands = make_grid(1, 1);
  islands.first.assign(41, 0);
  islands.vertex_weights.assign(40, 3);
  const Partition partition = partition_graph(islands, 8);
  EXPECT_EQ(partition.cut, 0);
  EXPECT_EQ(partition.imbalance, 1.0);
}

TEST(Partition, RefusesNoParts) {
  EXPECT_ERROR(partition_graph(make_grid(2, 2), 0), std::invalid_argument, "cannot be divided in 0 parts");
}

TEST(EvenOut, MovesVerticesToLighterPartsUntilEvenEnough) {
  const Graph grid = make_grid(30, 10);
  std::vector<int> parts(300, 0);
  for (std::size_t v = 290; v < 300; ++v) parts[v] = 1;  // the last row alone
  even_out(grid, 2, parts);
  const auto upper = std::count(parts.begin(), parts.end(), 1);
  EXPECT_GE(upper, 147);  // 150 within 2 %
  EXPECT_LE(count_cut(grid, parts), 31);
}

TEST(EvenOut, LeavesWhatNoSingleMoveCanImprove) {
  Graph pair = make_grid(3, 1);
  pair.vertex_weights = {100, 1, 1};
  std::vector<int> parts{0, 1, 1};
  even_out(pair, 2, parts);
  EXPECT_THAT(parts, ElementsAre(0, 1, 1));
}

}  // namespace percuss::test
