// What is refused of rigid bodies when the model is built, with the place of the deck, on every rank.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

const std::string parts = R"yaml(
time: {end: 1}
parts:
  left: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, material: m, rigid: true}
  middle: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, at: [3, 0, 0], material: m}
  right: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, at: [6, 0, 0], material: m, rigid: {fixed: [x]}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
)yaml";

/// Error of building the scene with more keys, on every rank.
std::string take_rigid_error(const std::string& more, const std::string& text = parts) {
  try {
    const Scene scene(text + more + "\n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RigidConditions, MustNameAllNodesOfABody) {
  EXPECT_THAT(take_rigid_error("conditions: [{nodes: left/x_min, fixed: [x]}]"),
              HasSubstr("deck.yaml:8:22: error: the condition names 16 of the 64 nodes of rigid body 'left'"));
  EXPECT_EQ(take_rigid_error("conditions: [{nodes: left, fixed: [x]}, {nodes: left/x_min, symmetry: y}]"), "");
  EXPECT_THAT(take_rigid_error("join: true\nconditions: [{nodes: middle, velocity: {y: 1}}]"),
              HasSubstr("deck.yaml:9:22: error: the condition names 16 of the 64 nodes of rigid body 'left'"));
}

TEST(RigidConditions, MoveABodyOnceInADirection) {
  EXPECT_THAT(take_rigid_error("conditions: [{nodes: right, velocity: {x: 1}}]"),
              HasSubstr("deck.yaml:8:22: error: rigid body 'right' has two conditions on direction x"));
  EXPECT_EQ(take_rigid_error("conditions: [{nodes: right, fixed: [x]}]"), "");
}

// As files and results do: the first node of a part is 1, not 0.
TEST(RigidBodies, HaveNodesThatAreNamedByTheirIds) {
  EXPECT_THAT(take_rigid_error("constraints: {c: {equal: [x], nodes: left/x_min}}"),
              HasSubstr("deck.yaml:8:15: error: constraint 'c' names node 1, which belongs to a rigid body"));
  EXPECT_THAT(take_rigid_error("springs: {s: {between: [{id: 64}, left], stiffness: 1}}"),
              HasSubstr("deck.yaml:8:11: error: both ends of spring 's' are node 64 (a spring connects two"));
}

TEST(RigidBodies, ThatShareANodeMustBeOne) {
  const std::string touching = R"yaml(
time: {end: 1}
parts:
  left: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, material: m, rigid: true}
  right: {box: {size: [3, 3, 3], cells: [3, 3, 3]}, at: [3, 0, 0], material: m, rigid: true}
join: true
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
)yaml";
  EXPECT_THAT(take_rigid_error("", touching), HasSubstr("deck.yaml:4:72: error: node 4 belongs to two rigid bodies"));
  std::string one = touching;
  for (std::size_t at; (at = one.find("rigid: true")) != std::string::npos;) one.replace(at, 11, "rigid: {body: b}");
  EXPECT_EQ(take_rigid_error("", one), "");
}

// Sets: node 1 of the mesh is of the rigid part `left`; one node of `middle` alone has no inertia, two have.
TEST(RigidSets, HaveNodesOfOneBodyAndInertia) {
  EXPECT_THAT(take_rigid_error("rigid_sets: {s: {nodes: all}}"),
              HasSubstr("deck.yaml:8:14: error: node 1 belongs to two rigid bodies"));
  const std::string one = "rigid_sets: {s: {nodes: {name: middle, inside: [[3, 0, 0], [3, 0, ";
  EXPECT_THAT(take_rigid_error(one + "0]]}}}"),
              HasSubstr("deck.yaml:8:14: error: rigid body 's' has no inertia (its nodes are at one place)"));
  EXPECT_EQ(take_rigid_error(one + "1]]}}}"), "");
  EXPECT_EQ(take_rigid_error("rigid_sets: {s: {nodes: middle/x_min, body: left}}"), "");
  EXPECT_THAT(
      take_rigid_error("rigid_sets: {s: {nodes: middle/x_min, body: left}}\nconditions: [{nodes: left, fixed: [x]}]"),
      HasSubstr("deck.yaml:9:22: error: the condition names 64 of the 80 nodes of rigid body 'left'"));
}

TEST(RigidBodies, MustBeginToMoveAsOne) {
  EXPECT_THAT(
      take_rigid_error("initial: [{part: {name: left, inside: [[-1, -1, -1], [1, 4, 4]]}, velocity: [1, 0, 0]}]"),
      HasSubstr("deck.yaml:4:72: error: the initial velocities of rigid body 'left' are not a rigid motion"));
  EXPECT_EQ(take_rigid_error("join: true\ninitial: [{part: middle, velocity: [1, 0, 0]}]"), "");  // shared nodes follow
  EXPECT_EQ(take_rigid_error("initial: [{part: all, velocity: [1, 0, 0], angular_velocity: [1, 2, 3]}]"), "");
}

TEST(RigidBodies, DoNotTakeMassDuringTheRun) {
  std::string scaled = parts;
  scaled.replace(scaled.find("end: 1"), 6, "end: 1, mass_scaling: {step: 0.1, every: 1}");
  EXPECT_THAT(take_rigid_error("join: true", scaled),
              HasSubstr("deck.yaml:4:72: error: rigid body 'left' shares 16 nodes"));
  EXPECT_EQ(take_rigid_error("", scaled), "");
}

}  // namespace
}  // namespace percuss::test
