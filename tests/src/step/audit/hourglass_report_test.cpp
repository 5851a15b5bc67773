// Parts that hold their energy in hourglass modes, named with the element that does it, on any number of ranks.

#include "src/step/audit/hourglass_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/step/audit/hourglass_pattern.hpp"
#include "src/step/audit/part_energies.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A block whose corner is torn away alone, and a bar that is stretched evenly.
const std::string corner_and_bar = R"(
time: {end: 1000}
parts:
  block: {box: {size: [6, 6, 6], cells: [6, 6, 6]}, material: m}
  bar: {box: {size: [8, 2, 2], cells: [8, 2, 2]}, at: [20, 0, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0}}
initial: [{nodes: {name: block, inside: [[5.9, 5.9, 5.9], [6.1, 6.1, 6.1]]}, velocity: [0.1, 0.1, 0.1]}]
conditions: [{nodes: bar/x_min, fixed: x}, {nodes: bar/x_max, velocity: {x: 0.1}}]
contact: {surfaces: none}
)";

std::vector<PartHourglass> find_parts(const Scene& scene, double share, double least, double least_of_all = 0) {
  return find_hourglassed_parts(scene.deck, scene.chunked, scene.model, scene.state,
                                {share, least, 2 * share, least_of_all});
}

TEST(HourglassedParts, AreNamedWithTheElementWhereMostOfItIs) {
  Scene scene(corner_and_bar);
  scene.run(6);
  const std::vector<PartHourglass> parts = find_parts(scene, 0.1, 0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, "block");
  EXPECT_GT(parts[0].hourglass, 0.1 * parts[0].stored);
  // The element at the corner is the last of the block, with its centre near (5.5, 5.5, 5.5).
  EXPECT_THAT(parts[0].element, HasSubstr("element 216 of part 'block' at (5.5"));
  const std::vector<PartEnergy> energies = sum_part_energies(scene.chunked, scene.model, scene.state);
  ASSERT_EQ(energies.size(), 2U);
  EXPECT_LE(parts[0].hourglass, energies[0].hourglass);
  EXPECT_LT(energies[1].hourglass, 1e-2 * energies[1].internal);  // bulk viscosity pushes the sides out unevenly
}

TEST(HourglassedParts, AreNoneOfEnergiesThatMeanNothing) {
  Scene scene(corner_and_bar);
  scene.run(6);
  EXPECT_THAT(find_parts(scene, 0.1, 1), IsEmpty());
  EXPECT_THAT(find_parts(scene, 100, 0), IsEmpty());
  const double hourglass = find_parts(scene, 0.1, 0).at(0).hourglass;
  EXPECT_THAT(find_parts(scene, 0.1, 0, 1.01 * hourglass), IsEmpty());
  EXPECT_EQ(find_parts(scene, 0.1, 0, 0.99 * hourglass).size(), 1U);
}

TEST(HourglassedParts, AreTheSameOnAnyNumberOfRanks) {
  Scene scene(corner_and_bar), alone(corner_and_bar, Communicator(MPI_COMM_SELF));
  scene.run(6);
  alone.run(6);
  const auto parts = find_parts(scene, 0.1, 0);
  const auto same = find_parts(alone, 0.1, 0);
  ASSERT_EQ(parts.size(), same.size());
  EXPECT_EQ(parts[0].element, same[0].element);
  EXPECT_EQ(parts[0].hourglass, same[0].hourglass);
}

/// A strip one element thick that swings in its first mode: all of its bending is in hourglass modes.
std::string make_strip(const std::string& control, const std::string& layers = "20, 2, 1",
                       const std::string& elements = "hexahedra") {
  return R"(
time: {end: 1000}
parts: {strip: {box: {size: [20, 2, 1], cells: [)" +
         layers + "]}, " + (elements == "hexahedra" ? "" : "elements: " + elements + ", ") + R"(material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
elements: {hourglass: )" +
         control + R"(}
conditions: [{nodes: strip/x_min, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -1e-4]}
contact: {surfaces: none}
)";
}

TEST(HourglassedParts, AreNotThoseThatBendByTheStiffnessOfTheirMaterial) {
  Scene scene(make_strip("assumed_strain"));
  scene.run(600);
  const PartEnergy energy = sum_part_energies(scene.chunked, scene.model, scene.state).at(0);
  EXPECT_GT(energy.hourglass, energy.internal);  // else the scene tests nothing
  EXPECT_THAT(find_parts(scene, 0.1, 0), IsEmpty());
  Scene soft(make_strip("stiffness"));  // resists bending by a coefficient
  soft.run(600);
  EXPECT_EQ(find_parts(soft, 0.1, 0).size(), 1U);
}

// n layers of one point take 1 - 1/n^2 of the moment of a section, and leave the rest to their control.
TEST(HourglassedParts, AreNotThoseOfThreeLayersThatBendByAnotherControl) {
  const auto count = [](const std::string& control, const std::string& cells, const std::string& elements) {
    Scene scene(make_strip(control, cells, elements));
    scene.run(1200);
    const PartEnergy energy = sum_part_energies(scene.chunked, scene.model, scene.state).at(0);
    EXPECT_GT(energy.hourglass, 0.02 * energy.internal) << control << elements;  // else the scene tests nothing
    return find_parts(scene, 0.1, 0).size();
  };
  EXPECT_EQ(count("stiffness", "40, 4, 3", "hexahedra"), 0U);
  EXPECT_EQ(count("assumed_strain", "40, 4, 3", "wedges"), 0U);
  EXPECT_EQ(count("stiffness", "20, 2, 1", "hexahedra"), 1U);
  EXPECT_EQ(count("assumed_strain", "20, 2, 1", "wedges"), 1U);
}

/// Moves the nodes of a block by a field, and finds the share of its hourglass motion that alternates, chunk by chunk.
template <class Field>
std::vector<double> find_shares(const std::string& shape, const Field& field) {
  const Scene scene("time: {end: 1}\nparts: {a: {" + shape +
                        ", material: m}}\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, "
                        "poissons_ratio: 0}}\n",
                    Communicator(MPI_COMM_SELF));
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<double> all;
  for (const Chunk& chunk : scene.chunked.chunks) {
    std::vector<HourglassDisplacement> motions;
    for (int e = chunk.first_element; e < chunk.first_element + chunk.element_count; ++e) {
      std::vector<Vec3> start, now;
      for (const int n : mesh.corners(static_cast<std::size_t>(e))) {
        start.push_back(mesh.nodes[static_cast<std::size_t>(n)]);
        now.push_back(field(start.back()));
      }
      motions.push_back(find_hourglass_displacement(mesh.topology_of(static_cast<std::size_t>(e)), start, now));
    }
    const std::vector<double> shares = find_alternating_shares(mesh, chunk.first_element, motions);
    for (std::size_t e = 0; e < shares.size(); ++e)
      if (motions[e].square > 1e-20) all.push_back(shares[e]);
  }
  return all;
}

const std::string brick = "box: {size: [4, 3, 2], cells: [4, 3, 2]}",
                  sheet = "shell_plate: {size: [4, 3], cells: [4, 3]}, thickness: 0.1";

TEST(HourglassPattern, OfBendingAndTwistDoesNotAlternate) {
  const auto bend = [](const Vec3& x) { return Vec3{x[0] + 0.01 * x[0] * x[2], x[1], x[2] - 0.005 * x[0] * x[0]}; };
  const auto twist = [](const Vec3& x) { return Vec3{x[0], x[1] - 0.01 * x[0] * x[2], x[2] + 0.01 * x[0] * x[1]}; };
  for (const auto& shares : {find_shares(brick, bend), find_shares(brick, twist), find_shares(sheet, twist)}) {
    ASSERT_FALSE(shares.empty());
    for (const double share : shares) EXPECT_NEAR(share, 0, 1e-9);
  }
}

TEST(HourglassPattern, OfNodesThatMoveTurnAboutAlternates) {
  const auto keystone = [](const Vec3& x) {
    const double sign = (std::lround(x[0]) + std::lround(x[2])) % 2 == 0 ? 1 : -1;
    return Vec3{x[0] + 0.01 * sign, x[1], x[2]};
  };
  const auto buckle = [](const Vec3& x) {
    return Vec3{x[0], x[1], x[2] + ((std::lround(x[0]) + std::lround(x[1])) % 2 == 0 ? 0.01 : -0.01)};
  };
  for (const auto& shares : {find_shares(brick, keystone), find_shares(sheet, buckle)}) {
    ASSERT_FALSE(shares.empty());
    for (const double share : shares) EXPECT_NEAR(share, 1, 1e-9);
  }
}

TEST(HourglassPattern, IsNoneOfALinearMotionOfElementsOfAnyShape) {
  const auto turn = [](const Vec3& x) { return Vec3{-1.2 * x[1] + 0.3 * x[2], x[0], x[2] + 5}; };
  EXPECT_TRUE(find_shares("sphere: {radius: 2, cells: 6}", turn).empty());
  EXPECT_TRUE(find_shares("tube: {inner_radius: 1, outer_radius: 2, length: 1, cells: [2, 12, 2]}", turn).empty());
}

}  // namespace
}  // namespace percuss::test
