// A square tube with a trigger folds under the mean force of theory, also with mass scaling during the run.

#include "tests/verification/shells/square_tube.hpp"

namespace percuss::test::crushed_tube_test {

using namespace square_tube;

TEST(CrushedTube, FoldsUnderTheForceOfAbramowiczAndJones) {
  const Outcome run = crush(12, "");
  const double force = find_mean_force(run.history);
  fmt::print("mean force {:.2f} kN of {:.2f}, least step {:.3f} of the largest\n", force / 1e3, expected_force / 1e3,
             run.summary.dt.min / run.summary.dt.max);
  expect_sound(run);
  EXPECT_NEAR(force / expected_force, 1, 0.15);
  EXPECT_GT(run.summary.dt.min, 0.3 * run.summary.dt.max);

  // With mass scaling that holds four fifths of the first step the force stays, within what little mass can do.
  const Outcome scaled = crush(12, ", mass_scaling: {step: 6.4e-7, max_added: 0.3, every: 5}");
  fmt::print("scaled: mean force {:.2f} kN, {} steps of {}, mass {:.3f}\n", find_mean_force(scaled.history) / 1e3,
             scaled.summary.steps, run.summary.steps, scaled.summary.mass.in_run);
  expect_sound(scaled);
  EXPECT_NEAR(find_mean_force(scaled.history) / force, 1, 0.02);
  EXPECT_GT(scaled.summary.mass.in_run, 0);
  EXPECT_GT(scaled.summary.dt.min, 0.6 * scaled.summary.dt.max);
  EXPECT_LT(static_cast<double>(scaled.summary.steps), 0.8 * static_cast<double>(run.summary.steps));
}

}  // namespace percuss::test::crushed_tube_test
