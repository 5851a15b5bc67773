// Damage that evolves: the energy by area that a crack takes, on elements of any size; solids and layers of shells.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/deaths.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::softening_test {
namespace {

constexpr double young = 200e3, yield = 300, energy = 30;  // MPa, MPa, N/mm

std::string make_law(const std::string& failure, double share = 1) {
  return fmt::format(
      "{{model: j2_plasticity, density: 7.85e-9, youngs_modulus: {}, poissons_ratio: 0.3, yield_stress: {:.17g}{}}}",
      young, share * yield, failure.empty() ? "" : ", failure: {" + failure + "}");
}

/// An element of the given shape is drawn along x at 500 mm/s, its sides free.
Outcome pull(const std::string& shape, double size, const std::string& failure, const std::string& held,
             double end = 1e-3) {
  return run_deck(fmt::format(R"(
title: an element softens
units: mm, t, s
time: {{end: {}}}
parts: {{e: {{{}, material: m}}}}
materials: {{m: {}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
conditions:
  - {{nodes: e/x_min, fixed: [x]}}
  - {{nodes: e/x_max, velocity: {{x: {{table: [[0, 0], [2e-5, {}], [5e-3, {}]]}}}}}}
{}output: {{history: {{every: 0, elements: [{{name: e, id: 1}}]}}}}
)",
                              end, shape, make_law(failure), 200 * size, 200 * size,
                              held.empty() ? "" : fmt::format("  - {{nodes: all, fixed: [{}]}}\n", held)));
}

/// Energy that elements have absorbed, eroded ones too.
double find_absorbed(const HistoryTable& history) { return history.last("internal") + history.last("eroded_energy"); }

std::string cube(double size) { return fmt::format("box: {{size: [{0}, {0}, {0}], cells: [1, 1, 1]}}", size); }

/// Energy of an element until the onset at a plastic strain: by volume.
double find_energy_until(double strain) { return 0.5 * yield * yield / young + yield * strain; }

TEST(Softening, SpendsTheEnergyByAreaOnCubesOfAnySize) {
  for (const double size : {1.0, 2.0, 4.0}) {
    const Outcome run = pull(cube(size), size, "plastic_strain: 0.01, evolution: {energy: 30}", "", 4e-3);
    EXPECT_EQ(run.history.last("eroded_elements"), 1);
    const double exact = std::pow(size, 3) * find_energy_until(0.01) + energy * size * size;
    EXPECT_NEAR(find_absorbed(run.history), exact, 4e-3 * exact) << size;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
  }
}

// By a displacement the force falls along a straight line: half of it at half of the displacement, with three quarters
// of the energy spent.
TEST(Softening, FallsAlongAStraightLineOverTheDisplacement) {
  const double size = 2, opening = 0.2, onset = 0.01;
  const Outcome run =
      pull(cube(size), size, fmt::format("plastic_strain: {}, evolution: {{displacement: {}}}", onset, opening), "");
  const HistoryTable& h = run.history;
  const std::size_t half =
      find_row(h, [&](std::size_t row) { return h["e_eps"][row] >= onset + 0.5 * opening / size; });
  ASSERT_LT(half, h.rows());
  const double crack = 0.5 * yield * opening * size * size, before = std::pow(size, 3) * find_energy_until(onset);
  EXPECT_NEAR(h["internal"][half], before + 0.75 * crack, 4e-3 * (before + crack));
  EXPECT_NEAR(h["e_stress_xx"][half], 0.5 * yield, 4e-3 * yield);
  EXPECT_NEAR(find_absorbed(h), before + crack, 4e-3 * (before + crack));
}

TEST(Softening, OfShellsTakesTheLayersStress) {
  const double size = 2, thickness = 0.5;
  const Outcome run =
      pull(fmt::format("shell_plate: {{size: [{0}, {0}], cells: [1, 1]}}, thickness: {1}, points: 3", size, thickness),
           size, "plastic_strain: 0.01, evolution: {energy: 30}", "z, rx, ry, rz", 4e-3);
  EXPECT_EQ(run.history.last("eroded_elements"), 1);
  const double exact = size * size * thickness * find_energy_until(0.01) + energy * size * thickness;
  EXPECT_NEAR(find_absorbed(run.history), exact, 4e-3 * exact);
}

/// The share of the force that an exponential leaves at a progress from 0 to 1, and its mean.
double find_left(double exponent, double progress) {
  return (std::exp(-exponent * progress) - std::exp(-exponent)) / (1 - std::exp(-exponent));
}
double find_mean_left(double exponent) { return 1 / exponent - 1 / std::expm1(exponent); }

TEST(Softening, FallsExponentiallyOverTheDisplacement) {
  const double size = 2, opening = 0.3, onset = 0.01, exponent = 3;
  const Outcome run =
      pull(cube(size), size,
           fmt::format("plastic_strain: {}, evolution: {{displacement: {}, exponent: 3}}", onset, opening), "");
  const HistoryTable& h = run.history;
  for (const double progress : {0.2, 0.5, 0.9}) {
    const std::size_t row =
        find_row(h, [&](std::size_t i) { return h["e_eps"][i] >= onset + progress * opening / size; });
    ASSERT_LT(row, h.rows());
    EXPECT_NEAR(h["e_stress_xx"][row], yield * find_left(exponent, progress), 4e-3 * yield) << progress;
  }
  const double exact =
      std::pow(size, 3) * find_energy_until(onset) + yield * opening * find_mean_left(exponent) * size * size;
  EXPECT_NEAR(find_absorbed(h), exact, 4e-3 * exact);
}

TEST(Softening, SpendsTheEnergyByAreaAlongAnyCurve) {
  for (const std::string curve : {"exponent: 4", "table: [[0, 0], [0.2, 0.6], [1, 1]]"}) {
    for (const double size : {1.0, 2.0, 4.0}) {
      const Outcome run =
          pull(cube(size), size, fmt::format("plastic_strain: 0.01, evolution: {{energy: 30, {}}}", curve), "", 4e-3);
      EXPECT_EQ(run.history.last("eroded_elements"), 1);
      const double exact = std::pow(size, 3) * find_energy_until(0.01) + energy * size * size;
      EXPECT_NEAR(find_absorbed(run.history), exact, 4e-3 * exact) << size << curve;
    }
  }
}

/// The share of force that a coupling leaves at a plastic strain.
struct Coupling {
  double failure_strain, start, damage_exponent, exponent;

  double find_damage(double strain) const { return std::pow(strain / failure_strain, damage_exponent); }
  double find_left(double strain) const {
    const double first = find_damage(start), damage = find_damage(strain);
    return strain <= start ? 1 : 1 - std::pow((damage - first) / (1 - first), exponent);
  }
  /// The integral of the share over the plastic strain until failure.
  double find_strain() const {
    const int count = 10000;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += find_left((i + 0.5) / count * failure_strain);
    return sum * failure_strain / count;
  }
};

/// An element that is pulled until the damage of the coupling is 1: the stress on the way, and the energy.
void expect_coupling(const std::string& shape, const std::string& held, const std::string& start, const Coupling& exact,
                     double volume) {
  const Outcome run = pull(shape, 2,
                           fmt::format("triaxiality: [[0, {}]], coupling: {{{}, damage_exponent: {}, exponent: {}}}",
                                       exact.failure_strain, start, exact.damage_exponent, exact.exponent),
                           held);
  const HistoryTable& h = run.history;
  for (const double strain : {0.5, 0.75, 0.95}) {
    const std::size_t row = find_row(h, [&](std::size_t i) { return h["e_eps"][i] >= strain * exact.failure_strain; });
    ASSERT_LT(row, h.rows());
    // the sides of a cube, which are free, oscillate by 0.6 % of the stress
    EXPECT_NEAR(h["e_stress_xx"][row], yield * exact.find_left(h["e_eps"][row]), 8e-3 * yield) << shape << strain;
  }
  EXPECT_EQ(h.last("eroded_elements"), 1);
  const double energy = volume * (0.5 * yield * yield / young + yield * exact.find_strain());
  EXPECT_NEAR(find_absorbed(h), energy, 4e-3 * energy) << shape;
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

TEST(Coupling, TakesTheStressByTheDamageOfElementsOfAnyKind) {
  const Coupling exact{0.1, 0.02, 2, 1.5};
  const std::string plate = "shell_plate: {size: [2, 2], cells: [1, 1]}, thickness: 0.5, points: 3";
  expect_coupling(cube(2), "", "strain: [[0, 0.02]]", exact, 8);
  expect_coupling(cube(2), "", "damage: 0.04", exact, 8);
  expect_coupling(cube(2) + ", integration: full", "", "strain: [[0, 0.02]]", exact, 8);
  expect_coupling(plate, "z, rx, ry, rz", "strain: [[0, 0.02]]", exact, 2);
}

TEST(Coupling, BeginsLaterOrFallsByTheSizeOfTheElement) {
  const Coupling exact{0.05, 0.02, 1, 3};  // half of the failure strain of 0.1; the exponent of edges of 2 mm
  const Outcome run = pull(cube(2), 2,
                           "triaxiality: [[0, 0.1]], size: [[1, 0.75], [3, 0.25]], coupling: {strain: [[0, 0.02]], "
                           "exponent_of_size: [[1, 2], [3, 4]]}",
                           "");
  const HistoryTable& h = run.history;
  const std::size_t row = find_row(h, [&](std::size_t i) { return h["e_eps"][i] >= 0.04; });
  ASSERT_LT(row, h.rows());
  EXPECT_NEAR(h["e_stress_xx"][row], yield * exact.find_left(h["e_eps"][row]), 5e-3 * yield);
}

// In tension the ratio is 2 - 2/3 k; the damage of the mean stress would take twice as long.
TEST(ShearDamage, BeginsTheEvolutionOfATensileTest) {
  const double size = 2, opening = 0.2;
  const std::string shear = "shear: {strain: [[1, 0.1], [1.8, 0.02], [2, 0.01]], pressure_factor: 0.3}";
  const Outcome run =
      pull(cube(size), size,
           fmt::format("triaxiality: [[0, 0.04]], {}, evolution: {{displacement: {}}}", shear, opening), "");
  const double exact = std::pow(size, 3) * find_energy_until(0.02) + 0.5 * yield * opening * size * size;
  EXPECT_NEAR(find_absorbed(run.history), exact, 4e-3 * exact);
}

/// Energy by area of what is lost as a bar of cubes, 16 mm long, breaks at its weakest.
double break_bar(int cells, const std::string& failure) {
  const double size = 16.0 / cells;
  return run_deck(fmt::format(R"(
title: a bar breaks
units: mm, t, s
time: {{end: 1e-3}}
parts:
  bar: {{box: {{size: [{0:.17g}, {2:.17g}, {2:.17g}], cells: [{1}, 1, 1]}}, material: whole}}
  neck: {{box: {{size: [{2:.17g}, {2:.17g}, {2:.17g}], cells: [1, 1, 1]}}, at: [{0:.17g}, 0, 0], material: weak}}
join: [{{parts: [bar, neck]}}]
materials:
  whole: {3}
  weak: {4}
conditions:
  - {{nodes: bar/x_min, fixed: [x]}}
  - {{nodes: neck/x_max, velocity: {{x: {{table: [[0, 0], [1e-4, 500], [1e-3, 500]]}}}}}}
output: {{history: {{every: 1e-6}}}}
)",
                              16.0 - size, cells - 1, size, make_law(""), make_law(failure, 0.8)))
             .history.last("eroded_energy") /
         (size * size);
}

// The energy of a break is that of the crack on meshes of 4, 2 and 1 mm, with some of hourglass and viscous forces;
// without evolution it is that of the element.
TEST(Softening, LetsBarsOfThreeMeshesBreakWithTheSameEnergy) {
  const double onset = 1e-3;
  for (const int cells : {4, 8, 16}) {
    const double size = 16.0 / cells;
    const double work = break_bar(cells, "plastic_strain: 1e-3, evolution: {energy: 30}");
    EXPECT_NEAR(work, energy + size * 0.8 * yield * onset, 0.05 * energy) << size;
  }
  for (const int cells : {4, 8, 16}) {
    const double size = 16.0 / cells;
    const double work = break_bar(cells, "plastic_strain: 1e-3, evolution: {energy: 30, exponent: 2}");
    EXPECT_NEAR(work, energy + size * 0.8 * yield * onset, 0.05 * energy) << size;
  }
  EXPECT_GT(break_bar(4, "plastic_strain: 0.05"), 3 * break_bar(16, "plastic_strain: 0.05"));
}

// Tension without a constraint has a third of von Mises' stress as its mean, plane strain tension 0.577 of it.
TEST(Triaxiality, GivesTheFailureStrainOfTheStressState) {
  const std::string failure = "triaxiality: [[0, 0.5], [0.3333333, 0.2], [0.5773503, 0.08]]";
  const auto find_strain = [&](const std::string& held) {
    const Outcome run = pull(cube(1), 1, failure, held, 4e-3);
    const std::size_t death = find_death(run.history);
    return death < run.history.rows() ? run.history["e_eps"][death - 1] : 0;
  };
  EXPECT_NEAR(find_strain(""), 0.2, 1e-3);
  EXPECT_NEAR(find_strain("y"), 0.08, 2e-3);
}

}  // namespace
}  // namespace percuss::test::softening_test
