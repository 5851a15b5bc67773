// Parts that hold their energy in hourglass modes, named with the element that does it, on any number of ranks.

#include "src/step/audit/hourglass_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(HourglassedParts, AreNamedWithTheElementWhereMostOfItIs) {
  Scene scene(corner_and_bar);
  scene.run(6);
  const std::vector<PartHourglass> parts = find_hourglassed_parts(scene.chunked, scene.model, scene.state, 0.1, 0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, "block");
  EXPECT_GT(parts[0].hourglass, 0.1 * parts[0].internal);
  // The element at the corner is the last of the block, with its centre near (5.5, 5.5, 5.5).
  EXPECT_THAT(parts[0].element, HasSubstr("element 216 of part 'block' at (5.5"));
  const std::vector<PartEnergy> energies = sum_part_energies(scene.chunked, scene.model, scene.state);
  ASSERT_EQ(energies.size(), 2U);
  EXPECT_EQ(energies[0].hourglass, parts[0].hourglass);
  EXPECT_LT(energies[1].hourglass, 1e-2 * energies[1].internal);  // bulk viscosity pushes the sides out unevenly
}

TEST(HourglassedParts, AreNoneOfEnergiesThatMeanNothing) {
  Scene scene(corner_and_bar);
  scene.run(6);
  EXPECT_THAT(find_hourglassed_parts(scene.chunked, scene.model, scene.state, 0.1, 1), IsEmpty());
  EXPECT_THAT(find_hourglassed_parts(scene.chunked, scene.model, scene.state, 100, 0), IsEmpty());
}

TEST(HourglassedParts, AreTheSameOnAnyNumberOfRanks) {
  Scene scene(corner_and_bar), alone(corner_and_bar, Communicator(MPI_COMM_SELF));
  scene.run(6);
  alone.run(6);
  const auto parts = find_hourglassed_parts(scene.chunked, scene.model, scene.state, 0.1, 0);
  const auto same = find_hourglassed_parts(alone.chunked, alone.model, alone.state, 0.1, 0);
  ASSERT_EQ(parts.size(), same.size());
  EXPECT_EQ(parts[0].element, same[0].element);
  EXPECT_EQ(parts[0].hourglass, same[0].hourglass);
}

}  // namespace
}  // namespace percuss::test
