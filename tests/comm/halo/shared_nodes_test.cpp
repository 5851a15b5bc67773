// Who shares which nodes, against the lists of all ranks, which every rank can compute.

#include "comm/halo/shared_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

/// Random distinct node ids of one rank, in random order.
std::vector<std::int64_t> pick_nodes(int rank, std::uint64_t seed, int id_count) {
  Random random(seed * 100 + static_cast<std::uint64_t>(rank));
  std::vector<std::int64_t> ids;
  for (std::int64_t id = 0; id < id_count; ++id) {
    if (random.below(3) == 0) ids.push_back(id * 1'000'003);  // far apart, so homes are far apart too
  }
  for (std::size_t i = ids.size(); i > 1; --i)
    std::swap(ids[i - 1], ids[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  return ids;
}

void expect_like_serial(const Communicator& world, const std::vector<std::vector<std::int64_t>>& all,
                        const SharedNodes& shared) {
  const auto me = static_cast<std::size_t>(world.rank());
  std::map<int, std::vector<int>> expected;
  std::vector<int> owners;
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    std::map<std::int64_t, int> common;  // sorts by id
    for (std::size_t n = 0; n < all[me].size(); ++n) {
      if (rank != me && std::count(all[rank].begin(), all[rank].end(), all[me][n]) > 0)
        common[all[me][n]] = static_cast<int>(n);
    }
    for (const auto& [id, node] : common) expected[static_cast<int>(rank)].push_back(node);
  }
  for (const std::int64_t id : all[me]) {
    const auto holder = std::find_if(all.begin(), all.end(),
                                     [&](const auto& ids) { return std::count(ids.begin(), ids.end(), id) > 0; });
    owners.push_back(static_cast<int>(holder - all.begin()));
  }
  std::map<int, std::vector<int>> found;
  for (std::size_t r = 0; r < shared.ranks.size(); ++r) {
    found[shared.ranks[r]] = {shared.nodes.begin() + shared.first[r], shared.nodes.begin() + shared.first[r + 1]};
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(shared.owners, owners);
  EXPECT_TRUE(std::is_sorted(shared.ranks.begin(), shared.ranks.end()));
}

}  // namespace

TEST(SharedNodes, AreThoseThatSeveralRanksHold) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    std::vector<std::vector<std::int64_t>> all;
    for (int rank = 0; rank < world.size(); ++rank) all.push_back(pick_nodes(rank, seed, 60));
    if (seed == 3) all.front().clear();  // a rank without elements
    const auto me = static_cast<std::size_t>(world.rank());
    expect_like_serial(world, all, find_shared_nodes(exchange, all[me]));
  }
}

TEST(SharedNodes, AreNoneBetweenRanksThatTouchNowhere) {
  const Communicator world = Communicator::world();
  UnstructuredExchange exchange(world);
  const SharedNodes shared = find_shared_nodes(exchange, {10 * world.rank() + 1, 10 * world.rank()});
  EXPECT_TRUE(shared.ranks.empty());
  EXPECT_TRUE(shared.nodes.empty());
  EXPECT_EQ(shared.first, std::vector<int>{0});
  EXPECT_EQ(shared.owners, (std::vector<int>{world.rank(), world.rank()}));
}

TEST(SharedNodes, OfNoNodesAtAllAreNone) {
  UnstructuredExchange exchange(Communicator::world());
  EXPECT_TRUE(find_shared_nodes(exchange, {}).ranks.empty());
}

}  // namespace percuss::test
