// Fluids that begin at rest by start.hydrostatic: they stay there, with the pressure of their depth.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "src/error.hpp"
#include "tests/verification/fluids/tank.hpp"
#include "tests/verification/support/mapped_mesh.hpp"

namespace percuss::test::hydrostatic_test {
namespace {

constexpr const char* at_the_top = "hydrostatic: [{parts: [w], surface: [0, 0, 0.5]}]";
/// Potential energy of the water above its bottom, rho g h / 2 of its volume.
constexpr double potential = 1000 * gravity * 0.5 * tank_depth * tank_length * 0.05 * tank_depth;

Tank make_rest(double bulk_modulus, const std::string& shape = Tank().shape) {
  Tank tank;
  tank.bulk_modulus = bulk_modulus;
  tank.shape = shape;
  tank.start = at_the_top;
  return tank;
}

Outcome expect_rest(const Tank& tank, double share) {
  const Outcome run = run_deck(make_tank(tank));
  const double most = std::max(run.history.largest("kinetic"), -run.history.smallest("kinetic"));
  fmt::print("kinetic energy at most {:.2g} of the potential one, last {:.2g}\n", most / potential,
             run.history.last("kinetic") / potential);
  EXPECT_LT(most, share * potential);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-8);
  return run;
}

/// Water of a depth in a shaft of one element, which begins and stays at rest.
Outcome fill_shaft(double depth, int cells) {
  return run_deck(fmt::format(R"(
title: a shaft of water
time: {{end: {end:.17g}}}
parts: {{w: {{box: {{size: [{wide:.17g}, {wide:.17g}, {depth:.17g}], cells: [1, 1, {cells}]}}, material: water}}}}
materials: {{water: {{model: fluid, density: 1000, equation_of_state: {{kind: linear, bulk_modulus: 2.2e+9}}}}}}
conditions:
  - {{nodes: w, fixed: [x, y]}}
  - {{nodes: w/z_min, fixed: [z]}}
loads: {{gravity: [0, 0, -9.81]}}
start: {{hydrostatic: [{{parts: [w], surface: [0, 0, {depth:.17g}]}}]}}
output:
  history:
    every: {every:.17g}
    elements: [{{name: low, near: [0, 0, 0]}}]
    forces: [{{name: bottom, support: w/z_min}}]
)",
                              fmt::arg("end", depth / 100), fmt::arg("every", depth / 1e4), fmt::arg("depth", depth),
                              fmt::arg("wide", depth / cells), fmt::arg("cells", cells)));
}

double find_closed_form(double depth) { return 2.2e9 * (std::exp(1000 * gravity * depth / 2.2e9) - 1); }

}  // namespace

TEST(Hydrostatic, ATankOfTenLayersStaysAtRest) {
  expect_rest(make_rest(4e6), 1e-10);
  expect_rest(make_rest(2.2e9), 1e-15);
}

TEST(Hydrostatic, OtherElementsStayAtRest) {
  Tank full = make_rest(4e6);
  full.more = "elements: {integration: full}";
  expect_rest(full, 1e-10);
  Tank plain = make_rest(4e6, "box: {size: [1, 0.05, 0.5], cells: [10, 1, 5]}, elements: tetrahedra");
  plain.more = "elements: {tetrahedra: plain}";
  expect_rest(plain, 1e-10);
}

/// Averages over nodes smear the pressure at the surface and at walls.
TEST(Hydrostatic, ElementsThatAverageHardlyMove) {
  for (const char* const kind : {"wedges", "pyramids", "tetrahedra"})
    expect_rest(make_rest(4e6, fmt::format("box: {{size: [1, 0.05, 0.5], cells: [10, 1, 5]}}, elements: {}", kind)),
                5e-6);
}

/// Inner nodes are off their lattice by up to a fifth of an element.
TEST(Hydrostatic, AnIrregularMeshStaysAtRest) {
  std::uint64_t seed = 7;
  const auto next = [&] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 33) / 4294967296.0 - 0.25;
  };
  const auto mesh = make_mapped_box({20, 1, 10}, [&](const Vec3& u) {
    const double dx = 0.02 * next(), dz = 0.02 * next();
    const bool is_inside = u[0] > 0.01 && u[0] < 0.99 && u[2] > 0.01 && u[2] < 0.99;
    return Vec3{u[0] + (is_inside ? dx : 0), 0.05 * u[1], 0.5 * u[2] + (is_inside ? dz : 0)};
  });
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "irregular_rest.exo"));
  expect_rest(make_rest(4e6, fmt::format("exodus: {{file: {}}}", file.path())), 1e-10);
}

/// rho g h of half a metre; of 4 km, where the closed form is 0.9 % more.
TEST(Hydrostatic, ThePressureIsThatOfTheDepth) {
  for (const double depth : {0.5, 4000.0}) {
    constexpr int cells = 10;
    const Outcome run = fill_shaft(depth, cells);
    const double there = depth * (1 - 0.5 / cells), exact = find_closed_form(there);
    const double area = depth * depth / (cells * cells), weight = find_closed_form(depth) * area;
    fmt::print("{} m: {:.9g} of the closed form, {:.6g} of rho g h, the bottom carries {:.9g} of the weight\n", depth,
               run.history["low_pressure"][0] / exact, exact / (1000 * gravity * there),
               run.history.last("fz:bottom") / weight);
    EXPECT_NEAR(run.history["low_pressure"][0], exact, 1e-8 * exact);
    EXPECT_NEAR(run.history.last("low_pressure"), exact, 1e-4 * exact);
    EXPECT_NEAR(run.history.last("fz:bottom"), weight, 1e-4 * weight);
    EXPECT_NEAR(run.summary.energy.initial, run.history["internal"][0], 1e-9 * run.history["internal"][0]);
  }
}

/// Oil on water under an atmosphere, which a load carries.
TEST(Hydrostatic, LayersOfFluidsStayAtRest) {
  const Outcome run = run_deck(R"(
title: oil on water
time: {end: 0.5}
parts:
  water: {box: {size: [0.4, 0.1, 0.2], cells: [8, 2, 4]}, material: water}
  oil: {box: {size: [0.4, 0.1, 0.1], cells: [8, 2, 2]}, at: [0, 0, 0.2], material: oil}
join: true
materials:
  water: {model: fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2.2e+9}}
  oil: {model: fluid, density: 850, equation_of_state: {kind: mie_grueneisen, sound_speed: 1300, slope: 1.9, grueneisen: 0.5}}
conditions:
  - {nodes: {name: all, inside: [[-1, -1, -1], [1e-6, 2, 2]]}, fixed: [x]}
  - {nodes: {name: all, inside: [[0.399999, -1, -1], [2, 2, 2]]}, fixed: [x]}
  - {nodes: {name: all, inside: [[-1, -1, -1], [2, 1e-6, 2]]}, fixed: [y]}
  - {nodes: {name: all, inside: [[-1, 0.099999, -1], [2, 2, 2]]}, fixed: [y]}
  - {nodes: water/z_min, fixed: [z]}
loads:
  gravity: [0, 0, -9.81]
  pressure: [{faces: oil/z_max, value: 1.0e+5}]
start:
  hydrostatic:
    - {parts: [oil], surface: [0, 0, 0.3], pressure: 1.0e+5}
    - {parts: [water], surface: [0, 0, 0.2], pressure: 100833.85}
output: {history: {every: 0.01, elements: [{name: low, near: [0, 0, 0]}]}}
)");
  fmt::print("kinetic energy {:.2g} J, pressure {:.9g}\n", run.history.largest("kinetic"),
             run.history.last("low_pressure"));
  EXPECT_LT(run.history.largest("kinetic"), 1e-9);
  EXPECT_NEAR(run.history.last("low_pressure"), 100833.85 + 1000 * gravity * 0.175, 0.5);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
}

TEST(Hydrostatic, ARelaxationHasNothingToDo) {
  Tank tank = make_rest(4e6);
  tank.start += ", relaxation: {ramp: 0}";
  const Outcome run = expect_rest(tank, 1e-10);
  EXPECT_EQ(run.summary.relaxation.state, "settled");
}

TEST(Hydrostatic, APartAboveTheSurfaceIsRefused) {
  Tank tank;
  tank.start = "hydrostatic: [{parts: [w], surface: [0, 0, 0.4]}]";
  try {
    run_deck(make_tank(tank));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("part 'w' rises 0.1 above the surface of its fluid"));
  }
}

}  // namespace percuss::test::hydrostatic_test
