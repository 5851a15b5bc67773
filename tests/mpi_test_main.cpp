// The main function of every test executable that runs on several ranks: MPI and Kokkos up before the first test, down
// after the last. Rank 0 reports as GoogleTest always does; the others speak up only when something fails there.

#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <cstdio>

#include "comm/communicator.hpp"

namespace {

/// The first failure on any rank ends all of them: the others may be waiting for what the failed test leaves out.
class StopAllRanks : public testing::EmptyTestEventListener {
 public:
  explicit StopAllRanks(const percuss::Communicator& ranks) : ranks_(ranks) {}

 private:
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "rank %d of %d: %s:%d: %s\n", ranks_.rank(), ranks_.size(),
                 result.file_name() != nullptr ? result.file_name() : "?", result.line_number(), result.message());
    std::fflush(nullptr);
    ranks_.abort(1);
  }

  percuss::Communicator ranks_;
};

}  // namespace

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const Kokkos::ScopeGuard kokkos(argc, argv);
  const auto world = percuss::Communicator::world();
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  if (world.rank() != 0) delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new StopAllRanks(world));  // GoogleTest deletes it
  return RUN_ALL_TESTS();
}
