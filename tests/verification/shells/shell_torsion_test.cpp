// Shells that twist: a twisting moment passes the kinks between flat elements, and drilling hinders nothing else.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"
#include "tests/verification/support/shell_rest.hpp"

namespace percuss::test::shell_torsion_test {
namespace {

constexpr double degrees = std::numbers::pi / 180;

/// A strip clamped at u = 0, with a force spread over its other end.
struct Strip {
  std::array<int, 2> cells;
  std::function<Vec3(double, double)> place;
  double young, poisson, thickness;
  Vec3 force;
};

enum class Mesh { quadrilaterals, triangles };

/// Displacement along the force of the middle of the loaded end.
double load_strip(const Strip& strip, Mesh kind) {
  const auto& cells = strip.cells;
  auto mesh = make_mapped_shell(cells, strip.place);
  if (kind == Mesh::triangles) halve(cells[0], Halving::alternating, mesh);
  add_edge_sets(cells, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "strip.exo"));
  Scene scene(make_static_deck(file.path(), strip.young, strip.poisson, strip.thickness,
                               "[{nodes: shell/u_min, fixed: [x, y, z, rx, ry, rz]}]"));
  std::vector<NodeLoad> loads;
  for (int j = 0; j <= cells[1]; ++j) {
    const double share = (j == 0 || j == cells[1] ? 0.5 : 1.0) / cells[1];
    const Vec3 force{share * strip.force[0], share * strip.force[1], share * strip.force[2]};
    loads.push_back({1 + cells[0] + (cells[0] + 1) * j, force});
  }
  RestOptions options;
  options.ramp = 2000;
  options.peaks = 200;
  options.tolerance = 1e-6;
  const Vec3 u = bring_to_rest(scene, loads, 1 + cells[0] + (cells[0] + 1) * (cells[1] / 2), options);
  const double size = std::hypot(strip.force[0], strip.force[1], strip.force[2]);
  return (u[0] * strip.force[0] + u[1] * strip.force[1] + u[2] * strip.force[2]) / size;
}

/// A quarter of a ring of strip, radius 46, 20 wide, 2 thick, under a transverse force at its end. Its answer is that
/// of hexahedra, converged to 0.1 %.
double load_quarter_ring(int along, Mesh kind) {
  const auto place = [](double u, double v) {
    return Vec3{46 * std::cos(90 * degrees * u), 46 * std::sin(90 * degrees * u), 20 * v};
  };
  return load_strip({{along, 4}, place, 3300, 0.35, 2, {0, 0, 0.01}}, kind) / 4.26e-3;
}

/// Raasch's hook (Knight 1997): arcs of 60 degrees and radius 14, then 150 degrees and radius 46, bent the other way. A
/// force of 1 along the width moves the end by 4.9352 (linear).
double load_hook(const std::array<int, 2>& cells) {
  const auto place = [](double u, double v) {
    const double turn = 9 * u * 60 * degrees;  // a ninth of the elements in the small arc
    if (9 * u <= 1) return Vec3{14 * std::sin(turn), 14 * std::cos(turn), 20 * v};
    const double slope = (60 - (9 * u - 1) / 8 * 150) * degrees;  // of the tangent, downwards
    const double x = (14 + 46) * std::sin(60 * degrees), y = (14 + 46) * std::cos(60 * degrees);
    return Vec3{x - 46 * std::sin(slope), y - 46 * std::cos(slope), 20 * v};
  };
  return load_strip({cells, place, 3300, 0.35, 2, {0, 0, 0.01}}, Mesh::quadrilaterals) / 4.9352e-2;
}

/// Torsion constant of a tube slit along its length (radius 10, wall 1, an arc of 350 degrees, length 60) over that of
/// a long strip, s t^3 / 3 (1 - 0.63 t / s): from the energy of a slow twist that leaves the ends free to warp.
double twist_slit_tube(int around) {
  constexpr double radius = 10, length = 60, angle = 1e-3, young = 1000, poisson = 0.3;
  const double arc = 350 * degrees * radius, shear = young / (2 * (1 + poisson));
  std::string conditions = "  - {nodes: b/start, fixed: [x, y]}\n";
  const std::string growth = "(t < 160 ? 0.5 - 0.5 * cos(pi * t / 160) : 1)";
  for (int i = 0; i <= around; ++i) {
    const double place = 350 * degrees * i / around, x = radius * std::cos(place), y = radius * std::sin(place);
    conditions += fmt::format(
        "  - {{nodes: {{name: b/end, inside: [[{}, {}, 59.9], [{}, {}, 60.1]]}}, displacement: "
        "{{x: {{expression: \"{} * {}\"}}, y: {{expression: \"{} * {}\"}}}}}}\n",
        x - 0.05, y - 0.05, x + 0.05, y + 0.05, -angle * y, growth, angle * x, growth);
  }
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 200}}
parts: {{b: {{shell_tube: {{radius: 10, length: 60, cells: [{}, {}], arc: 350}}, thickness: 1, material: m}}}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1000, poissons_ratio: 0.3}}}}
conditions:
{}output: {{history: {{every: 1}}}}
)yaml",
                                           around, around, conditions));
  const double energy = run.history.mean(165, 200, "internal") + run.history.mean(165, 200, "hourglass");
  return 2 * energy * length / (angle * angle) / (shear * arc / 3 * (1 - 0.63 / arc));
}

}  // namespace

TEST(ShellTorsion, QuarterRingConvergesToTheAnswerOfSolids) {
  for (const auto& [along, within] : {std::pair{12, 0.03}, std::pair{24, 0.01}, std::pair{48, 0.01}}) {
    const double share = load_quarter_ring(along, Mesh::quadrilaterals);
    fmt::print("quarter ring, {} along: {:.4f} of the solids' 4.26e-3\n", along, share);
    EXPECT_NEAR(share, 1, within) << along;
  }
}

TEST(ShellTorsion, QuarterRingOfTrianglesConverges) {
  for (const auto& [along, within] : {std::pair{24, 0.03}, std::pair{48, 0.03}}) {
    const double share = load_quarter_ring(along, Mesh::triangles);
    fmt::print("quarter ring of triangles, {} along: {:.4f}\n", along, share);
    EXPECT_NEAR(share, 1, within) << along;
  }
}

TEST(ShellTorsion, RaaschsHook) {
  for (const auto& [cells, within] : {std::pair{std::array{18, 3}, 0.04}, std::pair{std::array{36, 6}, 0.01}}) {
    const double share = load_hook(cells);
    fmt::print("Raasch's hook, {} x {}: {:.4f} of 4.9352\n", cells[0], cells[1], share);
    EXPECT_NEAR(share, 1, within) << cells[0];
  }
}

TEST(ShellTorsion, SlitTubeKeepsItsTorsionConstantOnEveryMesh) {
  for (const int around : {18, 36}) {
    const double share = twist_slit_tube(around);
    fmt::print("slit tube, {} around: torsion constant {:.4f}\n", around, share);
    EXPECT_NEAR(share, 1, 0.025) << around;
  }
}

TEST(ShellTorsion, DrillingLeavesBendingInThePlaneFree) {
  // A flat cantilever 20 long and 2 deep bent in its plane: Timoshenko's beam, F L^3 / 3 E I + 6/5 F L / G A.
  constexpr double length = 20, depth = 2, thickness = 0.1, young = 1e4, force = 1e-3;
  const double exact = force * std::pow(length, 3) / (3 * young * thickness * std::pow(depth, 3) / 12) +
                       1.2 * force * length / (0.5 * young * thickness * depth);
  for (const int deep : {1, 2}) {
    const auto place = [](double u, double v) { return Vec3{length * u, depth * v, 0}; };
    const Strip strip{{10 * deep, deep}, place, young, 0, thickness, {0, force, 0}};
    const double share = load_strip(strip, Mesh::quadrilaterals) / exact;
    fmt::print("strip bent in its plane, {} deep: {:.4f}\n", deep, share);
    EXPECT_NEAR(share, 1, 0.01) << deep;
  }
}

}  // namespace percuss::test::shell_torsion_test
