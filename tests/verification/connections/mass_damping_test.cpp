// Damping in proportion to mass: free flight, spins and a hanging bar have closed forms.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "src/error.hpp"
#include "tests/verification/connections/two_cubes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::mass_damping_test {
namespace {

constexpr double coefficient = 50, dt = 4e-5;
constexpr int steps = 1000;

/// A body that nothing holds, in steps of dt.
std::string describe_flight(const std::string& part, const std::string& damping, const std::string& velocity) {
  return fmt::format(R"yaml(
time: {{end: {}, max_step: {}}}
parts: {{a: {{{}, material: m}}}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
initial: [{{part: a, {}}}]
{}
output: {{history: {{every: 0}}}}
)yaml",
                     steps * dt, dt, part, velocity, damping);
}
const std::string block = "box: {size: [1, 2, 3], cells: [2, 2, 2]}";
const std::string damped = fmt::format("damping: [{{coefficient: {}}}]", coefficient);

/// What is left of a velocity after n steps: half a step, then whole ones.
double find_left(double n) {
  const double half = 0.25 * coefficient * dt, whole = 0.5 * coefficient * dt;
  return n == 0 ? 1 : (1 - half) / (1 + half) * std::pow((1 - whole) / (1 + whole), n - 1);
}

void expect_decay(const Outcome& run, double speed) {
  const double mass = 6000;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double v = speed * find_left(run.history["step"][row]);
    ASSERT_NEAR(run.history["momentum_x"][row], mass * v, 1e-10 * mass * speed);
    ASSERT_NEAR(run.history["damping"][row], 0.5 * mass * (v * v - speed * speed), 1e-10 * mass * speed * speed);
  }
  EXPECT_EQ(run.history.rows(), steps + 1);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

}  // namespace

TEST(MassDamping, SlowsFreeFlightAsItsDifferenceEquation) {
  expect_decay(run_deck(describe_flight(block, damped, "velocity: [3, 0, 0]")), 3);
  EXPECT_NEAR(find_left(steps), std::exp(-coefficient * steps * dt),
              1e-2);  // rows have velocities of half a step before
  EXPECT_NEAR(find_left(steps), std::exp(-coefficient * (steps - 0.5) * dt), 1e-6);
}

TEST(MassDamping, SlowsARigidBodyLikewise) {
  expect_decay(run_deck(describe_flight(block + ", rigid: true", damped, "velocity: [3, 0, 0]")), 3);
}

TEST(MassDamping, SlowsTheSpinOfBodiesShellsAndBeams) {
  for (const std::string& part :
       {block + ", rigid: true", block, std::string("shell_plate: {size: [2, 2], cells: [4, 4]}, thickness: 0.1"),
        std::string("line: {from: [0, 0, 0], to: [1, 0.5, 0.2], cells: 3}, section: {box: {size: [0.2, 0.1], wall: "
                    "0.02}}, toward: y")}) {
    const Outcome run = run_deck(describe_flight(part, damped, "angular_velocity: [0, 0, 0.5]"));
    const double start = run.history["angular_z"][0];
    EXPECT_NEAR(run.history.last("angular_z"), start * find_left(steps), 1e-5 * start) << part;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12) << part;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-5) << part;
  }
}

// Critical damping of the lowest mode: the end sinks by rho g L^2 / (2 E), which linear elements have at their nodes.
TEST(MassDamping, BringsAHangingBarToRest) {
  const double rho = 1000, g = 10, length = 2, modulus = 1e8;
  const double frequency = 0.5 * M_PI / length * std::sqrt(modulus / rho);
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 0.3}}
parts: {{bar: {{box: {{size: [0.1, 0.1, {}], cells: [1, 1, 20]}}, material: m}}}}
materials: {{m: {{model: elastic, density: {}, youngs_modulus: {}, poissons_ratio: 0}}}}
loads: {{gravity: [0, 0, -{}]}}
conditions: [{{nodes: bar/z_max, fixed: [x, y, z]}}]
damping: [{{nodes: bar, coefficient: {}}}]
output: {{history: {{every: 0.01, nodes: [{{name: tip, near: [0, 0, 0]}}]}}}}
)yaml",
                                           length, rho, modulus, g, 2 * frequency));
  const double sag = rho * g * length * length / (2 * modulus);
  EXPECT_NEAR(-run.history.last("tip_z"), sag, 2 * sag * rho * g * length / modulus);  // strains are finite
  EXPECT_LT(run.history.last("kinetic"), 1e-12 * run.history.last("internal"));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

TEST(MassDamping, ObeysTheLastEntryThatNamesANode) {
  expect_decay(run_deck(describe_flight(
                   block, fmt::format("damping: [{{coefficient: 1e6}}, {{nodes: a, coefficient: {}}}]", coefficient),
                   "velocity: [3, 0, 0]")),
               3);
}

/// A block of 1e4 N that comes to rest, in steps of which damping takes three quarters of the velocity. connection:
/// what it rests on or hangs from.
struct Resting {
  const char* name;
  std::string rigid, connection, force;
  std::vector<std::string> columns;  // whose sum is its weight
  double tolerance = 1e-9;
  const char *largest_step = ", max_step: 0.002", *damped = "block";
  double coefficient = 600;
};

void PrintTo(const Resting& resting, std::ostream* out) { *out << resting.name; }

Outcome run_resting(const Resting& of) {
  return run_deck(fmt::format(R"yaml(
time: {{end: 1{}}}
parts:
  base: {{box: {{size: [1, 1, 1], cells: [2, 2, 2]}}, at: [0, 0, -1], material: m}}
  block: {{box: {{size: [1, 1, 1], cells: [2, 2, 2]}}, material: m{}}}
  flyer: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, at: [9, 0, 9], material: m}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
conditions: [{{nodes: base, fixed: [x, y, z]}}, {{nodes: flyer, fixed: [z]}}]
initial: [{{part: flyer, velocity: [0.01, 0, 0]}}]
loads: {{gravity: [0, 0, -10]}}
damping: [{{nodes: {}, coefficient: {}}}]
{}
output: {{history: {{every: 0.01{}}}}}
)yaml",
                              of.largest_step, of.rigid, of.damped, of.coefficient, of.connection, of.force));
}

class MassDampingAtRest : public testing::TestWithParam<Resting> {};

// Damping takes nothing of the force that holds a body at rest, though it acts earlier in the step.
TEST_P(MassDampingAtRest, LeavesTheForceWhole) {
  constexpr double weight = 1e4;
  const Outcome run = run_resting(GetParam());
  double force = 0;
  for (const std::string& column : GetParam().columns) force += run.history.last(column);
  EXPECT_NEAR(std::abs(force), weight, GetParam().tolerance * weight);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

const std::string rigid_block = ", rigid: true", of_contact = ", forces: [{name: f, contact: [block, base]}]",
                  of_wall = ", forces: [{name: f, wall: floor}]";
const std::string floor_wall = "walls: [{name: floor, normal: z}]\n";
INSTANTIATE_TEST_SUITE_P(
    , MassDampingAtRest,
    testing::Values(
        Resting{"Wall", "", floor_wall + "contact: {surfaces: none}", of_wall, {"fz:f"}},
        Resting{"WallUnderARigidBody", rigid_block, floor_wall + "contact: {surfaces: none}", of_wall, {"fz:f"}},
        Resting{"Contact", "", "contact: {surfaces: all}", of_contact, {"fz:f"}},
        Resting{"ContactOfARigidBody", rigid_block, "contact: {surfaces: all}", of_contact, {"fz:f"}},
        Resting{"Lagrange", rigid_block, "contact: {surfaces: all, enforcement: lagrange}", of_contact, {"fz:f"}},
        Resting{"Penalty", "", "contact: {surfaces: all, enforcement: penalty}", of_contact, {"fz:f"}},
        Resting{"PenaltyUnderARigidBody",
                rigid_block,
                "contact: {surfaces: all, enforcement: penalty}",
                of_contact,
                {"fz:f"}},
        Resting{"Tie", "", "contact: {surfaces: none, ties: [{a: block/z_min, b: base}]}", of_contact, {"fz:f"}},
        Resting{"Welds",
                "",
                "contact: {surfaces: none}\nwelds: {w: {between: [block/z_min, base/z_max], normal: z}}",
                "",
                {"weld_normal:w_1", "weld_normal:w_2", "weld_normal:w_3", "weld_normal:w_4", "weld_normal:w_5",
                 "weld_normal:w_6", "weld_normal:w_7", "weld_normal:w_8", "weld_normal:w_9"}},
        Resting{"Constraint",
                "",
                "contact: {surfaces: none}\nconstraints: {c: {equal: [x, y, z], between: [block/z_min, base/z_max]}}",
                "",
                {"equal_z:c"}},
        Resting{"Joint",
                rigid_block,
                "contact: {surfaces: none}\njoints: {j: {kind: spherical, bodies: [block], at: [0.5, 0.5, 2]}}",
                "",
                {"joint_fz:j"}}),
    [](const auto& info) { return std::string(info.param.name); });

// Damping leaves the steps of springs of contact as they are: of all nodes, of one side, of what touches nothing.
TEST(MassDamping, DoesNotShortenTheStepsOfPenaltyContact) {
  Resting resting{"", "", "contact: {surfaces: all, enforcement: penalty}", of_contact, {}, 0, "", "all", 60};
  const Outcome little = run_resting(resting);
  EXPECT_LT(little.history.last("dt"), 0.99 * little.history.last("dt_element"));
  resting.coefficient = 600;
  const Outcome much = run_resting(resting);
  EXPECT_NEAR(much.history.last("dt"), little.history.last("dt"), 0.01 * little.history.last("dt"));
  resting.damped = "block";
  const Outcome one = run_resting(resting);
  EXPECT_NEAR(one.history.last("dt"), little.history.last("dt"), 0.01 * little.history.last("dt"));
  resting.damped = "base";  // which is held
  const Outcome held = run_resting(resting);
  resting.coefficient = 0;
  const Outcome none = run_resting(resting);
  EXPECT_EQ(held.history["dt"], none.history["dt"]);
}

// A damped body that moves as one with another: the damping of one slows down the mass of both, as its difference
// equation says of the common velocity.
TEST(MassDamping, OfOneOfTwoThatMoveAsOneSlowsDownBoth) {
  constexpr double c = 1e5, step = 1e-6, share = heavy / (light + heavy);
  const Outcome run = run_deck(
      make_cubes(fmt::format("constraints: {{both: {{equal: [x], nodes: all}}}}\ndamping: [{{nodes: b, coefficient: "
                             "{}}}]\ninitial: [{{part: a, velocity: [3, 0, 0]}}, {{part: b, velocity: [3, 0, 0]}}]\n",
                             c)));
  const double first = 0.25 * c * step * share, h = 0.5 * c * step * share;
  for (std::size_t row = 1; row < run.history.rows(); ++row) {
    const double v = 3 * (1 - first) / (1 + first) * std::pow((1 - h) / (1 + h), run.history["step"][row] - 1);
    ASSERT_NEAR(run.history["momentum_x"][row], (light + heavy) * v, 1e-11 * (light + heavy));
  }
  EXPECT_EQ(run.history.rows(), 101);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

// Likewise two welded plates that turn about an axis in their plane: a quarter of their inertia is rotary.
TEST(MassDamping, OfOneOfTwoWeldedPlatesSlowsTheSpinOfBoth) {
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}, max_step: {}}}
parts:
  low: {{shell_plate: {{size: [0.2, 0.2], cells: [1, 1]}}, thickness: 0.1, material: m}}
  high: {{shell_plate: {{size: [0.2, 0.2], cells: [1, 1]}}, thickness: 0.1, material: m}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
welds: {{w: {{between: [low, high]}}}}
contact: {{surfaces: none}}
initial: [{{part: all, angular_velocity: [0.5, 0, 0]}}]
damping: [{{nodes: low, coefficient: {}}}]
output: {{history: {{every: 0}}}}
)yaml",
                                           steps * dt, dt, 2 * coefficient));
  const double start = run.history["angular_x"][0];
  EXPECT_NEAR(run.history.last("angular_x"), start * find_left(steps), 1e-5 * start);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

TEST(MassDamping, RefusesToDampAPartOfABody) {
  try {
    run_deck(
        describe_flight(block + ", rigid: true", "damping: [{nodes: a/x_min, coefficient: 1}]", "velocity: [3, 0, 0]"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("names only some nodes of rigid body 'a'"));
  }
}

}  // namespace percuss::test::mass_damping_test
