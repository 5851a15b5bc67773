// What the rules know of a mesh is the same on any number of ranks, and right.

#include "src/checks/scene_measures.hpp"

#include <gtest/gtest.h>

#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/model/model.hpp"

namespace percuss {
namespace {

constexpr const char* text = R"(
time: {end: 1}
parts:
  plate: {box: {size: [2, 3, 0.1], cells: [20, 30, 1]}, material: m}
  bar:   {box: {size: [8, 0.1, 0.1], cells: [80, 1, 1]}, at: [0, 5, 0], material: m}
  sheet: {shell_plate: {size: [2, 2], cells: [16, 16]}, at: [0, 0, 1], thickness: 0.01, material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
initial:
  - {velocity: [0, 0, 1]}
  - {part: sheet, velocity: [3, 4, 0]}
  - {nodes: bar/x_min, velocity: [0, 0, 2]}
conditions:
  - {nodes: bar, fixed: [x]}
  - {nodes: plate, fixed: [z]}
  - {nodes: plate/x_min, fixed: [x, z]}
loads:
  nodal:
    - {nodes: plate, force: {x: 1}}
    - {nodes: plate, force: {x: 1, z: 1}}
    - {nodes: sheet/x_min, force: {x: 1}, moment: {y: 1}}
    - {nodes: bar, force: {x: 2}}
)";

constexpr const char* sheets = R"(
time: {end: 1}
parts:
  wedges:   {box: {size: [1, 1, 0.1], cells: [4, 4, 1]}, elements: wedges, material: m}
  pipe:     {tube: {inner_radius: 0.45, outer_radius: 0.5, length: 1, cells: [1, 16, 8]}, at: [9, 0, 0], elements: wedges, material: m}
  cut:      {box: {size: [1, 1, 0.1], cells: [4, 4, 1]}, at: [3, 0, 0], elements: tetrahedra, material: m}
  pyramids: {box: {size: [1, 1, 0.1], cells: [4, 4, 1]}, at: [6, 0, 0], elements: pyramids, material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)";

SceneMeasures measure(const Communicator& ranks, const char* scene = text) {
  const Deck deck = parse_deck(scene, "deck.yaml");
  const ChunkedMesh chunked = load_mesh(deck, ranks);
  return measure_scene(deck, chunked, build_model(deck, chunked).start_velocity);
}

TEST(SceneMeasures, AreThoseOfOneRankOnAnyNumber) {
  const SceneMeasures together = measure(Communicator::world()), alone = measure(Communicator(MPI_COMM_SELF));
  ASSERT_EQ(together.parts.size(), alone.parts.size());
  for (std::size_t p = 0; p < alone.parts.size(); ++p) EXPECT_EQ(together.parts[p], alone.parts[p]) << p;
  EXPECT_EQ(together.initial, alone.initial);
  EXPECT_EQ(together.selections, alone.selections);
  EXPECT_EQ(together.low, alone.low);
  EXPECT_EQ(together.high, alone.high);
}

TEST(SceneMeasures, CountTheNodesThatCannotFollowALoad) {
  const SelectionMeasures found = measure(Communicator::world()).selections;
  const std::int64_t plate = 21 * 31 * 2, side = 31 * 2, bar = 81 * 2 * 2;
  const std::vector<LoadMeasures> expected = {
      {plate, side, false}, {plate, side, false}, {17, 0, true}, {bar, bar, false}};
  EXPECT_EQ(found.loads, expected);
  ASSERT_EQ(found.conditions.size(), 3U);
  EXPECT_EQ(found.conditions[2].low, (Vec3{0, 0, 0}));
  EXPECT_EQ(found.conditions[2].high, (Vec3{0, 3, 0.1}));
}

TEST(SceneMeasures, SayHowHeavyPartsAre) {
  const std::vector<PartMeasures> parts = measure(Communicator::world()).parts;
  EXPECT_NEAR(parts[0].mass, 2 * 3 * 0.1, 1e-12);
  EXPECT_NEAR(parts[2].mass, 2 * 2 * 0.01, 1e-12);
}

TEST(SceneMeasures, SayHowLargeAndHowThickPartsAre) {
  const std::vector<PartMeasures> parts = measure(Communicator::world()).parts;
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].solids, 600);
  EXPECT_EQ(parts[0].single_layer, 600);
  EXPECT_NEAR(parts[0].layer_thickness, 0.1, 1e-15);
  EXPECT_NEAR(parts[0].extent(), 3, 1e-15);
  EXPECT_NEAR(parts[0].shortest_edge, 0.1, 1e-14);
  EXPECT_NEAR(parts[0].longest_edge, 0.1, 1e-14);
  EXPECT_EQ(parts[0].nodes, 21 * 31 * 2);
  EXPECT_NEAR(static_cast<double>(parts[0].moments[0]) / (1.0 * (1 << 30) * static_cast<double>(parts[0].nodes)),
              1.0 / 8, 1e-8);           // of 8
  EXPECT_EQ(parts[1].single_layer, 0);  // a bar, not a sheet
  EXPECT_EQ(parts[2].shells, 256);
  EXPECT_EQ(parts[2].speed, 5);
}

TEST(SceneMeasures, FindLayersOfWedgesAndTheOpenFacesOfWhatIsCut) {
  const std::vector<PartMeasures> parts = measure(Communicator::world(), sheets).parts;
  const std::vector<PartMeasures> alone = measure(Communicator(MPI_COMM_SELF), sheets).parts;
  ASSERT_EQ(parts.size(), 4U);
  for (std::size_t p = 0; p < parts.size(); ++p) EXPECT_EQ(parts[p], alone[p]) << p;
  EXPECT_EQ(parts[0].layered_wedges, 2 * 16);
  EXPECT_NEAR(parts[0].layer_thickness, 0.1, 1e-14);
  EXPECT_EQ(parts[1].layered_wedges, 2 * 16 * 8);  // cut from the inner side to the outer
  EXPECT_NEAR(parts[1].layer_thickness, 0.05, 1e-14);
  EXPECT_EQ(parts[2].cut_solids, 12 * 16);
  EXPECT_EQ(parts[2].cut_faces, 2 * (2 * 16 + 4 * 4));  // both sides and the rim
  EXPECT_EQ(parts[3].cut_solids, 6 * 16);
  EXPECT_EQ(parts[3].cut_faces, 2 * 16 + 4 * 4);
  for (const std::size_t p : {std::size_t{2}, std::size_t{3}}) {
    EXPECT_NEAR(parts[p].cut_volume, 0.1, 1e-14);
    EXPECT_NEAR(parts[p].cut_area, 2 + 4 * 0.1, 1e-14);
  }
}

TEST(SceneMeasures, CountNodesThatMoveAndThatAreStopped) {
  const std::vector<InitialMeasures> initial = measure(Communicator::world()).initial;
  ASSERT_EQ(initial.size(), 3U);
  EXPECT_EQ(initial[0].selected, 21 * 31 * 2 + 81 * 4 + 17 * 17);
  EXPECT_EQ(initial[0].governed, 21 * 31 * 2 + 80 * 4);
  EXPECT_EQ(initial[0].stopped, 21 * 31 * 2);
  EXPECT_EQ(initial[0].condition, 1);
  EXPECT_EQ(initial[1].stopped, 0);
  EXPECT_EQ(initial[2].governed, 4);
  EXPECT_EQ(initial[2].condition, InitialMeasures::no_condition);
}

}  // namespace
}  // namespace percuss
