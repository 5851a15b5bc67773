// Shells at rest under load: the obstacle course of Belytschko et al. (1985), MacNeal and Harder (1985), and Sze, Liu
// and Lo (2004).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"
#include "tests/verification/support/shell_rest.hpp"

namespace percuss::test::shell_static_test {
namespace {

constexpr double degrees = std::numbers::pi / 180;

/// An octant of a cylinder between diaphragms, pinched in the middle: displacement under the load over 1.82488e-5.
/// distortion: of the mesh, as a share of a cell.
double pinch_cylinder(int cells, double distortion = 0) {
  constexpr double radius = 300, length = 600, thickness = 3, young = 3e6, exact = 1.82488e-5;
  auto mesh = make_mapped_shell({cells, cells}, distort({cells, cells}, distortion, [&](double u, double v) {
                                  const double angle = 90 * degrees * u;  // from the load at +z down to the plane z = 0
                                  return Vec3{0.5 * length * v, radius * std::sin(angle), radius * std::cos(angle)};
                                }));
  add_edge_sets({cells, cells}, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "pinched_cylinder.exo"));
  Scene scene(make_static_deck(
      file.path(), young, 0.3, thickness,
      "[{nodes: shell/u_min, symmetry: y}, {nodes: shell/u_max, symmetry: z}, {nodes: shell/v_min, symmetry: x}, "
      "{nodes: shell/v_max, fixed: [y, z]}]"));
  const Vec3 u = bring_to_rest(scene, {{1, {0, 0, -0.25}}}, 1, {});
  return -u[2] / exact;
}

/// The twisted beam: tip displacement along the load over that of beam theory.
double load_twisted_beam(const std::array<int, 2>& cells, double thickness, const Vec3& direction, double exact) {
  constexpr double length = 12, width = 1.1;
  auto mesh = make_mapped_shell(cells, [&](double u, double v) {
    const double angle = 90 * degrees * u, y = width * (v - 0.5);
    return Vec3{length * u, y * std::cos(angle), y * std::sin(angle)};
  });
  add_edge_sets(cells, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "twisted_beam.exo"));
  Scene scene(
      make_static_deck(file.path(), 29e6, 0.22, thickness, "[{nodes: shell/u_min, fixed: [x, y, z, rx, ry, rz]}]"));
  std::vector<NodeLoad> loads;
  for (int j = 0; j <= cells[1]; ++j) {
    const double share = (j == 0 || j == cells[1] ? 0.5 : 1.0) / cells[1];
    loads.push_back(
        {1 + cells[0] + (cells[0] + 1) * j, {share * direction[0], share * direction[1], share * direction[2]}});
  }
  const std::int64_t middle = 1 + cells[0] + (cells[0] + 1) * (cells[1] / 2);
  const Vec3 u = bring_to_rest(scene, loads, middle, {});
  return (u[0] * direction[0] + u[1] * direction[1] + u[2] * direction[2]) / exact;
}

/// A quarter of a hemisphere with a hole of 18 degrees, pulled along x and pushed along y by the force: displacements
/// at both loads, along x and y.
std::array<double, 2> pinch_hemisphere(int cells, double force, double distortion = 0) {
  constexpr double radius = 10, thickness = 0.04;
  auto mesh = make_mapped_shell({cells, cells}, distort({cells, cells}, distortion, [&](double u, double v) {
                                  const double around = 90 * degrees * u, up = 72 * degrees * v;
                                  return Vec3{radius * std::cos(up) * std::cos(around),
                                              radius * std::cos(up) * std::sin(around), radius * std::sin(up)};
                                }));
  add_edge_sets({cells, cells}, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "hemisphere.exo"));
  // The height of the hemisphere is held at the pushed corner.
  Scene scene(make_static_deck(file.path(), 6.825e7, 0.3, thickness,
                               "[{nodes: shell/u_min, symmetry: y}, {nodes: shell/u_max, symmetry: x}, "
                               "{nodes: {name: shell, inside: [[9.9, -0.1, -0.1], [10.1, 0.1, 0.1]]}, fixed: [z]}]"));
  const std::int64_t pulled = 1, pushed = 1 + cells;
  const std::vector<NodeLoad> loads{{pulled, {0.5 * force, 0, 0}}, {pushed, {0, -0.5 * force, 0}}};
  RestOptions options;
  options.ramp = 2000;
  options.peaks = 300;
  options.tolerance = 1e-7;
  const Vec3 u = bring_to_rest(scene, loads, pulled, options);
  const auto& ids = scene.chunked.mesh.node_ids;
  const auto n = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), pushed) - ids.begin());
  return {u[0], scene.state.x(n, 1) - scene.model.start(n, 1)};
}

}  // namespace

TEST(ShellAtRest, PinchedCylinder) {
  const double share = pinch_cylinder(16);
  fmt::print("pinched cylinder, 16 x 16: {:.4f} of 1.82488e-5\n", share);
  EXPECT_NEAR(share, 0.93, 0.02);
}

TEST(ShellAtRest, TwistedBeam) {
  const double in_plane = load_twisted_beam({12, 2}, 0.32, {0, 0, 1}, 5.424e-3);
  const double out_of_plane = load_twisted_beam({12, 2}, 0.32, {0, 1, 0}, 1.754e-3);
  fmt::print("twisted beam, 12 x 2: {:.4f} of 5.424e-3, {:.4f} of 1.754e-3\n", in_plane, out_of_plane);
  EXPECT_NEAR(in_plane, 1, 0.03);
  EXPECT_NEAR(out_of_plane, 1, 0.03);
}

TEST(ShellAtRest, PinchedHemisphere) {
  const auto u = pinch_hemisphere(8, 2);
  fmt::print("hemisphere, 8 x 8, linear: {:.4f} of 0.0935\n", u[0] / 0.0935);
  EXPECT_NEAR(u[0] / 0.0935, 1, 0.03);
}

TEST(ShellAtRest, PinchedHemisphereWithLargeDeflections) {
  // 200 on the whole hemisphere, 100 on the quarter: 3.406 and -5.902 (Sze, Liu and Lo 2004, converged).
  for (const auto& [cells, within] : {std::pair{8, 0.06}, std::pair{16, 0.02}}) {
    const auto u = pinch_hemisphere(cells, 200);
    fmt::print("hemisphere, {} x {}, large deflections: {:.4f} of 3.406, {:.4f} of 5.902\n", cells, cells, u[0] / 3.406,
               -u[1] / 5.902);
    EXPECT_NEAR(u[0] / 3.406, 1, within);
    EXPECT_NEAR(-u[1] / 5.902, 1, within);
  }
}

TEST(ShellAtRest, DistortedMeshesConverge) {
  // Nodes are moved by up to 0.3 of a cell.
  for (const auto& [cells, within] : {std::pair{16, 0.12}, std::pair{32, 0.04}}) {
    const double share = pinch_cylinder(cells, 0.3);
    fmt::print("distorted pinched cylinder, {} x {}: {:.4f}\n", cells, cells, share);
    EXPECT_NEAR(share, 1, within);
  }
  const double share = pinch_hemisphere(16, 2, 0.3)[0] / 0.0935;
  fmt::print("distorted hemisphere, 16 x 16: {:.4f}\n", share);
  EXPECT_NEAR(share, 1, 0.06);
}

}  // namespace percuss::test::shell_static_test
