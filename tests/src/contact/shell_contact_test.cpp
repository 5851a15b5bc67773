// Contact of shells: from either side, with thickness, against shells and solids, with themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "kernels/contact/geometry/face_geometry.hpp"
#include "src/index.hpp"
#include "src/step/audit/audit.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

const std::string materials = R"(
materials:
  steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}
  soft: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 100e6, hardening_modulus: 100e6}
)";

/// A scene with what tests look at.
struct ShellScene : Scene {
  explicit ShellScene(const std::string& text) : Scene("time: {end: 1}\n" + text + materials) {
    report = contact.prepare(state.x, state.v);
    stepper.start(state);
  }

  /// Places of a part along an axis: least and greatest.
  std::array<double, 2> find_range(const std::string& part, int axis) const {
    const auto x = to_host(state.x);
    std::array<double, 2> range{1e300, -1e300};
    for (const int n : chunked.mesh.node_sets.at(part)) {
      const double place = x(static_cast<std::size_t>(n), static_cast<std::size_t>(axis));
      range = {std::min(range[0], place), std::max(range[1], place)};
    }
    return range;
  }

  /// Advances until something has touched, and so many steps more; returns whether all rows converged.
  bool advance_into_contact(int more) {
    bool converged = true;
    for (int i = 0; i < 2000 && more > 0; ++i) {
      stepper.advance(state);
      touched = touched || stepper.contact_report().interactions > 0;
      converged = converged && stepper.contact_report().converged;
      if (touched) --more;
    }
    return converged;
  }

  std::string report;
  bool touched = false;
};

const double exact = 1e-6;  // of a thickness; enforcement leaves 1e-7 of what closes in a step

TEST(ShellContact, PlatesStopOnEitherSideAtHalfTheThicknessOfBoth) {
  // b from above and c from below on a plate that is held: nothing but the plates' own thickness keeps them apart.
  ShellScene scene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, thickness: 0.004, material: steel}
  b: {shell_plate: {size: [0.08, 0.08], cells: [7, 7]}, at: [0.01, 0.011, 0.0031], thickness: 0.002, material: steel}
  c: {shell_plate: {size: [0.08, 0.08], cells: [6, 6]}, at: [0.01, 0.011, -0.0052], thickness: 0.006, material: steel}
initial: [{part: b, velocity: [0, 0, -10]}, {part: c, velocity: [0, 0, 10]}]
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic, tolerance: 1e-7}
)");
  EXPECT_EQ(scene.report, "");
  EXPECT_TRUE(scene.advance_into_contact(40));
  for (const double z : scene.find_range("b", 2)) EXPECT_NEAR(z, 0.003, exact * 0.002);
  for (const double z : scene.find_range("c", 2)) EXPECT_NEAR(z, -0.005, exact * 0.006);
}

TEST(ShellContact, ASolidAndAShellKeepHalfTheThicknessWhicheverFaceIsTheFiner) {
  for (const char* cells : {"[2, 2]", "[9, 9]"}) {
    ShellScene scene(R"(
parts:
  floor: {box: {size: [0.1, 0.1, 0.02], cells: [5, 5, 1]}, material: steel}
  plate: {shell_plate: {size: [0.06, 0.06], cells: )" +
                     std::string(cells) + R"(}, at: [0.013, 0.017, 0.0212], thickness: 0.002, material: steel}
initial: [{part: plate, velocity: [0, 0, -10]}]
conditions: [{nodes: floor, fixed: [x, y, z]}]
contact: {surfaces: all, enforcement: kinematic, tolerance: 1e-7}
)");
    EXPECT_TRUE(scene.advance_into_contact(40));
    for (const double z : scene.find_range("plate", 2)) EXPECT_NEAR(z, 0.021, exact * 0.002);
  }
}

TEST(ShellContact, NoSpeedIsTooHigh) {
  // Thirty thicknesses a step, from below.
  ShellScene scene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.1], cells: [2, 2]}, thickness: 0.0002, material: steel}
  b: {shell_plate: {size: [0.04, 0.04], cells: [1, 1]}, at: [0.03, 0.033, -0.01], thickness: 0.0002, material: steel}
initial: [{part: b, velocity: [0, 0, 2000]}]
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic}
)");
  scene.advance_into_contact(3);
  EXPECT_TRUE(scene.touched);
  for (const double z : scene.find_range("b", 2)) EXPECT_LT(z, -0.0002 * (1 - 1e-2));
}

TEST(ShellContact, ACornerStopsBeforeARimThatItMeetsFromTheFront) {
  // The corner of a cube, pointing along x, comes to the rim of a plate between its two sides and between two nodes.
  for (const char* height : {"0", "0.0003", "-0.0013"}) {
    ShellScene scene(R"(
parts:
  plate: {shell_plate: {size: [0.1, 0.05], cells: [2, 1]}, thickness: 0.004, material: steel}
  cube: {box: {size: [0.05, 0.05, 0.05], cells: [1, 1, 1]}, rotate: [{axis: z, angle: 45}, {axis: x, angle: 54.7356103}, {axis: y, angle: -90}], at: [-0.0021, 0.018, )" +
                     std::string(height) + R"(], material: steel}
initial: [{part: cube, velocity: [10, 0, 0]}]
conditions: [{nodes: plate, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all}
)");
    scene.advance_into_contact(60);
    EXPECT_TRUE(scene.touched);
    const double z = std::stod(height);
    EXPECT_LT(scene.find_range("cube", 0)[1], -0.98 * std::sqrt(0.002 * 0.002 - z * z)) << height;
  }
}

TEST(ShellContact, RimsThatMeetInOnePlaneKeepHalfTheThicknessOfBoth) {
  ShellScene scene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.1], cells: [2, 5]}, thickness: 0.004, material: steel}
  b: {shell_plate: {size: [0.05, 0.08], cells: [2, 3]}, at: [0.1032, 0.011, 0], thickness: 0.002, material: steel}
initial: [{part: b, velocity: [-10, 0, 0]}]
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic, tolerance: 1e-7}
)");
  double nearest = 1;
  for (int i = 0; i < 40; ++i) {
    scene.advance_into_contact(1);
    nearest = std::min(nearest, scene.find_range("b", 0)[0]);
  }
  EXPECT_TRUE(scene.touched);
  EXPECT_NEAR(nearest, 0.103, 1e-3 * 0.003);
}

TEST(ShellContact, FreeEdgesThatCrossKeepHalfTheThicknessOfBoth) {
  // Upright plates, one along x above one along y: no node of either is near the other.
  const auto scene = [](const std::string& edges) {
    return ShellScene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.05], cells: [2, 1]}, rotate: [{axis: x, angle: 90}], thickness: 0.004, material: steel}
  b: {shell_plate: {size: [0.1, 0.05], cells: [2, 1]}, rotate: [{axis: x, angle: 90}, {axis: z, angle: 90}], at: [0.03, -0.03, -0.0531], thickness: 0.002, material: steel}
initial: [{part: b, velocity: [0, 0, 10]}]
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}, {nodes: b, fixed: [x, y, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic, edges: )" +
                      edges + "}\n");
  };
  ShellScene crossing = scene("true");
  EXPECT_TRUE(crossing.advance_into_contact(1));
  EXPECT_TRUE(crossing.touched);
  const auto x = to_host(crossing.state.x);
  // The edge of b under a, at y = 0 between the nodes at -0.03 and 0.02.
  double low = 0, high = 0;
  for (const int n : crossing.chunked.mesh.node_sets.at("b/y_max")) {
    const auto i = static_cast<std::size_t>(n);
    if (std::abs(x(i, 1) + 0.03) < 1e-9) low = x(i, 2);
    if (std::abs(x(i, 1) - 0.02) < 1e-9) high = x(i, 2);
  }
  EXPECT_NEAR(low + 0.6 * (high - low), -0.003, 1e-3 * 0.0001);  // of the way of that step
  ShellScene passing = scene("false");
  passing.advance_into_contact(1);
  EXPECT_FALSE(passing.touched);
}

TEST(ShellContact, AnUprightPlateStandsOnAFace) {
  // Its lower nodes look out on the floor in the plane of the plate only.
  ShellScene scene(R"(
parts:
  floor: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, thickness: 0.002, material: steel}
  plate: {shell_plate: {size: [0.05, 0.03], cells: [3, 2]}, rotate: [{axis: x, angle: 90}], at: [0.021, 0.05, 0.0032], thickness: 0.004, material: steel}
initial: [{part: plate, velocity: [0, 0, -10]}]
conditions: [{nodes: floor, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic, friction: 0.1}
)");
  EXPECT_TRUE(scene.advance_into_contact(5));
  EXPECT_TRUE(scene.touched);
  EXPECT_NEAR(scene.find_range("plate", 2)[0], 0.003, 1e-3 * 0.003);
}

TEST(ShellContact, ShellsThickerThanTheirEdgesDoNotTouchTheirOwnFold) {
  // A square tube of plates 8 mm thick with edges of 5 mm: no node is in contact with the faces around its corner.
  ShellScene scene(R"(
parts: {tube: {shell_box_tube: {size: [0.04, 0.04], length: 0.04, cells: [8, 8, 8]}, thickness: 0.008, material: steel}}
initial: [{part: tube, velocity: [1, 2, 3], angular_velocity: [0, 100, 300]}]
contact: {surfaces: all}
)");
  EXPECT_EQ(scene.report, "");
  for (int i = 0; i < 20; ++i) {
    scene.stepper.advance(scene.state);
    ASSERT_EQ(scene.stepper.contact_report().interactions, 0);
  }
}

TEST(ShellContact, OverlapByThicknessAtTheStartStaysAsItIsWithoutForce) {
  for (const double height : {0.001, 0.0001}) {  // of 0.002, down to nearly the mid-surface
    ShellScene scene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, thickness: 0.002, material: steel}
  b: {shell_plate: {size: [0.05, 0.05], cells: [3, 3]}, at: [0.021, 0.023, )" +
                     std::to_string(height) + R"(], thickness: 0.002, material: steel}
initial: [{part: b, velocity: [0, 0, -1]}]
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic}
)");
    EXPECT_NE(scene.report.find("overlap another body at the start"), std::string::npos) << scene.report;
    EXPECT_EQ(scene.report.find("not in contact"), std::string::npos) << scene.report;
    scene.advance_into_contact(100);
    EXPECT_NEAR(scene.find_range("b", 2)[0], height, 1e-3 * 0.002);
    EXPECT_NEAR(scene.find_range("b", 2)[1], height, 1e-3 * 0.002);
  }
}

TEST(ShellContact, OverlapByThicknessIsPushedOutOnRequest) {
  ShellScene scene(R"(
parts:
  a: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, thickness: 0.002, material: steel}
  b: {shell_plate: {size: [0.05, 0.05], cells: [3, 3]}, at: [0.021, 0.023, -0.00195], thickness: 0.002, material: steel}
conditions: [{nodes: a, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, overlap: push_out}
)");
  scene.advance_into_contact(1300);
  EXPECT_LT(scene.find_range("b", 2)[1], -0.002 * (1 - 1e-3));
}

struct Closed {
  AuditResult audit;
  double deepest = 0;
  int pushes = 0;
};

Closed run_closed(ShellScene& scene, int steps) {
  Audit audit(scene.model);
  Closed closed;
  closed.audit = audit(scene.state);
  for (int i = 0; i < steps; ++i) {
    scene.stepper.advance(scene.state);
    closed.pushes += scene.stepper.contact_report().interactions;
  }
  closed.deepest = scene.contact.measure_penetration(scene.state.x);
  closed.audit = audit(scene.state);
  return closed;
}

TEST(ShellContact, BallsOnBothSidesOfAPlateKeepMomentumAndEnergy) {
  ShellScene scene(R"(
parts:
  above: {sphere: {radius: 0.01, cells: 4}, at: [0.051, 0.052, 0.0121], material: steel}
  below: {sphere: {radius: 0.01, cells: 4}, at: [0.049, 0.046, -0.0122], material: steel}
  plate: {shell_plate: {size: [0.1, 0.1], cells: [10, 10]}, thickness: 0.004, material: steel}
initial: [{part: above, velocity: [3, 0, -20], angular_velocity: [0, 500, 900]}, {part: below, velocity: [-3, 0, 40]}]
contact: {surfaces: all, friction: 0.3}
)");
  const Closed closed = run_closed(scene, 300);
  EXPECT_GT(closed.pushes, 50);
  EXPECT_LT(closed.audit.momentum.linear_error, 1e-12);
  EXPECT_LT(closed.audit.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(closed.audit.energy.error), 1e-3);
  EXPECT_LT(closed.audit.energy.friction, 0);  // a rub takes, also where it turns the plate
  EXPECT_LT(closed.deepest, 0.01);
}

const std::string flattened_ring = R"(
parts: {ring: {shell_tube: {radius: 0.02, length: 0.02, cells: [32, 2]}, thickness: 0.002, material: soft}}
initial:
  - {nodes: {name: ring, inside: [[-0.03, 0.008, -1], [0.03, 0.03, 1]]}, velocity: [0, -150, 0]}
  - {nodes: {name: ring, inside: [[-0.03, -0.03, -1], [0.03, -0.008, 1]]}, velocity: [0, 150, 0]}
contact: {surfaces: all, enforcement: kinematic, friction: 0.2)";

TEST(ShellContact, PairsLeftOutOfTheCheckChangeNoBit) {
  ShellScene near(flattened_ring + "}\n"), all(flattened_ring + ", reuse_search: false}\n");
  for (ShellScene* scene : {&near, &all})
    for (int i = 0; i < 1200; ++i) scene->stepper.advance(scene->state);
  EXPECT_EQ(hash_state(near.model, near.state), hash_state(all.model, all.state));
  const PairCounts counts = near.contact.pair_counts();
  EXPECT_GT(static_cast<double>(counts.left_out), 0.4 * static_cast<double>(counts.candidates));
  EXPECT_EQ(all.contact.pair_counts().left_out, 0);
}

/// Distances of nodes from facets, whichever diagonal divides these.
struct Nearest {
  double to_face = 1e300;   // where a node stands over it
  double to_ridge = 1e300;  // where it stands beside it

  void take(const Point3& p, const Point3 (&facet)[4]) {
    for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 3}, std::array{0, 1, 3}, std::array{1, 2, 3}}) {
      const Point3 a = facet[i] - p, b = facet[j] - p, c = facet[k] - p, share = find_closest_on_triangle(a, b, c);
      double& least = std::min({share.x, share.y, share.z}) > 0 ? to_face : to_ridge;
      least = std::min(least, norm(share.x * a + share.y * b + share.z * c));
    }
  }
};

TEST(ShellContact, AFlattenedRingLiesOnItselfAndDoesNotGoThrough) {
  ShellScene scene(flattened_ring + "}\n");
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<int> above;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (mesh.nodes[n][1] > 0.003) above.push_back(static_cast<int>(n));
  std::vector<std::array<int, 4>> below;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const std::span<const int> c = mesh.corners(e);
    const auto is_low = [&](int n) { return mesh.nodes[at(n)][1] < -0.003; };
    if (std::all_of(c.begin(), c.end(), is_low)) below.push_back({c[0], c[1], c[2], c[3]});
  }
  Nearest nearest;
  Audit audit(scene.model);
  audit(scene.state);
  for (int i = 0; i < 1200; ++i) {
    scene.stepper.advance(scene.state);
    const auto x = to_host(scene.state.x);
    for (const int n : above)
      for (const auto& facet : below)
        nearest.take(load_row(x, n),
                     {load_row(x, facet[0]), load_row(x, facet[1]), load_row(x, facet[2]), load_row(x, facet[3])});
  }
  EXPECT_EQ(above.size(), 45U);
  EXPECT_EQ(below.size(), 28U);
  EXPECT_NEAR(nearest.to_face, 0.002, 2e-3 * 0.002);   // they have met, and kept the thickness
  EXPECT_NEAR(nearest.to_ridge, 0.002, 3e-2 * 0.002);  // likewise where facets that tilt meet in a ridge
  const AuditResult books = audit(scene.state);
  EXPECT_LT(books.momentum.linear_error, 1e-12);
  EXPECT_LT(books.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(books.energy.error), 1e-3);
}

}  // namespace
}  // namespace percuss::test
