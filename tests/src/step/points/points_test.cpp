// Material points inside elements, and single points of integration, in the history.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "src/step/model/material_place.hpp"
#include "src/step/results/fields/element_fields.hpp"
#include "src/step/results/history.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

/// The place that weights give.
Vec3 sum_corners(const MaterialPlace& place, const ElementCorners& x) {
  Vec3 sum{};
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += place.weights[i] * x[i][k];
  return sum;
}

std::string make_spinning(const std::string& history) {
  return R"(
time: {end: 1, max_steps: 40}
parts:
  solid: {box: {size: [1, 0.8, 0.6], cells: [3, 3, 2]}, material: m}
  tets: {box: {size: [1, 0.8, 0.6], cells: [2, 2, 2]}, elements: tetrahedra, at: [2, 0, 0], material: m}
  wedges: {box: {size: [1, 0.8, 0.6], cells: [2, 2, 2]}, elements: wedges, at: [4, 0, 0], material: m}
  pyramids: {box: {size: [1, 0.8, 0.6], cells: [2, 2, 2]}, elements: pyramids, at: [6, 0, 0], material: m}
  sheet: {shell_plate: {size: [1, 0.8], cells: [4, 3]}, thickness: 0.05, at: [8, 0, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial:
  - {part: all, velocity: [0.1, 0.2, 0.3]}
contact: {surfaces: none}
output: {history: {every: 0, )" +
         history + "}}\n";
}

const std::string five_points =
    "points: [{name: p0, at: [0.41, 0.33, 0.17]}, {name: p1, at: [2.41, 0.33, 0.17], part: tets}, "
    "{name: p2, at: [4.41, 0.33, 0.17]}, {name: p3, at: [6.41, 0.33, 0.17]}, {name: p4, at: [8.41, 0.33, 0.02]}]";

}  // namespace

TEST(MaterialPlace, IsFoundInADistortedHexahedron) {
  const ElementCorners x{
      {{0, 0, 0}, {1.2, 0.1, 0}, {1, 0.9, 0.2}, {-0.1, 1, 0.1}, {0.1, 0, 1}, {1, 0, 1.3}, {1.1, 1, 0.9}, {0, 1.1, 1}}};
  for (const Vec3& place : {Vec3{0.5, 0.5, 0.5}, Vec3{0.9, 0.2, 0.3}, Vec3{0.1, 0.9, 0.9}}) {
    const MaterialPlace found = find_material_place(x, false, place);
    EXPECT_LT(found.distance, 1e-14);
    EXPECT_LT(find_distance(sum_corners(found, x), place), 1e-14);
    double sum = 0;
    for (const double w : found.weights) sum += w;
    EXPECT_NEAR(sum, 1, 1e-15);
  }
  EXPECT_NEAR(find_material_place(x, false, {0.5, 0.5, 5}).distance, 4, 0.2);
}

TEST(MaterialPlace, OfAShellIsTheNearestOfItsMiddle) {
  const ElementCorners x{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {}, {}, {}, {}}};
  const MaterialPlace found = find_material_place(x, true, {0.5, 0.75, 0.125});
  EXPECT_NEAR(found.distance, 0.125, 1e-15);
  EXPECT_NEAR(found.weights[0], 0.75 * 0.25, 1e-15);
  EXPECT_NEAR(found.weights[2], 0.25 * 0.75, 1e-15);
}

TEST(MaterialPoints, MoveWithTheirElements) {
  const Outcome run = run_deck(make_spinning(five_points), {});
  ASSERT_EQ(run.history.rows(), 41u);
  for (std::size_t p = 0; p < 5; ++p) {
    const std::string name = fmt::format("p{}", p);
    for (const std::size_t row : {std::size_t{0}, std::size_t{40}}) {
      const double time = run.history["time"][row];
      EXPECT_NEAR(run.history[name + "_x"][row], 2.0 * static_cast<double>(p) + 0.41 + 0.1 * time, 1e-13) << name;
      EXPECT_NEAR(run.history[name + "_y"][row], 0.33 + 0.2 * time, 1e-13) << name;
      EXPECT_NEAR(run.history[name + "_z"][row], (p == 4 ? 0 : 0.17) + 0.3 * time, 1e-13) << name;
      EXPECT_NEAR(run.history[name + "_vz"][row], 0.3, 1e-13) << name;
    }
  }
}

TEST(MaterialPoints, HaveTheVelocityOfASpinningBody) {
  std::string deck = make_spinning(five_points);
  const std::string flight = "{part: all, velocity: [0.1, 0.2, 0.3]}";
  deck.replace(deck.find(flight), flight.size(),
               "{part: solid, angular_velocity: [0.3, -0.2, 0.5], center: [0.5, 0.4, 0.3]}");
  const Outcome run = run_deck(deck, {"time.max_steps=1"});
  // w x r: linear in the place, which shape functions keep.
  const Vec3 r{0.41 - 0.5, 0.33 - 0.4, 0.17 - 0.3}, v = cross({0.3, -0.2, 0.5}, r);
  EXPECT_NEAR(run.history["p0_vx"][0], v[0], 1e-14);
  EXPECT_NEAR(run.history["p0_vy"][0], v[1], 1e-14);
  EXPECT_NEAR(run.history["p0_vz"][0], v[2], 1e-14);
}

TEST(MaterialPoints, OutsideOfAllElementsAreRefused) {
  for (const char* point : {"points: [{name: p, at: [1.5, 0.3, 0.3]}]", "points: [{name: p, at: [8.4, 0.3, 0.03]}]",
                            "points: [{name: p, at: [0.4, 0.3, 0.2], part: tets}]"})
    EXPECT_ERROR(
        {
          const Scene scene(make_spinning(point));
          History::check_points(scene.deck, scene.chunked, scene.model);
        },
        InputError, "holds the place")
        << point;
}

/// A sheet that is bent to a cylinder by turning its ends, and a block with 2x2x2 points that is stretched.
const std::string bent = R"(
time: {end: 0.5}
parts:
  sheet: {shell_plate: {size: [1, 0.2], cells: [10, 2]}, thickness: 0.02, points: 3, material: m}
  block: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 5, 0], material: m, integration: full}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0}}
conditions:
  - {nodes: sheet/x_min, velocity: {ry: -0.01}}
  - {nodes: sheet/x_max, velocity: {ry: 0.01}}
  - {nodes: block/z_min, fixed: [x, y, z]}
  - {nodes: block/z_max, velocity: {x: 0, y: 0, z: 0.01}}
contact: {surfaces: none}
output: {history: {every: 0.5, elements: [
  {name: low, near: [0.45, 0.05, 0], part: sheet, point: 1}, {name: middle, near: [0.45, 0.05, 0], part: sheet, point: 2},
  {name: high, near: [0.45, 0.05, 0], part: sheet, point: 3}, {name: mean, near: [0.45, 0.05, 0], part: sheet},
  {name: g1, id: 21, point: 1}, {name: g2, id: 21, point: 2}, {name: g8, id: 21, point: 8}, {name: g, id: 21}]}}
)";

TEST(ElementPoints, AreThoseOfTheirLayers) {
  const std::string deck = bent;
  const Outcome run = run_deck(deck, {});
  const auto at_end = [&](const std::string& column) { return run.history.last(column); };
  EXPECT_GT(std::abs(at_end("low_stress_xx")), 1e-3);
  // Opposite on both faces, but for the stretch of the middle, and none between them.
  EXPECT_NEAR(at_end("low_stress_xx") + at_end("high_stress_xx"), 2 * at_end("middle_stress_xx"),
              1e-9 * std::abs(at_end("low_stress_xx")));
  EXPECT_NEAR(at_end("middle_stress_xx"), at_end("mean_stress_xx"), 1e-9 * std::abs(at_end("low_stress_xx")));
  // An even stretch is the same at all points of a solid.
  EXPECT_GT(at_end("g_stress_zz"), 0.1);
  for (const char* name : {"g1", "g2", "g8"})
    EXPECT_NEAR(at_end(std::string(name) + "_stress_zz"), at_end("g_stress_zz"), 1e-12) << name;
}

TEST(ElementPoints, ThatAnElementDoesNotHaveAreRefused) {
  const std::string deck = bent;
  const auto try_point = [&](const std::string& from, const std::string& to) {
    std::string text = deck;
    text.replace(text.find(from), from.size(), to);
    const Scene scene(text);
    History::check_points(scene.deck, scene.chunked, scene.model);
  };
  EXPECT_NO_THROW(try_point("point: 8", "point: 7"));
  EXPECT_ERROR(try_point("point: 8", "point: 9"), InputError, "is point 9 of an element that has 8");
  EXPECT_ERROR(try_point("part: sheet, point: 3", "part: sheet, point: 4"), InputError,
               "is point 4 of an element that has 3");
}

}  // namespace percuss::test
