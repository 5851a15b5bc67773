// Beams that touch as round bars, from the deck on, against mechanics: impacts of bars with bars and with plates, rest
// on them, friction, and what is conserved.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::beam_contact_test {
namespace {

constexpr double pi = std::numbers::pi, g = 9.81, density = 7800;

const std::string steel =
    "materials: {steel: {model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

double find_mass(double radius, double length) { return density * pi * radius * radius * length; }

/// Two round bars of one element each, crossed at their middles, 0.1 mm apart.
std::string cross_stubs(const std::string& enforcement) {
  return fmt::format(R"yaml(
time: {{end: 2e-4}}
parts:
  a: {{line: {{from: [-0.02, 0, 0], to: [0.02, 0, 0], cells: 1}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
  b: {{line: {{from: [0, -0.02, 0.0101], to: [0, 0.02, 0.0101], cells: 1}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
initial: [{{part: a, velocity: [0, 0, 5]}}, {{part: b, velocity: [0, 0, -3]}}]
contact: {{surfaces: all, beams: true, enforcement: {}}}
output: {{history: {{every: 1e-6, forces: [{{name: f, contact: [a, b]}}], nodes: [{{name: m, near: [0.02, 0, 0]}}, {{name: n, near: [0, 0.02, 0.0101]}}]}}}}
)yaml",
                     enforcement) +
         steel;
}

/// A bar of eight elements above a held rigid block, its axis `height` above the top.
std::string lay_on_block(double height, const std::string& rest) {
  return fmt::format(R"yaml(
parts:
  bar: {{line: {{from: [-0.1, 0, {0}], to: [0.1, 0, {0}], cells: 8}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
  block: {{box: {{size: [0.3, 0.5, 0.02], cells: [6, 4, 1]}}, at: [-0.15, -0.1, -0.02], material: steel, rigid: {{}}}}
conditions: [{{body: block, fixed: [x, y, z, rx, ry, rz]}}]
)yaml",
                     height) +
         rest + steel;
}

double find_impulse(const HistoryTable& history, const std::string& force) {
  double sum = 0;
  for (std::size_t i = 1; i < history.rows(); ++i)
    sum += history[force][i] * (history["time"][i] - history["time"][i - 1]);
  return sum;
}

}  // namespace

// Bars of one element have no waves: the kinematic enforcement leaves both at the speed of their mass centre, springs
// exchange their velocities.
TEST(BeamContact, StubsThatCrossShareOrExchangeTheirMomentum) {
  const double mass = find_mass(0.005, 0.04);
  for (const char* const enforcement : {"kinematic", "lagrange", "penalty"}) {
    const bool has_springs = std::string(enforcement) == "penalty";
    const HistoryTable h = run_deck(cross_stubs(enforcement)).history;
    EXPECT_NEAR(find_impulse(h, "fz:f"), mass * (has_springs ? -8 : -4), 5e-3 * mass) << enforcement;
    EXPECT_NEAR(h.last("momentum_z"), mass * 2, 1e-12 * mass) << enforcement;
    const double gap = h.last("n_z") - h.last("m_z");
    if (has_springs)
      EXPECT_GT(gap, 0.0105);
    else
      EXPECT_NEAR(gap, 0.01, 1e-6) << enforcement;
  }
}

// At 2000 m/s a bar goes by more than a diameter in a step, and does not get through.
TEST(BeamContact, AFastBarDoesNotPassThroughAnother) {
  const HistoryTable h = run_deck(R"yaml(
time: {end: 4e-5}
parts:
  a: {line: {from: [-0.02, 0, 0], to: [0.02, 0, 0], cells: 1}, section: {round: {radius: 0.002}}, material: steel}
  b: {line: {from: [0.001, -0.02, 0.0101], to: [0.001, 0.02, 0.0101], cells: 1}, section: {round: {radius: 0.002}}, material: steel}
initial: [{part: b, velocity: [0, 0, -2000]}]
contact: {surfaces: all, beams: true}
output: {history: {every: 1e-6, nodes: [{name: m, near: [0.02, 0, 0]}, {name: n, near: [0.001, 0.02, 0.0101]}]}}
)yaml" + steel)
                             .history;
  const double mass = find_mass(0.002, 0.04);
  EXPECT_GT(h.last("n_z"), 0.5 * (h.last("m_z") + h.last("n_z")));
  EXPECT_NEAR(h.last("momentum_z"), -2000 * mass, 1e-11 * 2000 * mass);
}

// Equal bars end on: the wave takes the velocity over from one to the other (Goldsmith, Impact, section 3). What the
// node at the end loses is a share of an element.
TEST(BeamContact, BarsEndOnExchangeTheirVelocities) {
  const HistoryTable h = run_deck(R"yaml(
time: {end: 2.0e-4}
parts:
  a: {line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 100}, section: {round: {radius: 0.005}}, material: steel}
  b: {line: {from: [0.21001, 0, 0], to: [0.41001, 0, 0], cells: 100}, section: {round: {radius: 0.005}}, material: steel}
initial: [{part: a, velocity: [2, 0, 0]}]
contact: {surfaces: all, beams: true}
output: {history: {every: 1e-6, parts: all, forces: [{name: f, contact: [b, a]}]}}
)yaml" + steel)
                             .history;
  const double momentum = 2 * find_mass(0.005, 0.2);
  EXPECT_NEAR(find_impulse(h, "fx:f"), momentum, 0.02 * momentum);
  EXPECT_NEAR(h.last("momentum_x"), momentum, 1e-11 * momentum);
  // rho c v / 2 over the area, while the waves run.
  const double force = 0.5 * density * std::sqrt(200e9 / density) * 2 * pi * 25e-6;
  EXPECT_NEAR(h.mean(2e-5, 6e-5, "fx:f"), force, 0.03 * force);
}

// A bar that falls flat on a block stops at once, as its nodes have no waves across it. At rest its axis is a radius
// above the block, and the block carries its weight.
TEST(BeamContact, ABarFallsFlatOnABlockAndRests) {
  const double mass = find_mass(0.005, 0.2);
  const std::string rest = R"yaml(
time: {end: 0.05}
initial: [{part: bar, velocity: [0, 0, -0.1]}]
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: [[bar, block]]}
output: {history: {every: 1e-4, forces: [{name: f, contact: [bar, block]}], nodes: [{name: m, near: [0, 0, 0.0055]}, {name: e, near: [0.1, 0, 0.0055]}]}}
)yaml";
  const HistoryTable h = run_deck(lay_on_block(0.0055, rest)).history;
  EXPECT_NEAR(h.last("m_z"), 0.005, 1e-8);
  EXPECT_NEAR(h.last("e_z"), 0.005, 1e-8);
  EXPECT_NEAR(h.mean(0.02, 0.05, "fz:f"), mass * g, 1e-3 * mass * g);
  EXPECT_NEAR(find_impulse(h, "fz:f"), mass * (0.1 + g * 0.05), 1e-3 * mass * (0.1 + g * 0.05));
}

// On a sheet the axis rests half a thickness higher; a contact_radius is instead of that of the section.
TEST(BeamContact, ABarRestsOnASheetAtHalfItsThickness) {
  const std::string text = R"yaml(
time: {end: 0.02}
parts:
  bar: {line: {from: [-0.1, 0.01, 0.0105], to: [0.1, 0.01, 0.0105], cells: 8}, section: {rectangle: {size: [0.01, 0.01]}}, toward: y, contact_radius: 0.008, material: steel}
  sheet: {shell_plate: {size: [0.3, 0.1], cells: [6, 2]}, at: [-0.15, -0.05, 0], thickness: 0.002, material: steel, rigid: {}}
conditions: [{body: sheet, fixed: [x, y, z, rx, ry, rz]}]
initial: [{part: bar, velocity: [0, 0, -0.2]}]
contact: {surfaces: [[bar, sheet]]}
output: {history: {every: 1e-4, nodes: [{name: m, near: [0, 0.01, 0.0105]}]}}
)yaml";
  EXPECT_NEAR(run_deck(text + steel).history.last("m_z"), 0.009, 1e-7);
}

// At a wall a bar rests at its radius where the wall includes thicknesses, else with its axis on the wall.
TEST(BeamContact, ABarRestsOnAWallAtItsRadiusOrAtItsAxis) {
  for (const char* const thickness : {"included", "ignored"}) {
    const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: 0.02}}
parts: {{bar: {{line: {{from: [-0.1, 0, 0.006], to: [0.1, 0, 0.006], cells: 4}}, section: {{round: {{radius: 0.005}}}}, material: steel}}}}
walls: [{{point: [0, 0, 0], normal: z, thickness: {}}}]
initial: [{{part: bar, velocity: [0, 0, -1]}}]
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: all, beams: true}}
output: {{history: {{every: 1e-3, nodes: [{{name: m, near: [0, 0, 0.006]}}]}}}}
)yaml",
                                                thickness) +
                                    steel)
                               .history;
    EXPECT_NEAR(h.last("m_z"), std::string(thickness) == "included" ? 0.005 : 0, 1e-9) << thickness;
  }
}

// Friction slows a bar by mu g, across its axis and along it.
TEST(BeamContact, ABarThatSlidesIsSlowedByFriction) {
  for (const char axis : {'x', 'y'})
    for (const char* const enforcement : {"kinematic", "penalty"}) {
      const double mass = find_mass(0.005, 0.2);
      const std::string rest = fmt::format(R"yaml(
time: {{end: 0.02}}
initial: [{{part: bar, velocity: [{}, {}, 0]}}]
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: [[bar, block]], friction: 0.3, enforcement: {}}}
output: {{history: {{every: 1e-3, parts: all, nodes: [{{name: m, near: [0, 0, 0.005]}}]}}}}
)yaml",
                                           axis == 'x' ? 0.5 : 0.0, axis == 'y' ? 0.5 : 0.0, enforcement);
      const HistoryTable h = run_deck(lay_on_block(0.005, rest)).history;
      const double slowed = 0.3 * g * 0.02;
      EXPECT_NEAR(h.last(fmt::format("momentum_{}", axis)), mass * (0.5 - slowed), 1e-2 * mass * slowed)
          << axis << enforcement;
    }
}

// A bar slides over two rails of elements as short as the distance of the axes, across them and along them: its weight
// presses the rails, and mu g slows it. What moment friction has is borne by each edge for itself.
TEST(BeamContact, FrictionOfABarOnCrossedRailsIsCoulombs) {
  for (const char axis : {'x', 'y'})
    for (const char* const enforcement : {"kinematic", "penalty"}) {
      const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: 0.005}}
parts:
  bar: {{line: {{from: [-0.1, 0, 0.01], to: [0.1, 0, 0.01], cells: 8}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
  rails: {{line: {{from: [0, -0.08, 0], to: [0, 0.08, 0], cells: 16}}, array: {{count: [2, 1, 1], pitch: [0.124, 1, 1]}}, at: [-0.062, 0.003, 0], section: {{round: {{radius: 0.005}}}}, material: steel}}
conditions: [{{nodes: rails, fixed: [x, y, z, rx, ry, rz]}}]
initial: [{{part: bar, velocity: [{}, {}, 0]}}]
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: [[bar, rails]], friction: 0.3, enforcement: {}}}
output: {{history: {{every: 5e-4, parts: all, forces: [{{name: f, contact: [bar, rails]}}]}}}}
)yaml",
                                                  axis == 'x' ? 0.5 : 0.0, axis == 'y' ? 0.5 : 0.0, enforcement) +
                                      steel)
                                 .history;
      const double mass = find_mass(0.005, 0.2), pressed = find_impulse(h, "fz:f");
      EXPECT_NEAR(pressed, mass * g * 0.005, 0.02 * mass * g * 0.005) << axis << enforcement;
      EXPECT_NEAR(h.last(fmt::format("momentum_{}", axis)), mass * 0.5 - 0.3 * pressed, 0.01 * 0.3 * pressed)
          << axis << enforcement;
    }
}

// A rope slides over half of a drum that is held: what pulls it is exp(mu pi) times what holds it back (Euler, 1769).
TEST(BeamContact, ARopeOverADrumHoldsByTheExponentialOfTheAngle) {
  constexpr int around = 40, hanging = 12;
  constexpr double area = 1e-5, tail = 0.096, held_back = 20, friction = 0.2;
  const double radius = 0.1 + std::sqrt(area / pi);
  std::vector<std::array<double, 2>> ends;
  ends.reserve(2 * hanging + around + 1);
  for (int i = 0; i < hanging; ++i) ends.push_back({-radius, -tail * (hanging - i) / hanging});
  for (int i = 0; i <= around; ++i)
    ends.push_back({-radius * std::cos(pi * i / around), radius * std::sin(pi * i / around)});
  for (int i = 1; i <= hanging; ++i) ends.push_back({radius, -tail * i / hanging});
  std::string parts;
  for (std::size_t i = 1; i < ends.size(); ++i)
    parts += fmt::format(
        "  r{}: {{line: {{from: [{:.12g}, 0, {:.12g}], to: [{:.12g}, 0, {:.12g}], cells: 1}}, section: {{truss: "
        "{{area: "
        "{}}}}}, material: rope}}\n",
        i, ends[i - 1][0], ends[i - 1][1], ends[i][0], ends[i][1], area);
  const std::string left = "r1/start", right = fmt::format("r{}/end", ends.size() - 1);
  const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: 0.06}}
parts:
  drum: {{tube: {{inner_radius: 0.08, outer_radius: 0.1, length: 0.06, cells: [1, 96, 2]}}, at: [0, 0.03, 0], axis: -y, material: steel, rigid: {{}}}}
{0}join: true
materials:
  steel: {{model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3}}
  rope: {{model: elastic, density: 1500, youngs_modulus: 1e9, poissons_ratio: 0.3}}
conditions:
  - {{body: drum, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {2}, fixed: [x]}}
  - {{nodes: {2}, velocity: {{z: {{table: [[0, 0], [0.015, 0], [0.025, -0.25], [1, -0.25]]}}}}}}
loads: {{nodal: [{{nodes: {1}, force: {{z: {{table: [[0, 0], [0.01, {3}], [1, {3}]]}}}}}}]}}
damping: [{{nodes: all, coefficient: 50}}]
contact: {{surfaces: all, beams: true, friction: {4}}}
output: {{history: {{every: 1e-4, forces: [{{name: pull, support: {2}}}]}}}}
)yaml",
                                              parts, left, right, -held_back, friction))
                             .history;
  const double pulled = held_back * std::exp(friction * pi);
  EXPECT_NEAR(-h.mean(0.04, 0.06, "fz:pull"), pulled, 0.015 * pulled);
}

// A bar lies across two that are held, with its middle at a third of the span: they carry two thirds and one third.
TEST(BeamContact, ABarOnTwoCrossedBarsIsCarriedByStatics) {
  const HistoryTable h = run_deck(R"yaml(
time: {end: 0.4}
parts:
  bar: {line: {from: [-0.08, 0, 0.01], to: [0.12, 0, 0.01], cells: 7}, section: {round: {radius: 0.005}}, material: soft}
  left: {line: {from: [-0.06, -0.05, 0], to: [-0.06, 0.05, 0], cells: 3}, section: {round: {radius: 0.005}}, material: soft}
  right: {line: {from: [0.06, -0.05, 0], to: [0.06, 0.05, 0], cells: 3}, section: {round: {radius: 0.005}}, material: soft}
conditions: [{nodes: left, fixed: [x, y, z, rx, ry, rz]}, {nodes: right, fixed: [x, y, z, rx, ry, rz]}]
loads: {gravity: [0, 0, -9.81]}
damping: [{nodes: bar, coefficient: 200}]
contact: {surfaces: [[bar, left], [bar, right]], friction: 0.2}
output: {history: {every: 1e-3, forces: [{name: l, contact: [bar, left]}, {name: r, contact: [bar, right]}]}}
materials: {soft: {model: elastic, density: 7800, youngs_modulus: 2e9, poissons_ratio: 0.3}}
)yaml")
                             .history;
  const double weight = find_mass(0.005, 0.2) * g;
  EXPECT_NEAR(h.mean(0.3, 0.4, "fz:l"), weight / 3, 5e-3 * weight);
  EXPECT_NEAR(h.mean(0.3, 0.4, "fz:r"), 2 * weight / 3, 5e-3 * weight);
}

// A bar in the groove of two that touch rests at sqrt(3) radii above their axes, and presses each by W / (2 cos 30).
TEST(BeamContact, ABarRestsInTheGrooveOfTwoParallelOnes) {
  const HistoryTable h = run_deck(R"yaml(
time: {end: 0.06}
parts:
  a: {line: {from: [0, 0, 0], to: [0, 0.2, 0], cells: 8}, section: {round: {radius: 0.005}}, material: steel}
  b: {line: {from: [0.01, 0, 0], to: [0.01, 0.2, 0], cells: 8}, section: {round: {radius: 0.005}}, material: steel}
  top: {line: {from: [0.005, 0, 0.00867], to: [0.005, 0.2, 0.00867], cells: 8}, section: {round: {radius: 0.005}}, material: steel}
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}, {nodes: b, fixed: [x, y, z, rx, ry, rz]}]
loads: {gravity: [0, 0, -9.81]}
damping: [{nodes: top, coefficient: 400}]
contact: {surfaces: [[top, a], [top, b]]}
output: {history: {every: 1e-3, forces: [{name: l, contact: [top, a]}, {name: r, contact: [top, b]}], nodes: [{name: m, near: [0.005, 0, 0.00867]}, {name: n, near: [0.005, 0.2, 0.00867]}]}}
)yaml" + steel)
                             .history;
  const double weight = find_mass(0.005, 0.2) * g;
  for (const char* const node : {"m_z", "n_z"}) EXPECT_NEAR(h.last(node), 0.005 * std::sqrt(3.0), 1e-7);
  EXPECT_NEAR(h.mean(0.04, 0.06, "fz:l"), weight / 2, 5e-3 * weight);
  EXPECT_NEAR(h.mean(0.04, 0.06, "fx:l"), weight / 2 * std::tan(pi / 6), 5e-3 * weight);
  EXPECT_NEAR(h.mean(0.04, 0.06, "fx:r"), -weight / 2 * std::tan(pi / 6), 5e-3 * weight);
}

// Long bars that cross lose no momentum, and contact gives no energy. The balance closes to the square of the step.
TEST(BeamContact, BarsThatCrossConserveMomentumAndEnergy) {
  for (const char* const enforcement : {"kinematic", "lagrange", "penalty"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 1e-3, step_scale: 0.3}}
parts:
  a: {{line: {{from: [-0.1, 0, 0], to: [0.1, 0, 0], cells: 9}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
  b: {{line: {{from: [0.02, -0.1, 0.0101], to: [0.04, 0.1, 0.0101], cells: 9}}, section: {{round: {{radius: 0.005}}}}, material: steel}}
initial: [{{part: a, velocity: [0, 0, 5]}}, {{part: b, velocity: [1, 0, -5]}}]
contact: {{surfaces: all, beams: true, friction: 0.3, enforcement: {}}}
output: {{history: {{every: 1e-5}}}}
)yaml",
                                             enforcement) +
                                 steel);
    const double mass = find_mass(0.005, 0.2), energy = 0.5 * mass * 51;
    EXPECT_NEAR(run.history.last("momentum_z"), run.history["momentum_z"][0], 1e-11 * mass * 5) << enforcement;
    EXPECT_NEAR(run.history.last("angular_x"), run.history["angular_x"][0], 1e-11 * mass * 0.1 * 5) << enforcement;
    EXPECT_NEAR(run.history.last("angular_z"), run.history["angular_z"][0], 1e-11 * mass * 0.1 * 5) << enforcement;
    EXPECT_LT(run.history.largest("contact"), 1e-4 * energy) << enforcement;
    EXPECT_GT(run.history.last("contact"), -0.5 * energy) << enforcement;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3) << enforcement;
  }
}

// Beams touch only when they are asked to, and those of a part that a pair names then do without it.
TEST(BeamContact, BeamsPassWhereNothingAsksForTheirContact) {
  std::string text = cross_stubs("kinematic");
  text.replace(text.find(", beams: true"), 13, "");
  const HistoryTable h = run_deck(text).history;
  EXPECT_NEAR(h.last("n_z") - h.last("m_z"), 0.0101 - 8 * 2e-4, 1e-9);
}

// A bar is drawn across a straight one, over its nodes, under a load that its nodes share. Friction is mu times the
// push in each step, whatever the depth: where nodes move as one, a push on some of them sinks in.
TEST(BeamContact, ABarIsNotCaughtByTheNodesThatItPasses) {
  for (const char* const enforcement : {"kinematic", "penalty"}) {
    const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: 0.02}}
parts:
  a: {{line: {{from: [-0.2, 0, 0], to: [0.2, 0, 0], cells: 20}}, section: {{round: {{radius: 0.005}}}}, material: m}}
  b: {{line: {{from: [-0.05, -0.1, 0.01], to: [-0.05, 0.1, 0.01], cells: 9}}, section: {{round: {{radius: 0.005}}}}, material: m}}
materials: {{m: {{model: elastic, density: 7850, youngs_modulus: 2e9, poissons_ratio: 0.3}}}}
contact: {{surfaces: all, beams: true, friction: 0.3, enforcement: {}}}
conditions:
- {{nodes: a, fixed: [x, y, z, rx, ry, rz]}}
- {{nodes: b, velocity: {{x: {{table: [[0, 0], [0.002, 3], [1, 3]]}}, y: 0, rx: 0, ry: 0, rz: 0}}}}
loads: {{nodal: [{{nodes: b, force: {{z: -5}}}}]}}
constraints: {{k: {{nodes: b, equal: [z]}}}}
output: {{history: {{every: 0, forces: [{{name: f, contact: [b, a]}}]}}}}
)yaml",
                                                enforcement))
                               .history;
    double worst = 0;
    for (std::size_t i = 0; i < h.rows(); ++i)
      if (h["time"][i] > 3e-3 && std::abs(h["fz:f"][i]) > 5)
        worst = std::max(worst, std::abs(std::abs(h["fx:f"][i] / h["fz:f"][i]) - 0.3));
    EXPECT_LT(worst, 0.01) << enforcement;
    EXPECT_NEAR(h.last("fz:f"), 50, 25) << enforcement;  // it still lies on the other
  }
}

}  // namespace percuss::test::beam_contact_test
