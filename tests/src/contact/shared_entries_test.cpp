// Entries that ranks swap: what one sends is what the other expects, and all have all that lies on their nodes.

#include "src/contact/enforcement/shared_entries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace percuss::test {
namespace {

constexpr int num_ranks = 5;

/// A node, its owner and the rows on it: rank and key. Entry numbers are keys here.
struct TouchedNode {
  std::int64_t number = 0;
  int owner = 0;
  std::vector<std::pair<int, int>> rows;

  std::set<int> find_ranks() const {
    std::set<int> ranks{owner};
    for (const auto& [rank, key] : rows) ranks.insert(rank);
    return ranks;
  }
};

std::vector<TouchedNode> make_nodes(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<TouchedNode> nodes;
  for (int n = 0; n < 60; ++n) {
    TouchedNode node{3 * n + 1, below(num_ranks), {}};
    const int rows = below(7);
    for (int i = 0; i < rows; ++i) node.rows.emplace_back(below(num_ranks), 100 * n + i / 2);  // two slots of one row
    nodes.push_back(node);
  }
  std::shuffle(nodes.begin(), nodes.end(), random);
  return nodes;
}

/// What a rank knows: all rows on the nodes that it touches or owns.
SwapLists list_for(int rank, const std::vector<TouchedNode>& nodes) {
  std::vector<SharedEntry> entries;
  for (const TouchedNode& node : nodes) {
    if (!node.find_ranks().contains(rank)) continue;
    for (const auto& [of, key] : node.rows)
      entries.push_back({node.number, key, node.owner, static_cast<int>(node.number), of, of == rank ? key : -1});
  }
  return list_swaps(entries, rank);
}

/// The items of the run of a rank; empty if there is none.
template <class T>
std::vector<T> take_run(const std::vector<PeerRun>& runs, int rank, const std::vector<T>& items) {
  for (const PeerRun& run : runs)
    if (run.rank == rank) return {items.begin() + run.first, items.begin() + run.first + run.count};
  return {};
}

}  // namespace

TEST(SharedEntries, AreSentInTheOrderInWhichTheyAreExpected) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<TouchedNode> nodes = make_nodes(seed);
    std::vector<SwapLists> lists;
    for (int rank = 0; rank < num_ranks; ++rank) lists.push_back(list_for(rank, nodes));
    for (std::size_t from = 0; from < num_ranks; ++from) {
      for (std::size_t to = 0; to < num_ranks; ++to) {
        const auto sent = take_run(lists[from].plan.to, static_cast<int>(to), lists[from].sent);
        const auto expected = take_run(lists[to].plan.from, static_cast<int>(from), lists[to].key);
        EXPECT_EQ(std::vector<std::int64_t>(sent.begin(), sent.end()), expected);
      }
    }
  }
}

TEST(SharedEntries, ComeFromAllOthersOnceToAllWhoHaveThePlace) {
  const std::vector<TouchedNode> nodes = make_nodes(7);
  for (int rank = 0; rank < num_ranks; ++rank) {
    std::multiset<std::pair<int, std::int64_t>> expected, found;
    for (const TouchedNode& node : nodes) {
      if (!node.find_ranks().contains(rank)) continue;
      for (const auto& [of, key] : node.rows)
        if (of != rank) expected.emplace(static_cast<int>(node.number), key);
    }
    const SwapLists lists = list_for(rank, nodes);
    for (std::size_t k = 0; k < lists.key.size(); ++k) found.emplace(lists.place[k], lists.key[k]);
    EXPECT_EQ(found, expected);
  }
}

TEST(SharedEntries, OfARankAloneAreNotSent) {
  const SwapLists lists = list_swaps({{1, 10, 0, 0, 0, 5}, {2, 20, 0, 1, 0, 6}}, 0);
  EXPECT_TRUE(lists.sent.empty());
  EXPECT_TRUE(lists.plan.to.empty());
  EXPECT_TRUE(lists.plan.from.empty());
}

}  // namespace percuss::test
