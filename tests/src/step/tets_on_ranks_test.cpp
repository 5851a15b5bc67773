// Tetrahedra on many ranks: every rank also holds the whole scene alone, and compares its share of the one with the
// other, bit by bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "kernels/tet/tet_nodes.hpp"
#include "src/error.hpp"
#include "tests/src/step/two_scenes.hpp"

namespace percuss::test {
namespace {

// Two materials that share nodes, each averaged for itself, beside hexahedra; contact, pressure, held nodes.
const std::string joined_tets_text = R"yaml(
time: {end: 1}
parts:
  low: {box: {size: [0.04, 0.04, 0.01], cells: [6, 5, 2]}, elements: tetrahedra, material: copper}
  lid: {box: {size: [0.04, 0.04, 0.004], cells: [6, 5, 1]}, elements: tetrahedra, at: [0, 0, 0.01], material: steel}
  ball: {sphere: {radius: 0.008, cells: 6}, elements: tetrahedra, at: [0.021, 0.019, 0.0222], material: rubber}
  block: {box: {size: [0.01, 0.01, 0.01], cells: [4, 4, 4]}, at: [0.0005, 0.028, 0.0141], material: steel}
join: [{parts: [low, lid]}]
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  rubber: {model: neo_hookean, density: 1100, youngs_modulus: 2e8, poissons_ratio: 0.49}
loads: {pressure: [{faces: low/x_max, value: 1e8}]}
initial: [{part: ball, velocity: [20, 10, -400]}, {part: block, velocity: [0, 0, -60]}]
conditions: [{nodes: low/z_min, fixed: [x, y, z]}]
contact: {surfaces: all, friction: 0.2}
)yaml";

TEST(TetsOnRanks, OfTwoMaterialsBesideHexahedraHaveTheBitsOfOneRank) {
  TwoScenes scenes(joined_tets_text);
  expect_same_run(scenes, 60);
  EXPECT_GT(scenes.alone.stepper.contact_report().interactions, 0);
}

TEST(TetsOnRanks, OfThePlainFormHaveTheBitsOfOneRank) {
  TwoScenes scenes(joined_tets_text + "elements: {tetrahedra: plain}\n");
  expect_same_run(scenes, 60);
}

TEST(TetsOnRanks, AreAveragedForEachMaterialOfANode) {
  const Scene scene(joined_tets_text, Communicator(MPI_COMM_SELF));
  // Nodes of the common face have a record for copper and one for steel: 7 x 6 of them.
  std::vector<int> nodes(static_cast<std::size_t>(scene.model.node_count), 0);
  const auto first = to_host(scene.model.tet_nodes->first), slots = to_host(scene.model.tet_nodes->slots),
             slots_to_nodes = to_host(scene.model.chunks.slots_to_nodes);
  for (int r = 0; r < scene.model.tet_nodes->count; ++r)
    ++nodes[static_cast<std::size_t>(
        slots_to_nodes(static_cast<std::size_t>(slots(static_cast<std::size_t>(first(r))))))];
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), 2), 42);
}

TEST(TetsOnRanks, AreRefusedWhereTheirBoundIsNotKnown) {
  const auto build = [](const std::string& time) {
    const Scene scene("time: {end: 1, " + time + "}\n" + R"(
parts: {box: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, elements: tetrahedra, material: steel}}
)" + steel_text);
  };
  EXPECT_THAT([&] { build("step_estimate: global"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("part 'box' has tetrahedra")));
}

TEST(TetsOnRanks, GetMassWhereTheDeckScalesIt) {
  for (const char* form : {"mixed", "plain"}) {
    TwoScenes scenes(std::string("time: {end: 1, mass_scaling: {step: 1e-5, max_added: 99, every: 1}}\n") + R"yaml(
parts: {box: {box: {size: [1, 1, 0.4], cells: [6, 5, 4]}, elements: tetrahedra, material: rubber}}
materials: {rubber: {model: neo_hookean, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{velocity: [0, 0, -20]}]
walls: [{normal: z}]
elements: {tetrahedra: )yaml" +
                     form + "}\n");
    EXPECT_GT(scenes.alone.model.total_mass, 1.1 * 7850 * 0.4) << form;
    expect_same_run(scenes, 20);
    // Elements that shrink get all that they lack at once, of shared mass too; the step still keeps to what was before.
    EXPECT_GT(scenes.alone.state.bound.step, 0.99e-5) << form;
  }
}

}  // namespace
}  // namespace percuss::test
