// Skins: shells without stress that carry mass, contact and pressure to their nodes, and are not computed.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::skin_test {
namespace {

using testing::HasSubstr;

/// A block of 0.1 m with a skin of 1 mm on its top, joined to it, or without. more: keys of the deck.
std::string make_scene(bool has_skin, const std::string& more) {
  return fmt::format(R"yaml(
units: m, kg, s
time: {{end: 1e-4}}
parts:
  block: {{box: {{size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}}, material: steel}}
{}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 2e11, poissons_ratio: 0.3}}
{}
output: {{history: {{every: 1e-5}}}}
{}
)yaml",
                     has_skin ? "  skin: {shell_plate: {size: [0.1, 0.1], cells: [4, 4]}, at: [0, 0, 0.1], thickness: "
                                "1e-3, material: paint}\njoin: true"
                              : "",
                     has_skin ? "  paint: {model: skin, density: 1500}" : "", more);
}

}  // namespace

TEST(Skin, TakesAPressureForTheBodyUnderIt) {
  const Outcome run = run_deck(make_scene(true, "loads: {pressure: [{faces: skin/top, value: 1e6}]}\n"));
  const double impulse = 1e6 * 0.01 * 1e-4;
  EXPECT_NEAR(run.history.last("momentum_z"), -impulse, 0.013 * impulse);  // half of one of 42 steps
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

TEST(Skin, CostsNoStep) {
  const auto steps = [](const std::string& deck) { return run_deck(deck).summary.steps; };
  const std::string plain = make_scene(false, ""), covered = make_scene(true, "");
  EXPECT_EQ(steps(covered), steps(plain));
}

TEST(Skin, HasItsMass) {
  const Outcome run = run_deck(make_scene(true, "initial: [{part: all, velocity: [3, 0, 0]}]\n"));
  const double mass = 7850 * 1e-3 + 1500 * 1e-5;
  EXPECT_NEAR(run.history.last("momentum_x"), 3 * mass, 1e-9 * mass);
  EXPECT_EQ(run.history.last("internal"), 0);
}

// A skin on a grid of beams falls on a held block: it touches with half its thickness, at each of its nodes.
TEST(Skin, Touches) {
  for (const char* enforcement : {"kinematic", "penalty"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
units: m, kg, s
time: {{end: 2e-3}}
parts:
  block: {{box: {{size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}}, material: steel, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  skin: {{shell_plate: {{size: [0.05, 0.05], cells: [2, 2]}}, at: [0.02, 0.02, 0.104], thickness: 2e-3, material: paint}}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 2e11, poissons_ratio: 0.3}}
  paint: {{model: skin, density: 1500, contact_modulus: 1e9}}
rigid_sets: {{sheet: {{nodes: skin}}}}
initial: [{{part: skin, velocity: [0, 0, -2]}}]
contact: {{surfaces: all, enforcement: {}}}
output: {{history: {{every: 1e-5, nodes: [{{name: corner, near: [0.02, 0.02, 0.104]}}]}}}}
)yaml",
                                             enforcement));
    EXPECT_GT(run.history.last("corner_z"), 0.1 + 1e-3 - 5e-5) << enforcement;
    EXPECT_GT(run.history.last("momentum_z"), -1e-3 * 2 * 1500 * 5e-6) << enforcement;
  }
}

TEST(Skin, IsRefusedWhereItCannotBe) {
  const auto refuse = [](const std::string& deck, const std::string& text) {
    EXPECT_THAT([&] { run_deck(deck); }, testing::ThrowsMessage<InputError>(HasSubstr(text)));
  };
  std::string solid = make_scene(false, "");
  refuse(solid.replace(solid.find("{model: elastic, density: 7850, youngs_modulus: 2e11, poissons_ratio: 0.3}"), 74,
                       "{model: skin, density: 7850}"),
         "has hex8 elements and a material of the model skin (only shells can)");
  refuse(
      "time: {end: 1}\nparts: {s: {shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1, material: m}}\n"
      "materials: {m: {model: skin, density: 1}}\n",
      "all parts are skins");
  refuse(make_scene(true, "contact: {surfaces: all, enforcement: penalty}\n"), "needs contact_modulus");
  std::string fails = make_scene(true, "");
  refuse(fails.replace(fails.find("density: 1500"), 13, "density: 1500, failure: {time: 1e-5}"), "never fails");
}

}  // namespace percuss::test::skin_test
