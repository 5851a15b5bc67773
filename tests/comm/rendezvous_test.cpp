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
  Rendezvous rendezvous(world, 0.1);
  if (world.rank() == 0) {
    EXPECT_EQ(rendezvous.meet(), world.size() == 1);
  }
  world.barrier();
  if (world.rank() != 0) {
    EXPECT_TRUE(rendezvous.meet());  // so that rank 0 can end its own
  }
}

}  // namespace percuss::test
