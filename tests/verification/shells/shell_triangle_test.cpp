// Triangles in whole runs: at rest under load, in free spin, in contact, restarted, from files with triangles of either
// writing and beside quadrilaterals.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/step/run/run.hpp"
#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"
#include "tests/verification/support/shell_rest.hpp"

namespace percuss::test::shell_triangle_test {
namespace {

constexpr double degrees = std::numbers::pi / 180;

/// The octant of shell_static_test.cpp: displacement under the load over 1.82488e-5.
double pinch_cylinder(int cells, Halving halving) {
  constexpr double radius = 300, length = 600, thickness = 3, young = 3e6, exact = 1.82488e-5;
  auto mesh = make_mapped_shell({cells, cells}, [&](double u, double v) {
    const double angle = 90 * degrees * u;
    return Vec3{0.5 * length * v, radius * std::sin(angle), radius * std::cos(angle)};
  });
  add_edge_sets({cells, cells}, mesh);
  halve(cells, halving, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "pinched_cylinder_of_triangles.exo"));
  Scene scene(make_static_deck(
      file.path(), young, 0.3, thickness,
      "[{nodes: shell/u_min, symmetry: y}, {nodes: shell/u_max, symmetry: z}, {nodes: shell/v_min, symmetry: x}, "
      "{nodes: shell/v_max, fixed: [y, z]}]"));
  const Vec3 u = bring_to_rest(scene, {{1, {0, 0, -0.25}}}, 1, {});
  return -u[2] / exact;
}

/// A quarter of a clamped square plate with a load in its middle: deflection there over that of Kirchhoff's plate,
/// 0.00560 P L^2 / D (Timoshenko and Woinowsky-Krieger 1959, table 37).
double load_clamped_plate(int cells, double thickness, Halving halving) {
  constexpr double young = 1e7, poisson = 0.3, edge = 1;
  auto mesh = make_mapped_shell({cells, cells}, [](double u, double v) { return Vec3{0.5 * u, 0.5 * v, 0}; });
  add_edge_sets({cells, cells}, mesh);
  halve(cells, halving, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "clamped_plate_of_triangles.exo"));
  Scene scene(make_static_deck(file.path(), young, poisson, thickness,
                               "[{nodes: shell/u_min, symmetry: x}, {nodes: shell/v_min, symmetry: y}, "
                               "{nodes: shell/u_max, fixed: [x, y, z, rx, ry, rz]}, "
                               "{nodes: shell/v_max, fixed: [x, y, z, rx, ry, rz]}]"));
  const double rigidity = young * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
  const double load = 1e-3 * thickness * rigidity / (0.00560 * edge * edge);  // a thousandth of the thickness
  RestOptions options;
  options.ramp = 500;
  const Vec3 u = bring_to_rest(scene, {{1, {0, 0, 0.25 * load}}}, 1, options);
  return u[2] / (1e-3 * thickness);
}

/// A strip of length 10, width 1 and thickness 0.1, sheared at its end: deflection over P L^3 / 3 E I.
double load_cantilever(int cells, Halving halving) {
  constexpr double young = 1e7, length = 10, width = 1, thickness = 0.1, load = 1e-2;
  auto mesh = make_mapped_shell({10 * cells, cells}, [](double u, double v) {
    return Vec3{length * u, width * (v - 0.5), 0};
  });
  add_edge_sets({10 * cells, cells}, mesh);
  halve(10 * cells, halving, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "cantilever_of_triangles.exo"));
  // Without Poisson's ratio a beam and a strip are the same.
  Scene scene(
      make_static_deck(file.path(), young, 0, thickness, "[{nodes: shell/u_min, fixed: [x, y, z, rx, ry, rz]}]"));
  std::vector<NodeLoad> loads;
  for (int j = 0; j <= cells; ++j) {
    const double share = (j == 0 || j == cells ? 0.5 : 1.0) / cells;
    loads.push_back({1 + 10 * cells + (10 * cells + 1) * j, {0, 0, share * load}});
  }
  RestOptions options;
  options.ramp = 2000;
  const Vec3 u = bring_to_rest(scene, loads, loads[0].node_id, options);
  return u[2] / (load * std::pow(length, 3) / (3 * young * width * std::pow(thickness, 3) / 12));
}

const std::string steel = "{steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}";

}  // namespace

TEST(ShellTrianglesAtRest, PinchedCylinderConverges) {
  const double coarse = pinch_cylinder(16, Halving::alternating), fine = pinch_cylinder(32, Halving::alternating);
  const double mixed = pinch_cylinder(16, Halving::every_other);
  fmt::print("pinched cylinder: {:.4f} with 16 x 16 x 2 triangles, {:.4f} with 32 x 32 x 2; {:.4f} with half as many\n",
             coarse, fine, mixed);
  EXPECT_NEAR(fine, 1, 0.06);
  EXPECT_LT(std::abs(fine - 1), std::abs(coarse - 1));
  EXPECT_NEAR(mixed, 0.9, 0.06);
}

TEST(ShellTrianglesAtRest, ThinPlatesDoNotLock) {
  for (const auto halving : {Halving::one_way, Halving::alternating, Halving::every_other}) {
    const double thick = load_clamped_plate(8, 0.02, halving), thin = load_clamped_plate(8, 0.001, halving);
    fmt::print("clamped plate, 8 x 8 cells in a quarter, of Kirchhoff's: {:.4f} at t = L / 50, {:.4f} at L / 1000\n",
               thick, thin);
    EXPECT_NEAR(thin, 1, 0.05);
    EXPECT_NEAR(thin / thick, 1, 0.05);
  }
}

TEST(ShellTrianglesAtRest, CantileverBendsAsABeam) {
  const double one_way = load_cantilever(2, Halving::one_way), alternating = load_cantilever(2, Halving::alternating);
  fmt::print("cantilever, 20 x 2 x 2 triangles: {:.4f} and {:.4f} of P L^3 / 3 E I\n", one_way, alternating);
  EXPECT_NEAR(one_way, 1, 0.03);
  EXPECT_NEAR(alternating, 1, 0.03);
}

TEST(ShellTrianglesInMotion, WarpedPlateInFreeSpinKeepsItsMomentumAndItsEnergyForAHundredTurns) {
  auto mesh = make_mapped_shell({4, 4}, [](double u, double v) {
    return Vec3{u - 0.5, v - 0.5, 0.3 * (u - 0.5) * (v - 0.5) + 0.05 * std::sin(5 * u)};
  });
  halve(4, Halving::alternating, mesh);
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "spinning_triangles.exo"));
  const double w = 200, turn = 2 * std::numbers::pi / w;
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}}}
parts: {{plate: {{exodus: {{file: {}}}, thickness: 0.06, material: steel}}}}
materials: {}
initial: [{{part: plate, angular_velocity: [{}, 30, {}]}}]
output: {{history: {{every: 1e-3}}}}
audit: {{max_energy_error: 1e-3, max_momentum_error: 1e-10}}
)yaml",
                                           100 * turn, file.path(), steel, 0.1 * w, w));
  fmt::print("angular momentum {:.1e}, energy {:.1e}\n", run.summary.momentum.angular_error, run.summary.energy.error);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
  const double first = run.history.mean(0, 20 * turn, "kinetic"),
               last = run.history.mean(80 * turn, 100 * turn, "kinetic");
  EXPECT_NEAR(last / first, 1, 1e-3);
}

namespace {

/// Plates of triangles, quadrilaterals and both, one above the other; the middle one yields.
std::string make_contact_deck(const std::string& triangles, const std::string& mixed, const std::string& time,
                              const std::string& enforcement = "kinematic") {
  return fmt::format(R"yaml(
time: {{end: {}}}
parts:
  low: {{shell_plate: {{size: [0.1, 0.1], cells: [7, 7]}}, thickness: 0.004, material: steel}}
  middle: {{exodus: {{file: {}}}, thickness: 0.002, at: [0.01, 0.011, 0.0031], material: soft}}
  high: {{exodus: {{file: {}}}, thickness: 0.003, at: [0.012, 0.009, 0.0057], material: steel}}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
  soft: {{model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 100e6, hardening_modulus: 100e6}}
initial: [{{part: high, velocity: [3, 0, -60], angular_velocity: [100, 0, 0]}}]
loads: {{pressure: [{{faces: low/top, value: 1e6}}, {{faces: high/top, value: 2e5}}]}}
contact: {{surfaces: all, friction: 0.2, enforcement: {}}}
output: {{history: {{every: 0}}}}
)yaml",
                     time, triangles, mixed, enforcement);
}

testing_mesh::WrittenMesh make_plate(Halving halving) {
  auto mesh = make_mapped_shell({6, 6}, [](double u, double v) { return Vec3{0.08 * u, 0.07 * v, 0}; });
  halve(6, halving, mesh);
  return mesh;
}

}  // namespace

TEST(ShellTrianglesInContact, TheBooksCloseWithEveryEnforcement) {
  const TemporaryFile triangles(testing_mesh::write_exodus(make_plate(Halving::alternating), "touching_tri.exo")),
      mixed(testing_mesh::write_exodus(make_plate(Halving::every_other), "touching_mixed.exo"));
  for (const std::string enforcement : {"kinematic", "lagrange", "penalty"}) {
    SCOPED_TRACE(enforcement);
    const Outcome run = run_deck(make_contact_deck(triangles.path(), mixed.path(), "2e-4", enforcement));
    fmt::print("{}: energy {:.1e}, contact {:.3g}, friction {:.3g}, linear momentum {:.1e}, angular momentum {:.1e}\n",
               enforcement, run.summary.energy.error, run.summary.energy.contact, run.summary.energy.friction,
               run.summary.momentum.linear_error, run.summary.momentum.angular_error);
    EXPECT_LT(std::abs(run.summary.energy.error), 2e-3);
    EXPECT_LT(run.summary.energy.friction, 0);  // they touched
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  }
}

TEST(ShellTrianglesInContact, PlatesStopAtHalfTheThicknessOfBoth) {
  // All nodes of the lower plate are held; nothing but thickness stops the other, wherever its nodes meet the
  // triangles.
  for (const bool on_triangles : {true, false}) {
    const TemporaryFile held(testing_mesh::write_exodus(
        make_plate(on_triangles ? Halving::alternating : Halving::every_other), "held_plate.exo")),
        falls(testing_mesh::write_exodus(make_plate(on_triangles ? Halving::every_other : Halving::one_way),
                                         "falling_plate.exo"));
    Scene scene(fmt::format(R"yaml(
time: {{end: 1}}
parts:
  a: {{exodus: {{file: {}, scale: 1.5}}, thickness: 0.004, material: steel}}
  b: {{exodus: {{file: {}}}, thickness: 0.002, at: [0.013, 0.011, 0.0031], material: steel}}
materials: {}
initial: [{{part: b, velocity: [0, 0, -10]}}]
conditions: [{{nodes: a, fixed: [x, y, z, rx, ry, rz]}}]
contact: {{surfaces: all, enforcement: kinematic, tolerance: 1e-7}}
)yaml",
                            held.path(), falls.path(), steel));
    scene.contact.prepare(scene.state.x, scene.state.v);
    scene.stepper.start(scene.state);
    int in_contact = 0;
    while (in_contact < 40 && scene.state.time < 1e-3) {
      scene.stepper.advance(scene.state);
      if (in_contact > 0 || scene.stepper.contact_report().interactions > 0) ++in_contact;
    }
    ASSERT_EQ(in_contact, 40);
    const auto x = to_host(scene.state.x);
    for (const int n : scene.chunked.mesh.node_sets.at("b"))
      EXPECT_NEAR(x(static_cast<std::size_t>(n), 2), 0.003, 2e-9);  // of a thickness of 0.002
  }
}

TEST(ShellTrianglesInContact, ARestartEndsInTheSameBits) {
  const TemporaryFile triangles(testing_mesh::write_exodus(make_plate(Halving::alternating), "restart_tri.exo")),
      mixed(testing_mesh::write_exodus(make_plate(Halving::every_other), "restart_mixed.exo"));
  const auto run = [&](const std::string& folder, const std::string& time, bool saves, bool restarts) {
    std::string deck = make_contact_deck(triangles.path(), mixed.path(), time);
    if (saves) deck.replace(deck.find("{every: 0}"), 10, "{every: 0}, checkpoint: {every: 1}");
    RunOptions options;
    options.out_dir = folder;
    if (restarts) options.restart = folder + "/checkpoint.h5";
    options.goes_on_in_place = restarts;
    return run_scene(parse_deck(deck, "deck.yaml"), options).summary;
  };
  const TemporaryFolder whole, parts;
  const Summary expected = run(whole.path(), "6e-5", false, false);
  const int half = static_cast<int>(expected.steps / 2);
  run(parts.path(), fmt::format("6e-5, max_steps: {}", half), true, false);
  const Summary summary = run(parts.path(), "6e-5", false, true);
  EXPECT_EQ(summary.steps, expected.steps);
  EXPECT_EQ(summary.state_hash, expected.state_hash);
}

}  // namespace percuss::test::shell_triangle_test
