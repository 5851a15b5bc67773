// An error of one rank becomes the same error on all.

#include "src/fail_together.hpp"

#include <gtest/gtest.h>

#include <typeinfo>

namespace percuss {
namespace {

/// Message on all ranks of an `Error` that the last rank alone has thrown.
template <class Error>
std::string fail_on_last_rank(const Error& error) {
  const Communicator world = Communicator::world();
  try {
    fail_together(world, [&] {
      if (world.rank() == world.size() - 1) throw error;
    });
  } catch (const Error& thrown) {
    EXPECT_TRUE(typeid(thrown) == typeid(Error));
    return thrown.what();
  }
  return "nothing was thrown";
}

TEST(FailTogether, KeepsTheKindAndTheTextOfAnError) {
  EXPECT_EQ(fail_on_last_rank(InputError("deck.yaml:1:2: error: wrong")), "deck.yaml:1:2: error: wrong");
  EXPECT_EQ(fail_on_last_rank(RunError("inverted")), "inverted");
  EXPECT_EQ(fail_on_last_rank(SystemError("disk full")), "disk full");
  EXPECT_EQ(fail_on_last_rank(MpiError("MPI_Send failed")), "MPI_Send failed");
  EXPECT_EQ(fail_on_last_rank(std::bad_alloc()), std::bad_alloc().what());
  EXPECT_EQ(fail_on_last_rank(std::length_error("too long")), "too long");
  EXPECT_EQ(fail_on_last_rank(std::runtime_error("a bug")), "a bug");
}

TEST(FailTogether, DoesTheWorkOnEveryRankIfNoneFails) {
  int done = 0;
  EXPECT_NO_THROW(fail_together(Communicator::world(), [&] { ++done; }));
  EXPECT_EQ(done, 1);
}

TEST(FailTogether, ThrowsTheErrorOfTheLowestRank) {
  const Communicator world = Communicator::world();
  try {
    fail_together(world, [&] {
      if (world.rank() == 0) throw InputError("of the lowest");
      throw SystemError("of another");
    });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "of the lowest");
  }
}

}  // namespace
}  // namespace percuss
