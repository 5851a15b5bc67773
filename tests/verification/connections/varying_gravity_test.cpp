// Gravity that varies in time: its impulse and its work, on bodies that fall, are driven, or are rigid.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::varying_gravity_test {
namespace {

constexpr double amplitude = 10, rate = 100, time_step = 4e-5, mass = 6000;
constexpr int step_count = 1000;

Outcome run_block(const std::string& rigid, const std::string& conditions) {
  return run_deck(fmt::format(R"yaml(
time: {{end: {}, max_step: {}}}
parts: {{a: {{box: {{size: [1, 2, 3], cells: [2, 2, 2]}}, material: m{}}}}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
initial: [{{part: a, velocity: [2, 0, 1]}}]
loads: {{gravity: [0, 3, {{expression: "{} * cos({} * t)"}}]}}
{}
output: {{history: {{every: 0}}}}
silence: [step_scale]
)yaml",
                              step_count * time_step, time_step, rigid, amplitude, rate, conditions));
}

}  // namespace

// v(n-1/2) is the sum of time_step g over the steps before, the first of them with half a time_step.
TEST(VaryingGravity, DrivesFreeAndRigidBodiesAsItsSum) {
  for (const std::string rigid : {"", ", rigid: true"}) {
    const Outcome run = run_block(rigid, "");
    double v = 1;
    for (std::size_t row = 0; row < run.history.rows(); ++row) {
      ASSERT_NEAR(run.history["momentum_z"][row], mass * v, 1e-9 * mass);
      const double step = row == 0 ? 0.5 * time_step : time_step;
      v += step * amplitude * std::cos(rate * time_step * static_cast<double>(row));
    }
    EXPECT_EQ(run.history.rows(), step_count + 1);
    const double end = step_count * time_step, exact = 1 + amplitude / rate * std::sin(rate * (end - 0.5 * time_step));
    EXPECT_NEAR(run.history.last("momentum_z"), mass * exact, 1e-5 * mass);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
    EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
    EXPECT_NEAR(run.history.last("external"), run.history.last("kinetic") - 0.5 * mass * 5, 1e-6 * mass);
  }
}

// What is driven takes all that gravity does: nothing is left over.
TEST(VaryingGravity, DoesNoWorkInAllOnWhatIsDriven) {
  for (const std::string rigid : {"", ", rigid: true"}) {
    const Outcome run = run_block(rigid, "conditions: [{nodes: a, velocity: {x: 2, y: 0, z: 1}}]");
    EXPECT_NEAR(run.history.last("kinetic"), 0.5 * mass * 5, 1e-9 * mass);
    EXPECT_NEAR(run.history.last("external"), 0, 1e-9 * mass);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
    EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  }
}

}  // namespace percuss::test::varying_gravity_test
