// Mass, centre and inertia of rigid bodies are those of the shapes of their elements, on the coarsest mesh as well.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::exact_inertia_test {
namespace {

const std::string materials =
    "materials: {steel: {model: elastic, density: 1000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

/// Twice the kinetic energy at the start of a part that spins about its centre with 1 rad/s: its moment of inertia.
double find_moment(const std::string& part, const std::array<double, 3>& axis, const std::string& more = "") {
  const Outcome run = run_deck(fmt::format(
      "time: {{end: 1e-3, max_step: 1e-4}}\nparts: {{b: {}}}\ninitial: [{{part: b, angular_velocity: [{}, {}, {}]}}]\n"
      "output: {{history: {{every: 1e-4, parts: [b]}}}}\n{}{}",
      part, axis[0], axis[1], axis[2], more, materials));
  EXPECT_NEAR(run.history["kinetic:b"].front(), run.history["kinetic"].front(), 1e-12 * run.history["kinetic"].front());
  EXPECT_NEAR(run.history.last("kinetic"), run.history["kinetic"].front(), 1e-10 * run.history["kinetic"].front());
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  return 2 * run.history["kinetic"].front();
}

constexpr std::array<double, 3> about_x{1, 0, 0}, about_y{0, 1, 0}, about_z{0, 0, 1};

}  // namespace

// A cube of side 1 and mass 1000: m / 6 about any axis, of any elements.
TEST(RigidInertia, OfACubeIsExactOnEveryMesh) {
  for (const char* const elements : {"hexahedra", "tetrahedra", "wedges", "pyramids"}) {
    for (const int cells : {1, 3}) {
      const std::string part = fmt::format(
          "{{box: {{size: [1, 1, 1], cells: [{0}, {0}, {0}]}}, elements: {1}, at: [3, 2, 1], material: steel, rigid: "
          "true}}",
          cells, elements);
      EXPECT_NEAR(find_moment(part, about_z), 1000.0 / 6, 1e-9) << elements;
    }
  }
}

// Unequal cells whose inner node stands off the middle, so that they are no boxes: the sides are those of the box.
TEST(RigidInertia, OfDistortedElementsIsThatOfTheirShape) {
  const std::string part =
      "{box: {size: [0.6, 0.4, 0.2], cells: [2, 2, 2]}, at: [0, 0, 0], material: steel, rigid: true}";
  const std::string moved =
      "imperfections: [{nodes: b, direction: [1, 0.7, 0.4], mode: \"0.3 * x * (0.6 - x) * y * (0.4 "
      "- y) * z * (0.2 - z) / 0.0036\"}]\n";
  const double mass = 1000 * 0.6 * 0.4 * 0.2;
  EXPECT_NEAR(find_moment(part, about_x, moved), mass * (0.16 + 0.04) / 12, 1e-9);
  EXPECT_NEAR(find_moment(part, about_z, moved), mass * (0.36 + 0.16) / 12, 1e-9);
}

// A plate of one shell, with its thickness.
TEST(RigidInertia, OfAShellHasItsThickness) {
  const std::string part =
      "{shell_plate: {size: [0.5, 0.3], cells: [1, 1]}, thickness: 0.1, material: steel, rigid: true}";
  const double mass = 1000 * 0.5 * 0.3 * 0.1;
  EXPECT_NEAR(find_moment(part, about_x), mass * (0.09 + 0.01) / 12, 1e-10);
  EXPECT_NEAR(find_moment(part, about_y), mass * (0.25 + 0.01) / 12, 1e-10);
  EXPECT_NEAR(find_moment(part, about_z), mass * (0.25 + 0.09) / 12, 1e-10);
}

// A rod of one beam, with its section.
TEST(RigidInertia, OfABeamHasItsSection) {
  const std::string part =
      "{line: {from: [0, 0, 0], to: [1, 0, 0], cells: 1}, section: {rectangle: {size: [0.1, 0.2]}}, toward: y, "
      "material: "
      "steel, rigid: true}";
  const double mass = 1000 * 0.02;
  EXPECT_NEAR(find_moment(part, about_x), mass * (0.01 + 0.04) / 12, 1e-10);
  EXPECT_NEAR(find_moment(part, about_y), mass * (1 + 0.04) / 12, 1e-10);
  EXPECT_NEAR(find_moment(part, about_z), mass * (1 + 0.01) / 12, 1e-10);
}

// Two parts of one body: each has the energy of its own mass, and both have that of the body.
TEST(RigidInertia, PartsOfABodyShareItsEnergy) {
  const Outcome run = run_deck(materials + R"yaml(
time: {end: 1e-2, max_step: 1e-4}
parts:
  left: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [-0.5, -0.5, -0.5], material: steel, rigid: {body: both}}
  right: {box: {size: [1, 1, 1], cells: [2, 1, 1]}, at: [2.5, -0.5, -0.5], material: steel, rigid: {body: both}}
initial: [{part: all, angular_velocity: [0, 0, 1], center: [0, 0, 0]}]
output: {history: {every: 1e-3, parts: [left, right]}}
)yaml");
  EXPECT_NEAR(run.history["kinetic:left"].front(), 1000.0 / 12, 1e-9);
  EXPECT_NEAR(run.history["kinetic:right"].front(), 4500 + 1000.0 / 12, 1e-9);
  for (const std::size_t row : {std::size_t{0}, run.history.rows() - 1}) {
    EXPECT_NEAR(run.history["kinetic"][row], 4500 + 1000.0 / 6, 1e-8);
    EXPECT_NEAR(run.history["kinetic:left"][row] + run.history["kinetic:right"][row], run.history["kinetic"][row],
                1e-8);
  }
}

// A top of one element, with a fixed point below it: it precesses evenly at the rate that balances its weight.
TEST(RigidInertia, TopPrecessesAtItsRate) {
  const double mass = 1000 * 0.2 * 0.2 * 0.1, arm = 0.25, g = 9.81, tilt = 0.5;
  const double along = mass * (0.04 + 0.04) / 12, across = mass * (0.04 + 0.01) / 12 + mass * arm * arm;
  const double spin = 200;  // about its axis
  // across cos(tilt) W^2 - along spin W + m g arm = 0
  const double a = across * std::cos(tilt), b = along * spin, c = mass * g * arm;
  const double rate = (b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
  const double own = spin - rate * std::cos(tilt);
  // In the axes of the top, z along it; gravity leans.
  const double up_x = std::sin(tilt), up_z = std::cos(tilt);
  const Outcome run = run_deck(fmt::format(
      "time: {{end: 1, max_step: 2e-4}}\nparts: {{top: {{box: {{size: [0.2, 0.2, 0.1], cells: [1, 1, 1]}}, at: [-0.1, "
      "-0.1, 0.2], material: steel, rigid: true}}}}\njoints: {{foot: {{kind: spherical, bodies: [top], at: [0, 0, "
      "0]}}}}\n"
      "loads: {{gravity: [{}, 0, {}]}}\ninitial: [{{part: top, angular_velocity: [{}, 0, {}], center: [0, 0, 0]}}]\n"
      "output: {{history: {{every: 1e-2}}}}\n{}",
      -g * up_x, -g * up_z, rate * up_x, own + rate * up_z, materials));
  const auto &x = run.history["body_x:top"], &y = run.history["body_y:top"], &z = run.history["body_z:top"];
  for (const std::size_t row : {run.history.rows() / 2, run.history.rows() - 1}) {
    const double time = run.history["time"][row];
    const double height = x[row] * up_x + z[row] * up_z;
    EXPECT_NEAR(height, arm * std::cos(tilt), 1e-3 * arm);
    const double leaning = x[row] * up_z - z[row] * up_x;  // across up, in the plane of the start
    const double angle = std::atan2(y[row], -leaning);     // it begins at -sin(tilt)
    const double wanted = std::remainder(-rate * time, 2 * std::numbers::pi);
    EXPECT_NEAR(std::remainder(angle - wanted, 2 * std::numbers::pi), 0, 1e-3 * rate * time) << time;
  }
}

// A block of one element as a pendulum: 4 sqrt(I / (m g d)) K(sin(angle / 2)).
TEST(RigidInertia, BlockSwingsWithItsPeriod) {
  const double angle = 1, g = 9.81, mass = 1000 * 0.4 * 0.1 * 0.2, arm = 0.2,
               inertia = mass * (0.16 + 0.04) / 12 + mass * arm * arm;
  const double period = 4 * std::sqrt(inertia / (mass * g * arm)) * std::comp_ellint_1(std::sin(angle / 2));
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 5e-4}}\nparts: {{block: {{box: {{size: [0.4, 0.1, 0.2], cells: [1, 1, 1]}}, at: [0, "
      "-0.05, -0.1], material: steel, rigid: true}}}}\njoints: {{pin: {{kind: revolute, bodies: [block], at: [0, 0, "
      "0], "
      "axis: y}}}}\nloads: {{gravity: [{}, 0, {}]}}\noutput: {{history: {{every: 0}}}}\n{}",
      3.1 * period, g * std::cos(angle), -g * std::sin(angle), materials));
  const auto &x = run.history["body_x:block"], &z = run.history["body_z:block"], &t = run.history["time"];
  std::vector<double> passes;
  double before = -1;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double side = x[row] * std::sin(angle) + z[row] * std::cos(angle);
    if (before > 0 && side <= 0) passes.push_back(t[row] - (t[row] - t[row - 1]) * side / (side - before));
    before = side;
  }
  ASSERT_GE(passes.size(), 3U);
  EXPECT_NEAR((passes[2] - passes[0]) / 2, period, 1e-3 * period);
}

namespace {

/// Spin in the axes of a body without moments, and its middle axis in space, by Runge and Kutta: the time of its first
/// turn over.
double find_turn_over(const std::array<double, 3>& inertia, std::array<double, 3> spin) {
  using State = std::array<double, 6>;  // spin, then the global axis y in the axes of the body
  const auto rate = [&](const State& s) {
    State d{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      d[k] = (inertia[i] - inertia[j]) * s[i] * s[j] / inertia[k];
      d[3 + k] = s[3 + i] * s[j] - s[3 + j] * s[i];
    }
    return d;
  };
  State s{spin[0], spin[1], spin[2], 0, 1, 0};
  const double dt = 1e-4;
  for (double time = 0;; time += dt) {
    const double before = s[4];
    State sum = s, k = rate(s);
    const double share[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, ahead[3] = {0.5, 0.5, 1};
    for (int stage = 0; stage < 4; ++stage) {
      for (std::size_t i = 0; i < 6; ++i) sum[i] += share[stage] * dt * k[i];
      if (stage == 3) break;
      State at = s;
      for (std::size_t i = 0; i < 6; ++i) at[i] += ahead[stage] * dt * k[i];
      k = rate(at);
    }
    s = sum;
    if (before > 0 && s[4] <= 0) return time + dt * before / (before - s[4]);
  }
}

}  // namespace

// A nut that turns over (Dzhanibekov): a block of one element about its middle axis.
TEST(RigidInertia, BlockTurnsOverWhenEulersEquationsSay) {
  const double mass = 1000 * 0.3 * 0.2 * 0.1;
  const double over = find_turn_over({mass * (0.04 + 0.01) / 12, mass * (0.09 + 0.01) / 12, mass * (0.09 + 0.04) / 12},
                                     {0.01, 10, 0.01});
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 2e-4}}\nparts: {{block: {{box: {{size: [0.3, 0.2, 0.1], cells: [1, 1, 1]}}, at: "
      "[-0.15, "
      "-0.1, -0.05], material: steel, rigid: true}}}}\ninitial: [{{part: block, angular_velocity: [0.01, 10, 0.01]}}]\n"
      "output: {{history: {{every: 0}}}}\n{}",
      1.1 * over, materials));
  double found = 0, before = 1;
  for (std::size_t row = 0; row < run.history.rows() && found == 0; ++row) {
    const double q1 = run.history["body_q1:block"][row], q3 = run.history["body_q3:block"][row];
    const double along = 1 - 2 * (q1 * q1 + q3 * q3);  // y of its middle axis
    const auto& time = run.history["time"];
    if (before > 0 && along <= 0) found = time[row] - (time[row] - time[row - 1]) * along / (along - before);
    before = along;
  }
  EXPECT_NEAR(found, over, 1e-3 * over);
}

}  // namespace percuss::test::exact_inertia_test
