// Elements whose corners are inside out, counted over ranks.

#include "src/step/inverted_corners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

/// Unit cubes, nine by three by three of them, and one more; a plate of shells, which has no such corners.
const std::string text = R"yaml(
time: {end: 1}
parts:
  block: {box: {size: [9, 3, 3], cells: [9, 3, 3]}, material: m}
  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [20, 0, 0], material: m}
  plate: {shell_plate: {size: [2, 2], cells: [2, 2]}, thickness: 0.1, at: [0, 0, 9], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
)yaml";

struct MovedNodes {
  MovedNodes() : scene(text) {}

  /// Moves the node that starts at `from`, on every rank that has it.
  void move(const Vec3& from, const Vec3& to) {
    const auto x = to_host(scene.state.x);
    for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
      if (scene.chunked.mesh.nodes[n] != from) continue;
      for (std::size_t k = 0; k < 3; ++k) x(n, k) = to[k];
    }
    Kokkos::deep_copy(scene.state.x, x);
  }
  std::vector<std::int64_t> count() const { return count_inverted_corners(scene.chunked, scene.model, scene.state); }

  Scene scene;
};

TEST(TurnedCorners, AreNoneWhereCubesAreSheared) {
  MovedNodes nodes;
  EXPECT_THAT(nodes.count(), ElementsAre(0, 0, 0));
  for (const double y : {0.0, 1.0}) nodes.move({21, y, 1}, {23, y, 1});
  for (const double y : {0.0, 1.0}) nodes.move({20, y, 1}, {22, y, 1});
  EXPECT_THAT(nodes.count(), ElementsAre(0, 0, 0));
}

TEST(TurnedCorners, AreSeenBehindTheDiagonalPlaneOfTheNeighbours) {
  // The edges at the corner that is pushed along the diagonal by d each are the rows of 1 - d J, J full of ones: the
  // determinant is 1 - 3 d, negative from a third on.
  MovedNodes nodes;
  nodes.move({21, 1, 1}, {20.67, 0.67, 0.67});
  EXPECT_THAT(nodes.count(), ElementsAre(0, 0, 0));
  nodes.move({21, 1, 1}, {20.66, 0.66, 0.66});
  EXPECT_THAT(nodes.count(), ElementsAre(0, 1, 0));
}

TEST(TurnedCorners, OfANodeThatPassesItsNeighbourAreThoseOfAllElementsBehindIt) {
  MovedNodes nodes;
  nodes.move({4, 1, 1}, {5.5, 1, 1});  // four elements in front of it
  EXPECT_THAT(nodes.count(), ElementsAre(4, 0, 0));
  nodes.move({1, 0, 0}, {1, 1.5, 0});  // at an edge of the block: two elements
  EXPECT_THAT(nodes.count(), ElementsAre(6, 0, 0));
}

TEST(TurnedCorners, OfDeadElementsDoNotCount) {
  MovedNodes nodes;
  nodes.move({21, 1, 1}, {20.2, 0.2, 0.2});
  ErodedMesh& eroded = nodes.scene.chunked.mesh.eroded;
  eroded.dead.assign(nodes.scene.chunked.mesh.elements.size(), 1);
  EXPECT_THAT(nodes.count(), ElementsAre(0, 0, 0));
}

TEST(TurnedCorners, AreToldByPartWithTheirNumber) {
  const std::vector<MeshPart> parts = {{"block"}, {"cube"}, {"plate"}};
  EXPECT_THAT(describe_inverted_corners({0, 0, 0}, parts, 0.25), IsEmpty());
  const std::vector<Warning> warnings = describe_inverted_corners({3, 1, 0}, parts, 0.5);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_THAT(format_warning(warnings[0]), StartsWith("part 'block': warning: 3 elements have an inverted corner ("));
  EXPECT_THAT(format_warning(warnings[1]), StartsWith("part 'cube': warning: 1 element has an inverted corner ("));
  EXPECT_EQ(warnings[0].time, 0.5);
}

}  // namespace
}  // namespace percuss::test
