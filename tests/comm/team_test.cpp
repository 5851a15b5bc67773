// Teams of ranks: who is in, what their reductions see, and when a communicator is made.

#include "comm/team.hpp"

#include <gtest/gtest.h>

#include "comm/all_reduce.hpp"

namespace percuss::test {

namespace {

using Ranks = std::vector<char>;

/// The ranks whose bits are set, of those that there are.
Ranks choose(int size, unsigned bits) {
  Ranks ranks;
  for (int r = 0; r < size; ++r) ranks.push_back(static_cast<char>(bits >> r & 1U));
  return ranks;
}

/// The team is `expected`, and adds up over these alone.
void expect_team(const Communicator& world, const Team& team, const Ranks& expected) {
  int count = 0, sum = 0;
  for (int r = 0; r < world.size(); ++r) {
    const bool is_in = expected[static_cast<std::size_t>(r)] != 0;
    EXPECT_EQ(team.contains(r), is_in) << r;
    count += is_in ? 1 : 0;
    sum += is_in ? 1 << r : 0;
  }
  EXPECT_EQ(team.size(), count);
  if (!team.contains_this()) return;
  int bits = 1 << world.rank();
  all_reduce(team.ranks(), Reduce::sum, bits);
  EXPECT_EQ(bits, sum);
}

}  // namespace

TEST(Team, ReducesOverItsRanksAlone) {
  const Communicator world = Communicator::world();
  for (unsigned bits = 0; bits < 1U << world.size(); ++bits) {
    Team team(world);
    team.meet(choose(world.size(), bits));
    expect_team(world, team, choose(world.size(), bits));
  }
}

TEST(Team, IsMadeAnewOnlyForThoseWhoJoin) {
  const Communicator world = Communicator::world();
  Team team(world);
  const unsigned last = 1U << (world.size() - 1);
  team.meet(choose(world.size(), last));
  EXPECT_EQ(team.formations(), 1);
  for (int i = 0; i < 10; ++i) team.meet(choose(world.size(), i % 2 == 0 ? last : 0U));
  EXPECT_EQ(team.formations(), 1);
  expect_team(world, team, choose(world.size(), last));
  team.meet(choose(world.size(), 1U));
  EXPECT_EQ(team.formations(), world.size() == 1 ? 1 : 2);
  expect_team(world, team, choose(world.size(), last | 1U));
}

TEST(Team, IsLeftByThoseWhoHaveHadNoWorkForLong) {
  const Communicator world = Communicator::world();
  Team team(world);
  const Ranks all = choose(world.size(), ~0U), first = choose(world.size(), 1U);
  team.meet(all);
  expect_team(world, team, all);
  for (int i = 1; i < Team::patience; ++i) team.meet(first);
  expect_team(world, team, all);  // all had work since the last check
  for (int i = 0; i < Team::patience; ++i) team.meet(first);
  expect_team(world, team, first);
  EXPECT_EQ(team.formations(), world.size() == 1 ? 1 : 2);
}

}  // namespace percuss::test
