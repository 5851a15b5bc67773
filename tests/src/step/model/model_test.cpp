// Masses, initial velocities and held directions of the model that a deck builds.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "src/error.hpp"
#include "tests/src/mesh/mesh_measures.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

// Four shapes, each of its own density, none of them at the origin.
const std::string four_shapes = R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 2, 3], cells: [3, 2, 5]}, at: [10, 0, 0], material: light}
  b: {cylinder: {radius: 1, length: 2, cells: [5, 4]}, axis: x, at: [0, 10, 0], material: heavy}
  c: {tube: {inner_radius: 0.5, outer_radius: 0.8, length: 1, cells: [2, 12, 3]}, at: [0, 0, 10], material: light}
  d: {sphere: {radius: 0.7, cells: 5}, at: [-10, 0, 0], material: heavy}
materials:
  light: {model: elastic, density: 900, youngs_modulus: 1e9, poissons_ratio: 0.3}
  heavy: {model: j2_plasticity, density: 19000, youngs_modulus: 1e11, poissons_ratio: 0.3, yield_stress: 1e8, hardening_modulus: 0}
)";

std::string take_error(const std::string& text) {
  try {
    const Scene scene(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(Model, MassIsDensityTimesVolumeForEveryShape) {
  const Scene scene(four_shapes);
  const Mesh& mesh = scene.chunked.mesh;
  const auto element_mass = to_host(scene.model.element_mass);
  double sum = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double density = mesh.part_of(e) % 2 == 0 ? 900 : 19000;
    const double expected = density * testing_mesh::gauss_volume(testing_mesh::corners_of(mesh, e));
    EXPECT_NEAR(element_mass(e) / expected, 1, 1e-13) << "element " << e;
    sum += expected;
  }
  EXPECT_NEAR(scene.model.total_mass / sum, 1, 1e-13);
}

TEST(Model, NodesShareTheMassOfTheirElements) {
  const Scene scene(four_shapes);
  const Mesh& mesh = scene.chunked.mesh;
  const auto element_mass = to_host(scene.model.element_mass);
  const auto mass = to_host(scene.model.mass);
  std::vector<double> expected(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (const int n : mesh.corners(e)) expected[static_cast<std::size_t>(n)] += element_mass(e) / 8;
  }
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_DOUBLE_EQ(mass(n), expected[n]);
}

TEST(Model, MomentsAreTakenAboutTheMassCentre) {
  const Scene scene(R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [4, 0, 0], material: steel}
  b: {box: {size: [1, 1, 3], cells: [2, 2, 2]}, at: [0, 8, 0], material: steel}
)" + steel_text);
  // masses 1 : 3, centres (4.5, 0.5, 0.5) and (0.5, 8.5, 1.5)
  const Vec3 expected{(4.5 + 3 * 0.5) / 4, (0.5 + 3 * 8.5) / 4, (0.5 + 3 * 1.5) / 4};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(scene.model.mass_center[k], expected[k], 1e-14 * 10);
}

TEST(Model, InitialSpinIsAboutTheMassCentreOfTheSelectionUnlessACenterIsGiven) {
  const std::string parts = R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 2, 3], cells: [2, 3, 2]}, at: [5, 5, 5], material: steel}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}
)" + steel_text;
  const auto expect_spin = [](const Scene& scene, const Vec3& c, const Vec3& v0) {
    const auto v = to_host(scene.model.start_velocity);
    for (const int node : scene.chunked.mesh.node_sets.at("a")) {
      const auto n = static_cast<std::size_t>(node);
      const Vec3& x = scene.chunked.mesh.nodes[n];
      EXPECT_NEAR(v(n, 0), v0[0] - 7 * (x[1] - c[1]), 1e-12);
      EXPECT_NEAR(v(n, 1), v0[1] + 7 * (x[0] - c[0]), 1e-12);
      EXPECT_NEAR(v(n, 2), v0[2], 1e-12);
    }
    for (const int node : scene.chunked.mesh.node_sets.at("b")) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(v(static_cast<std::size_t>(node), k), 0);
    }
  };
  expect_spin(Scene(parts + "initial: [{part: a, angular_velocity: [0, 0, 7], velocity: [1, 2, 3]}]\n"), {5.5, 6, 6.5},
              {1, 2, 3});
  expect_spin(Scene(parts + "initial: [{part: a, angular_velocity: [0, 0, 7], center: [1, 0, 0]}]\n"), {1, 0, 0},
              {0, 0, 0});
}

// Points at distances 0, 3, 4, 5 and 13 from the centre and from the axis, where directions are ratios of integers.
TEST(Model, ARadialVelocityPointsAwayFromItsCenterOrAxisAtOneSpeed) {
  const std::string parts = R"(
time: {end: 1}
parts: {a: {box: {size: [3, 4, 12], cells: [1, 1, 1]}, at: [1, 2, 3], material: steel}}
)" + steel_text;
  const auto expect_radial = [&](const std::string& radial, const Vec3& counts, double speed, const Vec3& plus) {
    const Scene scene(parts + "initial: [{part: a, " + radial + "}]\n");
    const auto v = to_host(scene.model.start_velocity);
    ASSERT_EQ(v.extent(0), 8U);
    for (std::size_t n = 0; n < 8; ++n) {
      const Vec3& x = scene.chunked.mesh.nodes[n];
      const Vec3 r{counts[0] * (x[0] - 1), counts[1] * (x[1] - 2), counts[2] * (x[2] - 3)};
      const double radius = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(v(n, k), plus[k] + (radius > 0 ? speed * r[k] / radius : 0), 1e-14) << n << " " << k;
    }
  };
  expect_radial("radial_velocity: {speed: 6, center: [1, 2, 3]}", {1, 1, 1}, 6, {});
  expect_radial("radial_velocity: {speed: -6, center: [1, 2, 3], axis: z}", {1, 1, 0}, -6, {});
  expect_radial("velocity: [1, 2, 3], radial_velocity: {speed: 6, center: [1, 2, 7], axis: [0, 0, -2]}", {1, 1, 0}, 6,
                {1, 2, 3});
  expect_radial("radial_velocity: {speed: 6, center: [1.000000001, 2, 3], axis: x}", {0, 1, 1}, 6, {});
}

TEST(Model, ANodeWithinRoundOffOfTheRadialCenterStays) {
  const Scene scene(R"(
time: {end: 1}
parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}}
initial: [{radial_velocity: {speed: 6, center: [1.0e-10, 0, 0]}}]
)" + steel_text);
  const auto v = to_host(scene.model.start_velocity);
  for (std::size_t n = 0; n < 8; ++n) {
    const bool is_center = scene.chunked.mesh.nodes[n] == Vec3{0, 0, 0};
    EXPECT_NEAR(std::hypot(v(n, 0), v(n, 1), v(n, 2)), is_center ? 0 : 6, is_center ? 0 : 1e-14);
  }
}

TEST(Model, LaterInitialVelocitiesReplaceEarlierOnes) {
  const Scene scene(R"(
time: {end: 1}
parts: {a: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: steel}}
initial: [{part: a, velocity: [1, 1, 1]}, {nodes: a/x_max, velocity: [0, 0, 9]}]
)" + steel_text);
  const auto v = to_host(scene.model.start_velocity);
  for (std::size_t n = 0; n < v.extent(0); ++n) {
    const bool is_end = scene.chunked.mesh.nodes[n][0] == 2;
    EXPECT_EQ(v(n, 0), is_end ? 0 : 1);
    EXPECT_EQ(v(n, 2), is_end ? 9 : 1);
  }
}

TEST(Model, HeldDirectionsHaveNoInverseMassAndOthersDo) {
  const Scene scene(R"(
time: {end: 1}
parts: {a: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: steel}}
conditions: [{nodes: a/x_min, fixed: [x, z]}, {nodes: a/x_max, velocity: {y: 1}}, {nodes: a/z_min, symmetry: z}]
)" + steel_text);
  const auto w = to_host(scene.model.inverse_mass);
  const auto mass = to_host(scene.model.mass);
  for (std::size_t n = 0; n < w.extent(0); ++n) {
    const Vec3& x = scene.chunked.mesh.nodes[n];
    const bool held[3] = {x[0] == 0, x[0] == 2, x[0] == 0 || x[2] == 0};
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(w(n, k), held[k] ? 0 : 1 / mass(n));
  }
}

TEST(Model, TwoConditionsThatMoveANodeAreRefusedWithBothPlaces) {
  const std::string parts = R"(time: {end: 1}
parts: {a: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: steel}}
)";
  const std::string error = take_error(parts + R"(conditions:
  - {nodes: a/x_min, velocity: {y: 1}}
  - {nodes: a/z_min, fixed: [y]}
)" + steel_text);
  EXPECT_THAT(error, HasSubstr("deck.yaml:5:13: error: node "));
  EXPECT_THAT(error, HasSubstr("is held in direction y by two conditions"));
  EXPECT_THAT(error, HasSubstr("deck.yaml:4:13"));
  // Resting twice is no contradiction, nor is another direction.
  EXPECT_EQ(
      take_error(
          parts +
          "conditions: [{nodes: a/x_min, fixed: [y]}, {nodes: a/z_min, symmetry: y}, {nodes: a, velocity: {x: 1}}]\n" +
          steel_text),
      "no error");
}

TEST(Model, AConditionOnNothingIsRefusedAtItsPlace) {
  const std::string error = take_error(R"(time: {end: 1}
parts: {a: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: steel}}
conditions:
  - {nodes: {name: a, inside: [[5, 5, 5], [6, 6, 6]]}, fixed: [x]}
)" + steel_text);
  EXPECT_THAT(error, HasSubstr("deck.yaml:4:"));
  EXPECT_THAT(error, HasSubstr("no node"));
}

}  // namespace percuss::test
