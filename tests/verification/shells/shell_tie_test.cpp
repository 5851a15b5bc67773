// Shells that are tied: edge on edge, lapped, glued on each other and on solids, upright on a face; against statics,
// one mesh in place of two, and what a rigid motion keeps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"
#include "tests/verification/support/shell_rest.hpp"

namespace percuss::test::shell_tie_test {
namespace {

constexpr double young = 1e7;

const std::string materials =
    "materials: {elastic: {model: elastic, density: 1, youngs_modulus: 1e7, poissons_ratio: 0}}\n";

/// A load on the nodes at an end of a strip of `cells` across, as a uniform line load gives it. near: their x and z.
std::vector<NodeLoad> load_end(const Scene& scene, double x, double z, int cells, const Vec3& force) {
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<NodeLoad> loads;
  double lowest = 1e300, highest = -1e300;
  const auto is_there = [&](const Vec3& p) { return std::abs(p[0] - x) < 1e-9 && std::abs(p[2] - z) < 1e-9; };
  for (const Vec3& p : mesh.nodes) {
    if (!is_there(p)) continue;
    lowest = std::min(lowest, p[1]);
    highest = std::max(highest, p[1]);
  }
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3& p = mesh.nodes[n];
    if (!is_there(p)) continue;
    const double share = (p[1] == lowest || p[1] == highest ? 0.5 : 1.0) / cells;
    loads.push_back({mesh.node_ids[n], {share * force[0], share * force[1], share * force[2]}});
  }
  return loads;
}

/// Displacement of the loaded end of a static scene.
Vec3 rest(const std::string& text, double x, double z, int cells, const Vec3& force, int ramp) {
  const bool has_time = text.find("\ntime:") != std::string::npos;
  Scene scene((has_time ? "" : "time: {end: 1e9}\n") + text + materials);
  const std::vector<NodeLoad> loads = load_end(scene, x, z, cells, force);
  RestOptions options;
  options.ramp = ramp;
  return bring_to_rest(scene, loads, loads.at(0).node_id, options);
}

// Two strips edge on edge, pulled, one element long each: meshes that match, and nested ones. A uniform stress goes
// through.
TEST(TiedShells, EdgeOnEdgeHandOnAUniformStress) {
  for (const char* cells : {"[1, 2]", "[1, 4]", "[1, 6]"}) {
    const HistoryTable history = run_deck(fmt::format(R"(
title: butt joint
time: {{end: 1e-2}}
parts:
  left: {{shell_plate: {{size: [0.2, 0.4], cells: [1, 2]}}, at: [-0.2, 0, 0], thickness: 0.02, material: elastic}}
  right: {{shell_plate: {{size: [0.2, 0.4], cells: {}}}, thickness: 0.02, material: elastic}}
contact: {{ties: [{{a: right/x_min, b: left}}]}}
conditions:
  - {{nodes: all, fixed: [y, z]}}
  - {{nodes: left/x_min, velocity: {{x: -0.1}}}}
  - {{nodes: right/x_max, velocity: {{x: 0.1}}}}
initial:
  - {{part: left/x_min, velocity: [-0.1, 0, 0]}}
  - {{part: right/x_max, velocity: [0.1, 0, 0]}}
output: {{history: {{elements: [{{name: a, near: [-0.1, 0.1, 0]}}, {{name: b, near: [-0.1, 0.3, 0]}},
  {{name: c, near: [0.1, 0.05, 0]}}, {{name: d, near: [0.1, 0.17, 0]}}, {{name: e, near: [0.1, 0.23, 0]}}]}}}}
)",
                                                      cells) +
                                          materials)
                                     .history;
    const double stress = young * std::log1p(5e-3);
    // 1e-6 of the way of a node in a step is left by the iteration
    for (const char* element : {"a", "b", "c", "d", "e"})
      EXPECT_NEAR(history.last(std::string(element) + "_stress_xx"), stress, 1e-7 * stress) << cells << element;
  }
}

// A lap joint of two strips that cannot leave their planes, the lap a third of the length: there both strips, matching
// meshes, carry half the pull, so that the end moves by P / E A times the length outside and half of that inside.
TEST(TiedShells, LappedStripsShareThePull) {
  constexpr double thickness = 0.02, width = 0.4, pull = 1;
  const Vec3 u = rest(R"(
parts:
  low: {shell_plate: {size: [2, 0.4], cells: [10, 2]}, thickness: 0.02, material: elastic}
  high: {shell_plate: {size: [2, 0.4], cells: [10, 2]}, at: [1, 0, 0.02], thickness: 0.02, material: elastic}
contact: {ties: [{a: high, b: low}]}
conditions: [{nodes: all, fixed: [y, z]}, {nodes: low/x_min, fixed: [x]}]
)",
                      3, 0.02, 2, {pull, 0, 0}, 4000);  // 40 times as long as a wave goes to and fro
  const double exact = pull * (1 + 0.5 + 1) / (young * thickness * width);
  // what the ramp leaves of waves, and the strips are longer by 1e-5
  EXPECT_NEAR(u[0], exact, 5e-5 * exact);
}

// A stiff mass glued on the last element of a strip swings as on a spring E A / L of the free length, with the lap's
// mass and a third of that of the free length (Rayleigh).
TEST(TiedShells, CarryAMassAsASpringDoes) {
  const HistoryTable history = run_deck(R"(
title: a mass on a strip
time: {end: 0.07}
parts:
  strip: {shell_plate: {size: [1, 0.4], cells: [5, 2]}, thickness: 0.02, material: elastic}
  mass: {box: {size: [0.2, 0.4, 0.2], cells: [1, 3, 1]}, at: [0.8, 0, 0.01], material: heavy}
contact: {surfaces: none, ties: [{a: mass/z_min, b: strip}]}
conditions: [{nodes: all, fixed: [y, z]}, {nodes: strip/x_min, fixed: [x]}]
initial: [{part: mass, velocity: [0.01, 0, 0]}]
materials:
  elastic: {model: elastic, density: 1, youngs_modulus: 1e7, poissons_ratio: 0}
  heavy: {model: elastic, density: 1000, youngs_modulus: 1e10, poissons_ratio: 0}
output: {history: {every: 0, nodes: [{name: mass, near: [0.9, 0.2, 0.1]}]}}
)")
                                   .history;
  const double spring = young * 0.4 * 0.02 / 0.8, mass = 1000 * 0.2 * 0.4 * 0.2 + 0.0016 + 0.8 * 0.008 / 3;
  const double exact = 0.75 * 2 * std::numbers::pi * std::sqrt(mass / spring);
  std::size_t i = 2;  // after the velocity of the start: rises through zero after three quarters
  while (i + 1 < history.rows() && !(history["mass_vx"][i - 1] < 0 && history["mass_vx"][i] >= 0)) ++i;
  // the mass is not quite stiff
  EXPECT_NEAR(history["time"][i], exact, 1e-3 * exact);
}

/// Two strips glued on each other, one element wide, on supports at both ends, loaded in the middle: deflection over
/// that of the two loose, P L^3 / 48 E I.
double bend_glued(const std::string& tie, int cells) {
  constexpr double length = 10, thickness = 0.1, load = 1e-3;
  // Where kinetic damping stops the ties depends on the step by half a per cent of the deflection.
  const Vec3 u = rest(fmt::format(R"(
time: {{end: 1e9, step_scale: 0.72}}
parts:
  low: {{shell_plate: {{size: [10, 1], cells: [{0}, 1]}}, thickness: 0.1, material: elastic}}
  high: {{shell_plate: {{size: [10, 1], cells: [{0}, 1]}}, at: [0, 0, 0.1], thickness: 0.1, material: elastic}}
contact: {{ties: [{{{1}}}]}}
conditions: [{{nodes: all, fixed: [y]}}, {{nodes: low/x_min, fixed: [x, z]}}, {{nodes: low/x_max, fixed: [z]}}]
)",
                                  cells, tie),
                      0.5 * length, 0, 1, {0, 0, load}, 2000);
  return u[2] / (load * std::pow(length, 3) / (48 * young * 2 * std::pow(thickness, 3) / 12));
}

// Two strips glued flat bend as one of twice the thickness: a quarter of the deflection of two loose ones.
TEST(TiedShells, GluedFlatBendAsOne) {
  const double coarse = bend_glued("a: high, b: low", 20), fine = bend_glued("a: high, b: low", 40);
  const double other = bend_glued("a: low, b: high", 20);
  fmt::print("glued strips: {:.4f}, {:.4f} and {:.4f} of the deflection of two loose ones (exact: 0.25)\n", coarse,
             fine, other);
  // shear of the strips adds a thousandth or two
  EXPECT_NEAR(coarse, 0.25, 1e-3);
  EXPECT_NEAR(fine, 0.25, 1e-3);
  EXPECT_NEAR(other, 0.25, 1e-3);
}

/// A strip of length 10 that stands on a rigid block, in elements of 0.5. tie: distance and more.
std::string stand_upright(const std::string& tie) {
  return fmt::format(R"(
parts:
  block: {{box: {{size: [2, 1, 1], cells: [2, 1, 1]}}, at: [-1, 0, -1], material: elastic}}
  wall: {{shell_plate: {{size: [10, 1], cells: [20, 1]}}, rotate: [{{axis: y, angle: -90}}], thickness: 0.1, material: elastic}}
contact: {{surfaces: none, ties: [{{a: wall, b: block/z_max, {}}}]}}
conditions: [{{nodes: block, fixed: [x, y, z]}}]
)",
                     tie);
}

// With its second row of nodes in reach as well an upright strip is a beam on two supports, 0.5 from one another, that
// continues beyond: u = P a^2 (a + 0.5) / 3 E I, a = 9.5.
TEST(TiedShells, UprightInTwoRowsCarryAMoment) {
  constexpr double length = 10, thickness = 0.1, load = 1e-3;
  const Vec3 u = rest(stand_upright("distance: 0.5"), 0, 10, 1, {load, 0, 0}, 2000);
  const double ratio = u[0] / (load * std::pow(length, 3) / (3 * young * std::pow(thickness, 3) / 12));
  fmt::print("upright strip: {:.4f} of the deflection of a clamped one (exact: 0.9025)\n", ratio);
  EXPECT_NEAR(ratio, 0.9025, 0.02);  // one element between the supports bends by 3/4 of its share of 0.045
}

// In one row it stands on a hinge: set in motion about its foot it turns freely.
TEST(TiedShells, UprightInOneRowTurnAboutTheirFoot) {
  constexpr double rate = 10, length = 10;
  const HistoryTable history =
      run_deck("title: hinge\ntime: {end: 0.1}\n" + stand_upright("distance: 0.01") + materials + R"(
initial: [{part: wall, angular_velocity: [0, 10, 0], center: [0, 0, 0]}]
output: {history: {nodes: [{name: tip, near: [0, 0, 10]}]}}
)")
          .history;
  // a radian; the strip is stretched at once by rho rate^2 L^2 / 2 E = 5e-4, and vibrates by as much
  EXPECT_NEAR(history.last("tip_vx"), rate * length * std::cos(1.0), 2e-2 * rate * length);
  EXPECT_NEAR(history.last("tip_vz"), -rate * length * std::sin(1.0), 2e-2 * rate * length);
  EXPECT_LT(std::abs(history.last("contact")), 1e-4 * history["kinetic"].front());
  EXPECT_LT(std::abs(history.last("energy_error")), 1e-4);
}

/// Deflection of the tip of a cantilever of length 10, width 1 and thickness 0.1 over P L^3 / 3 E I.
double find_share_of_clamped(const std::string& scene, double x, double z, const Vec3& force) {
  const Vec3 u = rest(scene, x, z, 1, force, 2000);
  const double load = force[0] + force[2];
  return (u[0] * force[0] + u[2] * force[2]) / load / (load * std::pow(10.0, 3) / (3 * young * std::pow(0.1, 3) / 12));
}

// With its rotations tied one row of nodes is a clamp: on a solid, with either enforcement.
TEST(TiedShells, UprightWithTiedRotationsAreClamped) {
  for (const std::string enforcement : {"kinematic", "lagrange"}) {
    std::string scene = stand_upright("distance: 0.01, rotations: true");
    scene.replace(scene.find("surfaces: none"), 14, "surfaces: none, enforcement: " + enforcement);
    const double share = find_share_of_clamped(scene, 0, 10, {1e-3, 0, 0});
    fmt::print("upright strip, rotations tied, {}: {:.4f} of the deflection of a clamped one\n", enforcement, share);
    EXPECT_NEAR(share, 1, 2e-3) << enforcement;
  }
}

// Two strips edge on edge. The edge of the second turns as the last element of the first does, whose slope is that of
// its middle, and the moment reaches this as forces at both its ends: three halves of the bending of half an element
// are lost. A length of 5 beyond the joint, of 10, makes this 0.05625 h of the deflection.
TEST(TiedShells, EdgeOnEdgeWithTiedRotationsBendAsOneButForHalfAnElement) {
  for (const int cells : {10, 20}) {
    for (const int across : {1, 2}) {
      const double share = find_share_of_clamped(fmt::format(R"(
parts:
  root: {{shell_plate: {{size: [5, 1], cells: [{0}, {1}]}}, at: [-5, 0, 0], thickness: 0.1, material: elastic}}
  tip: {{shell_plate: {{size: [5, 1], cells: [{0}, 1]}}, thickness: 0.1, material: elastic}}
contact: {{surfaces: none, ties: [{{a: tip/x_min, b: root, rotations: true}}]}}
conditions: [{{nodes: root/x_min, fixed: [x, y, z, rx, ry, rz]}}]
)",
                                                             cells, across),
                                                 5, 0, {0, 0, 1e-3});
      fmt::print("strips edge on edge, rotations tied, {} long, {} across: {:.4f} of the deflection of one\n", cells,
                 across, share);
      EXPECT_NEAR(share, 1 - 0.05625 * 5 / cells, 3e-3) << cells << across;
    }
  }
}

// In one row with tied rotations a strip spins with its block as one body.
TEST(TiedShells, UprightWithTiedRotationsSpinWithoutGainOrLoss) {
  const HistoryTable h = run_deck(R"(
title: a fin on a block
time: {end: 2e-2}
parts:
  block: {box: {size: [0.3, 0.2, 0.1], cells: [3, 3, 2]}, at: [-0.15, -0.1, -0.1], material: soft}
  fin: {shell_plate: {size: [0.2, 0.15], cells: [4, 4]}, rotate: [{axis: y, angle: -90}], at: [0.02, -0.08, 0], thickness: 0.01, material: soft}
initial: [{angular_velocity: [30, 100, 200], center: [0, 0, 0], velocity: [3, 0, 0]}]
contact: {surfaces: none, ties: [{a: fin, b: block/z_max, distance: 0.001, rotations: true}]}
output: {history: {}}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
)")
                             .history;
  for (const char* axis : {"x", "y", "z"}) {
    const std::string linear = std::string("momentum_") + axis, spin = std::string("angular_") + axis;
    // round-off of some thousand steps
    EXPECT_NEAR(h.last(linear), h[linear].front(), 1e-13 * std::abs(h["momentum_y"].front())) << axis;
    EXPECT_NEAR(h.last(spin), h[spin].front(), 1e-12 * std::abs(h["angular_z"].front())) << axis;
  }
  fmt::print("fin: work of the tie {:.1e} of the kinetic energy\n", h.last("contact") / h.last("kinetic"));
  // of the order of the square of the turn in a step, here 0.005
  EXPECT_LT(std::max(h.largest("contact"), -h.smallest("contact")), 1e-5 * h.last("kinetic"));
  EXPECT_LT(std::abs(h.last("energy_error")), 1e-4);
  EXPECT_LT(h.largest("residual"), 1e-8);
  for (std::size_t i = 1; i < h.rows(); ++i) EXPECT_EQ(h["contacts"][i], 5);
}

// The sheet's rotations are held, or driven: what holds them takes the moment of the tie, which the books know.
TEST(TiedShells, HeldAndDrivenRotationsCarryTheMomentOfTheTie) {
  for (const std::string condition : {"fixed: [rx, ry, rz]", "velocity: {ry: 30}"}) {
    const HistoryTable h = run_deck(fmt::format(R"(
title: a fin with held rotations
time: {{end: 2e-3}}
parts:
  block: {{box: {{size: [0.3, 0.2, 0.1], cells: [3, 3, 2]}}, at: [-0.15, -0.1, -0.1], material: soft}}
  fin: {{shell_plate: {{size: [0.2, 0.15], cells: [4, 4]}}, rotate: [{{axis: y, angle: -90}}], at: [0.02, -0.08, 0], thickness: 0.01, material: soft}}
initial: [{{part: block, angular_velocity: [0, 30, 0], center: [0.02, 0, 0]}}]
conditions: [{{nodes: fin, {}}}]
contact: {{surfaces: none, ties: [{{a: fin, b: block/z_max, distance: 0.001, rotations: true}}]}}
output: {{history: {{every: 2e-4, forces: [{{name: held, support: fin}}]}}}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}}}
)",
                                                condition))
                               .history;
    // The audit ends a run whose angular momentum is not balanced to 1e-6; the support alone acts from outside.
    EXPECT_LT(std::max(h.largest("energy_error"), -h.smallest("energy_error")), 1e-5) << condition;
    double moment = 0;
    for (std::size_t i = 1; i < h.rows(); ++i) {
      const double begin = i == 1 ? 0.5 * h["dt"][1] : h["time"][i - 1];  // velocities begin at time 0
      moment += h["my:held"][i] * (h["time"][i] - begin);
    }
    EXPECT_NEAR(moment, h.last("angular_y") - h["angular_y"].front(), 1e-9 * std::abs(h["angular_y"].front()))
        << condition;
    EXPECT_GT(std::abs(moment), 0.01 * std::abs(h["angular_y"].front())) << condition;
  }
}

/// A plate glued on a block, 0.0005 beyond its half thickness, in free flight and spin; contact everywhere else.
void spin_glued(const std::string& plate, const std::string& sides, double tied,
                const std::string& enforcement = "kinematic") {
  const HistoryTable h = run_deck(fmt::format(R"(
title: a plate glued on a block
time: {{end: 2e-2}}
parts:
  block: {{box: {{size: [0.3, 0.2, 0.1], cells: [3, 3, 2]}}, at: [-0.15, -0.1, -0.05], material: soft}}
  plate: {{{}, thickness: 0.01, material: soft, at: [-0.15, -0.1, 0.0555]}}
initial: [{{angular_velocity: [30, 100, 200], center: [0, 0, 0], velocity: [3, 0, 0]}}]
contact: {{ties: [{{{}, distance: 0.001}}], enforcement: {}}}
output: {{history: {{}}}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}}}
)",
                                              plate, sides, enforcement))
                             .history;
  const double momentum = h["momentum_x"].front(), angular = h["angular_z"].front();
  for (const char* axis : {"x", "y", "z"}) {
    const std::string linear = std::string("momentum_") + axis, spin = std::string("angular_") + axis;
    // round-off of some thousand steps
    EXPECT_NEAR(h.last(linear), h[linear].front(), 1e-13 * momentum) << sides;
    EXPECT_NEAR(h.last(spin), h[spin].front(), 1e-12 * angular) << sides;
  }
  fmt::print("{}: work of the tie {:.1e} of the kinetic energy\n", sides, h.last("contact") / h.last("kinetic"));
  EXPECT_LT(std::max(h.largest("contact"), -h.smallest("contact")), 1e-6 * h.last("kinetic")) << sides;
  EXPECT_LT(std::abs(h.last("energy_error")), 1e-4) << sides;
  EXPECT_LT(h.largest("residual"), 1e-8) << sides;
  // the tied nodes, and no contact beside them
  for (std::size_t i = 1; i < h.rows(); ++i) EXPECT_EQ(h["contacts"][i], tied) << sides;
}

TEST(TiedShells, GluedOnASolidSpinWithoutGainOrLoss) {
  const std::string plate = "shell_plate: {size: [0.3, 0.2], cells: [5, 4]}";
  spin_glued(plate, "a: plate, b: block/z_max", 30);
  spin_glued(plate, "a: plate/bottom, b: block", 30);
  spin_glued(plate, "a: block/z_max, b: plate", 16);
  spin_glued(plate, "a: block, b: plate/top", 16);
}

TEST(TiedShells, OfTrianglesSpinWithoutGainOrLoss) {
  for (const Halving halving : {Halving::alternating, Halving::every_other}) {
    auto mesh = make_mapped_shell({5, 4}, [](double u, double v) { return Vec3{0.3 * u, 0.2 * v, 0}; });
    halve(5, halving, mesh);
    const TemporaryFile file(testing_mesh::write_exodus(mesh, "tied_triangles.exo"));
    const std::string plate = fmt::format("exodus: {{file: {}}}", file.path());
    spin_glued(plate, "a: block/z_max, b: plate", 16);
    spin_glued(plate, "a: plate, b: block", 30);
    spin_glued(plate, "a: block/z_max, b: plate", 16, "lagrange");
  }
}

}  // namespace
}  // namespace percuss::test::shell_tie_test
