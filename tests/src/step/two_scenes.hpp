#pragma once
// A scene on many ranks beside the same one alone, to be compared bit by bit.

#include <gtest/gtest.h>

#include <string>

#include "tests/src/step/scene.hpp"

namespace percuss::test {

/// One scene held twice: by all ranks together, and by this one alone.
struct TwoScenes {
  explicit TwoScenes(const std::string& from) : together(from), alone(from, Communicator(MPI_COMM_SELF)) {}
  Scene together, alone;

  void run(int steps) {
    together.run(steps);
    alone.run(steps);
  }
};

/// Expects the rows of this rank's nodes to be those of the same nodes of the whole mesh.
inline void expect_same_rows(const TwoScenes& scenes, const Rows3<double>& together, const Rows3<double>& alone,
                             const char* what) {
  const auto mine = to_host(together), whole = to_host(alone);
  const auto& numbers = scenes.together.chunked.mesh.node_numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(mine(n, k), whole(static_cast<std::size_t>(numbers[n]), k)) << what << " of node " << numbers[n];
    }
  }
}

/// Runs both and expects the same bits of them.
inline void expect_same_run(TwoScenes& scenes, int steps) {
  scenes.run(steps);
  expect_same_rows(scenes, scenes.together.state.x, scenes.alone.state.x, "position");
  expect_same_rows(scenes, scenes.together.state.v, scenes.alone.state.v, "velocity");
  EXPECT_EQ(hash_state(scenes.together.model, scenes.together.state),
            hash_state(scenes.alone.model, scenes.alone.state));
  EXPECT_EQ(scenes.together.state.next_dt, scenes.alone.state.next_dt);
}

}  // namespace percuss::test
