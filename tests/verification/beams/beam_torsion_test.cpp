// Shafts that twist, spin and stop, and a coil spring: beams whose nodes have the polar inertia of their section.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::beam_torsion_test {
namespace {

constexpr double pi = std::numbers::pi, young = 200e9, density = 7850, shear = young / 2.6;
const double speed = std::sqrt(shear / density);  // of waves of torsion in a round section

const std::string steel =
    "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

/// A shaft along x, of length 1.
std::string describe_shaft(int cells, const std::string& section, const std::string& rest) {
  return fmt::format(
      "parts: {{shaft: {{line: {{from: [0, 0, 0], to: [1, 0, 0], cells: {}}}, section: {}, toward: y, material: "
      "steel}}}}\n{}{}",
      cells, section, steel, rest);
}

/// Mean frequency of a column between its rises through zero after a time.
double find_frequency(const HistoryTable& history, const std::string& column, double from) {
  const auto &value = history[column], &time = history["time"];
  double first = 0, last = 0;
  int rises = -1;
  for (std::size_t row = 1; row < history.rows(); ++row) {
    if (time[row - 1] < from || !(value[row - 1] < 0 && value[row] >= 0)) continue;
    last = time[row - 1] + (time[row] - time[row - 1]) * value[row - 1] / (value[row - 1] - value[row]);
    if (++rises == 0) first = last;
  }
  return rises / (last - first);
}

/// A pulse at the free end whose length is a period has no part at the odd multiples of the first frequency.
double find_torsion_frequency(int cells, const std::string& section, double expected) {
  const double period = 1 / expected;
  const Outcome run = run_deck(describe_shaft(
      cells, section,
      fmt::format("time: {{end: {}}}\nconditions: [{{nodes: shaft/start, fixed: [x, y, z, rx, ry, rz]}}]\n"
                  "loads: {{nodal: [{{nodes: shaft/end, moment: {{x: {{expression: \"t < {} ? 10 * sin(pi * t / {})^2 "
                  ": 0\"}}}}}}]}}\noutput: {{history: {{every: {}}}}}\n",
                  8 * period, period, period, period / 200)));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  return find_frequency(run.history, "angular_x", period);
}

}  // namespace

// sqrt(G / rho) / (4 L) of a round shaft, whatever its elements; in others sqrt(J / I_p) of that.
TEST(Torsion, FrequencyIsThatOfTheShaftOnEveryMesh) {
  const double round = speed / 4;
  for (const int cells : {5, 10, 20, 40})
    EXPECT_NEAR(find_torsion_frequency(cells, "{round: {radius: 0.01}}", round), round, 0.01 * round) << cells;
  EXPECT_NEAR(find_torsion_frequency(20, "{tube: {outer_radius: 0.02, inner_radius: 0.018}}", round), round,
              0.01 * round);
  const double strip = round * std::sqrt(0.1 / 0.425);  // J and I_y + I_z as given
  const std::string section =
      "{general: {area: 4e-4, inertia_y: 4e-9, inertia_z: 38.5e-9, torsion: 10e-9, shear_area_y: 3.3e-4, shear_area_z: "
      "3.3e-4}}";
  EXPECT_NEAR(find_torsion_frequency(20, section, strip), strip, 0.01 * strip);
  const double given = round * std::sqrt(0.1 / 0.9);  // of a section whose rotary inertia is given
  EXPECT_NEAR(find_torsion_frequency(20, section.substr(0, section.size() - 2) + ", polar_inertia: 90e-9}}", given),
              given, 0.01 * given);
}

// A shaft that spins is stopped at one end: the torque there is rho c J w until the wave is back, and the angular
// momentum falls evenly to its opposite.
TEST(Torsion, StoppedShaftHasTheTorqueOfTheWave) {
  const double spin = 100, radius = 0.01, j = pi / 2 * std::pow(radius, 4), there = 1 / speed;
  const Outcome run = run_deck(describe_shaft(
      200, "{round: {radius: 0.01}}",
      fmt::format("time: {{end: {}}}\ninitial: [{{part: shaft, angular_velocity: [{}, 0, 0]}}]\n"
                  "conditions: [{{nodes: shaft/start, fixed: [x, y, z, rx, ry, rz]}}]\n"
                  "output: {{history: {{every: {}, forces: [{{name: clamp, support: shaft/start}}]}}}}\n",
                  1.8 * there, spin, there / 400)));
  const double whole = density * j * spin, torque = density * speed * j * spin;
  EXPECT_NEAR(run.history.at(0.5 * there, "angular_x"), 0.5 * whole, 0.01 * whole);
  EXPECT_NEAR(run.history.at(there, "angular_x"), 0, 0.01 * whole);
  EXPECT_NEAR(run.history.at(1.5 * there, "angular_x"), -0.5 * whole, 0.01 * whole);
  EXPECT_NEAR(-run.history.mean(0.2 * there, 1.6 * there, "mx:clamp"), torque, 0.01 * torque);
  EXPECT_NEAR(run.history["angular_x"].front(), whole, 0.01 * whole);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

// A free shaft that tumbles and spins about its axis: I_p about it, m L^2 / 12 across. It precesses, and keeps its
// momentum, its energy and its spin about its own axis.
TEST(Torsion, FreeShaftSpinsAsATop) {
  const double radius = 0.05, mass = density * pi * radius * radius, about = mass * radius * radius / 2,
               across = mass * (1.0 / 12 + radius * radius / 4);
  const double axial = 300, tumble = 20;
  const Outcome run = run_deck(describe_shaft(
      20, "{round: {radius: 0.05}}",
      fmt::format("time: {{end: 0.1}}\ninitial: [{{part: shaft, angular_velocity: [{}, 0, {}]}}]\n"
                  "output: {{history: {{every: 1e-3, nodes: [{{name: a, near: [0, 0, 0]}}, {{name: b, near: [1, 0, "
                  "0]}}]}}}}\n",
                  axial, tumble)));
  EXPECT_LT(run.summary.momentum.angular_error, 1e-10);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_NEAR(run.history["angular_x"].front(), about * axial, 0.01 * about * axial);
  // The axis turns about the momentum, L / I across, at a fixed angle to it.
  const double lx = about * axial, lz = across * tumble, l = std::hypot(lx, lz), rate = l / across;
  for (const double time : {0.03, 0.07, 0.1}) {
    std::array<double, 3> axis{};
    const char* const names[3] = {"_x", "_y", "_z"};
    for (std::size_t k = 0; k < 3; ++k)
      axis[k] = run.history.at(time, std::string("b") + names[k]) - run.history.at(time, std::string("a") + names[k]);
    const double size = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double along = (axis[0] * lx + axis[2] * lz) / (size * l), sideways = axis[1] / size;
    EXPECT_NEAR(along, lx / l, 0.01) << time;
    EXPECT_NEAR(sideways, lz / l * std::sin(rate * time), 0.01) << time;
  }
}

// A node of a beam turns with its inertia: what holds its rotation also turns its angular momentum, from the first
// step.
TEST(Torsion, DrivenEndsOfAnObliqueBeamGiveTheMomentumThatItGains) {
  for (const char* driven :
       {"rx: 10, ry: 3, rz: 5", "rx: {table: [[0, 10], [1e-3, 20]]}", "ry: {table: [[0, 0], [1e-3, 100]]}, rz: 5"}) {
    const Outcome run = run_deck(fmt::format(R"(
time: {{end: 2e-4}}
parts: {{b: {{line: {{from: [0, 0, 0], to: [1, 0.3, 0.2], cells: 10}}, section: {{rectangle: {{size: [0.02, 0.01]}}}}, toward: [0, 0, 1], material: m}}}}
materials: {{m: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
conditions: [{{nodes: b/start, velocity: {{x: 0, y: 0, z: 0, {0}}}}}]
output: {{history: {{every: 0, forces: [{{name: held, support: b/start}}]}}}}
)",
                                             driven));
    EXPECT_LT(run.summary.momentum.angular_error, 1e-13) << driven;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3) << driven;
  }
}

// Damping takes as much of the momentum of its nodes as it books, also where their spins are held in part.
TEST(Torsion, DampedObliqueBeamLosesTheMomentumThatIsBooked) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3}
parts:
  b: {line: {from: [0, 0, 0], to: [0.3, 0.2, 0.1], cells: 4}, section: {box: {size: [0.04, 0.02], wall: 0.004}}, toward: y, material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions: [{nodes: b/start, velocity: {rz: {table: [[0, 0], [1e-3, 300], [2e-3, 0]]}}}]
initial: [{part: b, angular_velocity: [50, 20, 0], center: [0, 0, 0]}]
damping: [{nodes: b, coefficient: 20000}]
output: {history: {every: 0}}
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(run.history.last("damping"), -0.5 * run.summary.energy.initial);
}

namespace {

using Matrix6 = std::array<std::array<double, 6>, 6>;

/// One element of the inverse of a matrix, the last one of its diagonal: by elimination.
double invert_last(Matrix6 a) {
  for (std::size_t i = 0; i + 1 < 6; ++i)
    for (std::size_t r = i + 1; r < 6; ++r) {
      const double share = a[r][i] / a[i][i];
      for (std::size_t c = i; c < 6; ++c) a[r][c] -= share * a[i][c];
    }
  return 1 / a[5][5];
}

/// A coil spring of round wire about z.
struct Coil {
  double radius = 0.05, wire = 0.005, height = 0.12;
  int turns = 4;

  double length() const { return std::hypot(2 * pi * radius * turns, height); }

  /// Stiffness along z between ends that do not turn and stay on their line: from the flexibility of the curved wire.
  double find_stiffness() const {
    const double area = pi * wire * wire, inertia = area * wire * wire / 4, torsion = 2 * inertia;
    constexpr int pieces = 4000;
    Matrix6 flexibility{};
    for (int i = 0; i < pieces; ++i) {
      const double share = (i + 0.5) / pieces, angle = 2 * pi * turns * share, ds = length() / pieces;
      const std::array<double, 3> tangent{-2 * pi * turns * radius * std::sin(angle) / length(),
                                          2 * pi * turns * radius * std::cos(angle) / length(), height / length()};
      const std::array<double, 3> arm{radius - radius * std::cos(angle), -radius * std::sin(angle),
                                      height * (1 - share)};  // to the end
      // Unit loads at the end: moments x, y, z, forces x, y, z.
      std::array<std::array<double, 3>, 6> moment{}, force{};
      for (std::size_t k = 0; k < 3; ++k) {
        moment[k][k] = 1;
        force[3 + k][k] = 1;
        moment[3 + k][(k + 1) % 3] = arm[(k + 2) % 3];
        moment[3 + k][(k + 2) % 3] = -arm[(k + 1) % 3];
      }
      for (std::size_t r = 0; r < 6; ++r)
        for (std::size_t c = 0; c < 6; ++c) {
          const auto product = [&](const auto& u, double along, double across) {
            double ut = 0, vt = 0, uv = 0;
            for (std::size_t k = 0; k < 3; ++k) {
              ut += u[r][k] * tangent[k];
              vt += u[c][k] * tangent[k];
              uv += u[r][k] * u[c][k];
            }
            return ut * vt / along + (uv - ut * vt) / across;
          };
          flexibility[r][c] += ds * (product(moment, shear * torsion, young * inertia) +
                                     product(force, young * area, 0.9 * shear * area));
        }
    }
    return invert_last(flexibility);
  }
};

}  // namespace

// A coil spring under an axial load, clamped at one end and guided at the other: the stiffness of curved wire, and the
// surge frequency sqrt(k / m) / 4, on two meshes.
TEST(Torsion, CoilSpringSurgesAsItsWire) {
  const Coil coil;
  const double stiffness = coil.find_stiffness();
  const double mass = density * pi * coil.wire * coil.wire * coil.length(), frequency = std::sqrt(stiffness / mass) / 4;
  for (const int cells : {24, 48}) {
    const double period = 1 / frequency;
    const Outcome run = run_deck(fmt::format(
                                     R"yaml(
parts: {{coil: {{line: {{from: [0, 0, 0], to: [0, 0, {0}], cells: {1}}}, section: {{round: {{radius: {2}}}}}, toward: x, material: steel}}}}
imperfections:
  - {{nodes: coil, direction: x, mode: "{3} * cos(2 * pi * {4} * z / {0})"}}
  - {{nodes: coil, direction: y, mode: "{3} * sin(2 * pi * {4} * z / {0})"}}
conditions:
  - {{nodes: coil/start, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: coil/end, fixed: [x, y, rx, ry, rz]}}
loads: {{nodal: [{{nodes: coil/end, force: {{z: {{expression: "t < {5} ? sin(pi * t / {5})^2 : 0"}}}}}}]}}
time: {{end: {6}}}
output: {{history: {{every: {7}, nodes: [{{name: tip, near: [{3}, 0, {0}]}}]}}}}
)yaml",
                                     coil.height, cells * coil.turns, coil.wire, coil.radius, coil.turns, period,
                                     5 * period, period / 100) +
                                 steel);
    EXPECT_NEAR(find_frequency(run.history, "momentum_z", period), frequency, 0.01 * frequency) << cells;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  }
}

}  // namespace percuss::test::beam_torsion_test
