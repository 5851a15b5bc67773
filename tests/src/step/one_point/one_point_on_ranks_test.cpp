// Wedges and pyramids on many ranks: every rank also holds the whole scene alone, and compares its share of the one
// with the other, bit by bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "comm/all_reduce.hpp"
#include "src/error.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "tests/src/step/two_scenes.hpp"

namespace percuss::test {
namespace {

// A compiled-in, another and a called material, beside hexahedra and tetrahedra; contact, pressure, held nodes,
// failure.
const std::string joined_text = R"yaml(
time: {end: 1}
parts:
  low: {box: {size: [0.04, 0.04, 0.01], cells: [6, 5, 2]}, elements: wedges, material: copper}
  lid: {box: {size: [0.04, 0.04, 0.004], cells: [6, 5, 1]}, elements: wedges, at: [0, 0, 0.01], material: steel}
  ball: {sphere: {radius: 0.008, cells: 6}, elements: pyramids, at: [0.021, 0.019, 0.0222], material: hot}
  block: {box: {size: [0.01, 0.01, 0.01], cells: [4, 4, 4]}, at: [0.0005, 0.028, 0.0141], material: steel}
  cap: {box: {size: [0.01, 0.01, 0.005], cells: [4, 4, 2]}, elements: pyramids, at: [0.0005, 0.028, 0.0241], material: rubber}
join: [{parts: [low, lid]}, {parts: [block, cap]}]
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  rubber: {model: neo_hookean, density: 1100, youngs_modulus: 2e8, poissons_ratio: 0.49}
  hot: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 90e6, hardening_modulus: 1e9, failure: {plastic_strain: 0.02, fade_steps: 4}}
loads: {pressure: [{faces: low/x_max, value: 1e8}]}
initial: [{part: ball, velocity: [20, 10, -400]}, {part: block, velocity: [0, 0, -60]}]
conditions: [{nodes: low/z_min, fixed: [x, y, z]}]
contact: {surfaces: all, friction: 0.2}
)yaml";

TEST(OnePointOnRanks, BesideHexahedraHaveTheBitsOfOneRank) {
  TwoScenes scenes(joined_text);
  scenes.run(60);
  expect_same_rows(scenes, scenes.together.state.x, scenes.alone.state.x, "position");
  expect_same_rows(scenes, scenes.together.state.v, scenes.alone.state.v, "velocity");
  EXPECT_EQ(hash_state(scenes.together.model, scenes.together.state),
            hash_state(scenes.alone.model, scenes.alone.state));
  EXPECT_EQ(scenes.together.state.next_dt, scenes.alone.state.next_dt);
  EXPECT_GT(scenes.alone.stepper.contact_report().interactions, 0);
}

/// A brick of wedges or pyramids, of density 7800.
std::string make_brick(const std::string& kind, const std::string& cells) {
  return "time: {end: 1}\nparts: {box: {box: {size: [1, 2, 3], cells: " + cells + "}, elements: " + kind +
         ", material: m}}\nmaterials: {m: {model: elastic, density: 7800, youngs_modulus: 2e11, poissons_ratio: "
         "0.3}}\n";
}

/// Masses of the nodes that the scene's ranks own, of all of them together.
double sum_masses(const Scene& scene) {
  const auto mass = to_host(scene.model.mass);
  double sum = 0;
  for (std::size_t n = 0; n < mass.extent(0); ++n)
    if (owns_node(scene.chunked, static_cast<int>(n))) sum += mass(n);
  all_reduce(scene.model.ranks, Reduce::sum, sum);
  return sum;
}

TEST(OnePointOnRanks, HaveTheMassOfTheirVolume) {
  constexpr double expected = 7800 * 6;
  for (const char* kind : {"wedges", "pyramids"}) {
    const Scene scene(make_brick(kind, "[7, 6, 5]"));
    EXPECT_NEAR(sum_masses(scene), expected, 1e-12 * expected) << kind;
    EXPECT_NEAR(scene.model.total_mass, expected, 1e-12 * expected) << kind;
  }
}

TEST(OnePointOnRanks, ShareTheirMassAsTheirCornersDo) {
  constexpr double whole = 7800 * 6;
  const auto count = [&](const std::string& kind, double share) {
    const Scene scene(make_brick(kind, "[1, 1, 1]"), Communicator(MPI_COMM_SELF));
    const auto mass = to_host(scene.model.mass);
    return std::count_if(mass.data(), mass.data() + mass.extent(0),
                         [&](double m) { return std::abs(m / whole - share) < 1e-12; });
  };
  // the middle has a quarter of all; each corner 3/16 of three of the six pyramids
  EXPECT_EQ(count("pyramids", 0.25), 1);
  EXPECT_EQ(count("pyramids", 0.09375), 8);
  // two wedges: corners on the cut have a sixth, the others a twelfth
  EXPECT_EQ(count("wedges", 1.0 / 6), 4);
  EXPECT_EQ(count("wedges", 1.0 / 12), 4);
}

TEST(OnePointOnRanks, GetMassWhereTheDeckScalesIt) {
  for (const char* kind : {"wedges", "pyramids"}) {
    Scene scene(std::string("time: {end: 1, mass_scaling: {step: 3e-5, max_added: 9, every: 1}}\n") + R"yaml(
parts: {box: {box: {size: [1, 1, 0.4], cells: [2, 2, 2]}, elements: )yaml" +
                kind + ", material: steel}}\n" + steel_text);
    scene.run(3);
    EXPECT_GT(scene.state.bound.step, 2.9999e-5) << kind;
  }
}

TEST(OnePointOnRanks, AreRefusedWhereTheirBoundIsNotKnown) {
  EXPECT_THAT(
      [] {
        const Scene scene(R"(
time: {end: 1, step_estimate: global}
parts: {box: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, elements: wedges, material: steel}}
)" + steel_text);
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("part 'box' has wedges")));
}

}  // namespace
}  // namespace percuss::test
