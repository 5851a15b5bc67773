// Ranks that have all failed find each other; one that has failed alone learns so.

#include "comm/rendezvous.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace percuss::test {

TEST(Rendezvous, BringsTogetherRanksThatAreLate) {
  const auto world = Communicator::world();
  Rendezvous rendezvous(world);
  for (int repeat = 0; repeat < 2; ++repeat) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20 * world.rank()));
    EXPECT_TRUE(rendezvous.meet());
  }
}

TEST(Rendezvous, TellsARankThatItIsAloneWhileTheOthersAreInACollective) {
  const auto world = Communicator::world();
  Rendezvous rendezvous(world);
  if (world.rank() == 0) {
    EXPECT_EQ(rendezvous.meet(), world.size() == 1);
  }
  world.barrier();
  if (world.rank() != 0) {
    EXPECT_TRUE(rendezvous.meet());  // only so that no barrier is left under way
  }
}

}  // namespace percuss::test
