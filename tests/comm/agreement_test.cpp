// Agreement of all ranks on a failure of one.

#include "comm/agreement.hpp"

#include <gtest/gtest.h>

#include "comm/first_finding.hpp"

namespace percuss::test {

namespace {

std::string name_rank(int rank) {
  return std::string(static_cast<std::size_t>(100 * rank), '.') + std::to_string(rank);
}

TEST(AgreeOnFailure, FindsNoneWhereNoRankFailed) {
  EXPECT_EQ(agree_on_failure(Communicator::world(), std::nullopt), std::nullopt);
}

TEST(AgreeOnFailure, TellsAllRanksOfTheOneThatFailed) {
  const Communicator world = Communicator::world();
  for (int failing = 0; failing < world.size(); ++failing) {
    std::optional<Failure> own;
    if (world.rank() == failing) own = Failure{7 + failing, name_rank(failing)};
    EXPECT_EQ(agree_on_failure(world, own), (Failure{7 + failing, name_rank(failing)}));
  }
}

TEST(AgreeOnFailure, ChoosesTheLowestOfSeveralRanks) {
  const Communicator world = Communicator::world();
  const int lowest = world.size() / 2;
  std::optional<Failure> own;
  if (world.rank() >= lowest) own = Failure{world.rank(), name_rank(world.rank())};
  EXPECT_EQ(agree_on_failure(world, own), (Failure{lowest, name_rank(lowest)}));
}

TEST(GatherTexts, GivesRankZeroTheTextsInTheOrderOfRanks) {
  const Communicator world = Communicator::world();
  const std::vector<std::string> texts = gather_texts(world, name_rank(world.rank()));
  ASSERT_EQ(static_cast<int>(texts.size()), world.rank() == 0 ? world.size() : 0);
  for (std::size_t r = 0; r < texts.size(); ++r) EXPECT_EQ(texts[r], name_rank(static_cast<int>(r)));
}

TEST(BroadcastText, IsThatOfTheRootEverywhere) {
  const Communicator world = Communicator::world();
  const int root = world.size() - 1;
  EXPECT_EQ(broadcast_text(world, name_rank(world.rank()), root), name_rank(root));
  EXPECT_EQ(broadcast_text(world, world.rank() == root ? "" : "not this", root), "");
}

TEST(BroadcastValues, AreThoseOfTheRootEverywhere) {
  const Communicator world = Communicator::world();
  const int root = world.size() / 2;
  std::vector<double> values(static_cast<std::size_t>(3 * world.rank()), -1);
  if (world.rank() == root) values = {1, 2, 3, 4};
  broadcast_values(world, values, root);
  EXPECT_EQ(values, (std::vector<double>{1, 2, 3, 4}));
  std::vector<int> none(static_cast<std::size_t>(world.rank() == root ? 0 : 5));
  broadcast_values(world, none, root);
  EXPECT_TRUE(none.empty());
}

TEST(FirstFinding, IsThatOfTheLowestNumberAndRank) {
  const Communicator world = Communicator::world();
  EXPECT_EQ(agree_on_first(world, no_finding, "nothing"), std::nullopt);
  EXPECT_EQ(agree_on_first(world, 7, name_rank(world.rank())), name_rank(0));
  const int last = world.size() - 1;
  EXPECT_EQ(agree_on_first(world, 100 - world.rank(), name_rank(world.rank())), name_rank(last));
  EXPECT_EQ(agree_on_first(world, world.rank() == last ? 3 : no_finding, "the last"), "the last");
}

}  // namespace

}  // namespace percuss::test
