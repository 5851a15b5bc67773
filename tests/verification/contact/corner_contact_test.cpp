// Elastic cubes that meet with tips, edges and corners: contact gives no energy and lets nothing in
// (docs/theory_contact.md, section 5).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/src/step/scene.hpp"
#include "tests/verification/contact/closest_depth.hpp"

namespace percuss::test::corner_contact_test {
namespace {

/// Two cubes of 0.1, the upper one of which comes down.
struct Impact {
  std::string upper, lower;  // "rotate: ..., at: ..."
  double speed = 5, end = 1.2e-3;
  int cells = 4;
  std::string contact = "edges: true";
  std::string material = "{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}";
  Vec3 direction{0, 0, -1};
};

// A cube on its tip at the origin, one below it with its tip up, one with an edge up along x.
const std::string on_tip = "rotate: [{axis: z, angle: 45}, {axis: [1, 0, 0], angle: 54.7356103172453}]";
const std::string tip_up =
    "rotate: [{axis: z, angle: 45}, {axis: [1, 0, 0], angle: 54.7356103172453}, {axis: x, angle: 180}]";
const std::string edge_up = "rotate: [{axis: x, angle: 45}], at: [0, 0, -0.1424213562]";

std::string edge_down(double angle) {
  return fmt::format(
      "rotate: [{{axis: x, angle: 45}}, {{axis: z, angle: {}, center: [0.05, 0, 0]}}], at: [0.003, 0.002, 0]", angle);
}

std::string write_deck(const Impact& impact) {
  const std::string cube =
      fmt::format("box: {{size: [0.1, 0.1, 0.1], cells: [{0}, {0}, {0}]}}, material: m", impact.cells);
  const Vec3& d = impact.direction;
  return fmt::format(
      "time: {{end: {}}}\nparts:\n  a: {{{}, {}}}\n  b: {{{}, {}}}\nmaterials: {{m: {}}}\n"
      "initial: [{{part: a, velocity: [{}, {}, {}]}}]\ncontact: {{{}}}\n",
      impact.end, cube, impact.upper, cube, impact.lower, impact.material, impact.speed * d[0], impact.speed * d[1],
      impact.speed * d[2], impact.contact);
}

/// Shares of the initial energy that contact had given at most, and at the end; the deepest that an edge or a node was
/// inside the other cube, in edges of an element; change of momentum over that of the upper cube.
struct Result {
  double gain = 0, work = 0, depth = 0, momentum = 0;
};

Result run(const Impact& impact) {
  Scene scene(write_deck(impact));
  scene.contact.prepare(scene.state.x, scene.state.v);
  scene.stepper.start(scene.state);
  const double initial = 0.25 * scene.model.total_mass * impact.speed * impact.speed;
  Result result;
  while (scene.state.time < scene.deck.time.end) {
    scene.stepper.advance(scene.state);
    if (scene.state.bound.failed_element >= 0) {
      ADD_FAILURE() << "an element inverted at " << scene.state.time;
      break;
    }
    result.work = (scene.state.books.contact_work + scene.stepper.contact_report().stored) / initial;
    result.gain = std::max(result.gain, result.work);
    if (scene.state.step % 5 == 0)
      result.depth = std::max(result.depth, find_closest_depth(scene.chunked, scene.state.x));
  }
  const auto v = to_host(scene.state.v);
  const auto mass = to_host(scene.state.mass);
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (std::size_t n = 0; n < v.extent(0); ++n) sum += mass(n) * v(n, k);
    const double start = 0.5 * scene.model.total_mass * impact.speed;
    result.momentum = std::max(result.momentum, std::abs(sum / start - impact.direction[k]));
  }
  return result;
}

void expect(const char* name, const Impact& impact, double most_gain, double most_depth) {
  const Result result = run(impact);
  fmt::print("{:28} gain {:8.4f} %  work {:8.4f} %  depth {:.4f}  momentum {:.1e}\n", name, 100 * result.gain,
             100 * result.work, result.depth, result.momentum);
  EXPECT_LT(result.gain, most_gain) << name;
  EXPECT_LT(result.depth, most_depth) << name;
  EXPECT_LT(result.momentum, 1e-12) << name;
}

// Shares of the initial energy, and of an edge.
constexpr double gain = 1e-4, depth = 0.005;

TEST(CornerContact, TipsOnTips) {
  const std::string below = ", at: [0, 0, -0.001]", beside = ", at: [0.003, 0.002, 0]";
  expect("tip on tip", {on_tip, tip_up + below}, gain, depth);
  expect("tip on tip, fine", {on_tip, tip_up + below, 5, 1.2e-3, 8}, gain, depth);
  expect("tip on tip, 50 m/s", {on_tip, tip_up + below, 50, 6e-4}, gain, depth);
  expect("tip beside tip", {on_tip + beside, tip_up + below, 5, 2.4e-3}, gain, depth);
  expect("tip beside tip, 50 m/s", {on_tip + beside, tip_up + below, 50, 6e-4}, gain, depth);
}

TEST(CornerContact, TipsOnTipsByTheOtherEnforcements) {
  const std::string below = ", at: [0, 0, -0.001]";
  expect("lagrange", {on_tip, tip_up + below, 5, 1.2e-3, 4, "edges: true, enforcement: lagrange"}, gain, depth);
  // Springs give and take what the books of a step have only in the mean.
  expect("penalty", {on_tip, tip_up + below, 5, 1.2e-3, 4, "edges: true, enforcement: penalty"}, 1e-3, 0.05);
}

TEST(CornerContact, TipsOnEdgesAndFaces) {
  expect("tip on edge", {on_tip + ", at: [0.05, 0, 0]", edge_up}, gain, depth);
  expect("tip on face", {on_tip + ", at: [0.053, 0.047, 0]", "at: [0, 0, -0.101]"}, gain, depth);
}

TEST(CornerContact, EdgesOnEdges) {
  expect("edges at 90 degrees", {edge_down(90), edge_up}, gain, depth);
  expect("edges at 90 degrees, 50 m/s", {edge_down(90), edge_up, 50, 6e-4}, gain, depth);
  expect("edges at 10 degrees", {edge_down(10), edge_up}, gain, depth);
  // The crossing runs along nearly parallel edges that bend, faster than a step follows.
  expect("edges at 10 degrees, 50 m/s", {edge_down(10), edge_up, 50, 6e-4}, 5e-3, 0.02);
}

TEST(CornerContact, Corners) {
  const double d = -1 / std::sqrt(3.0);
  Impact corner{"at: [0.0005, 0.0005, 0.0005]", "at: [-0.1, -0.1, -0.1]", 8.66};
  corner.direction = {d, d, d};
  expect("corners", corner, gain, depth);
  corner.cells = 1;
  expect("corners of one element", corner, gain, depth);
}

}  // namespace
}  // namespace percuss::test::corner_contact_test
