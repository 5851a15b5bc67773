// Nodes far from rigid walls are not looked at: the same bits as with a look at all, whatever moves nodes and walls.

#include <gtest/gtest.h>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

const std::string steel = R"yaml(
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, hardening_modulus: 1e9}}
)yaml";

const std::string block = R"yaml(
time: {end: 1}
parts: {block: {box: {size: [0.06, 0.02, 0.06], cells: [12, 4, 12]}, at: [0, 0, 1e-3], material: steel}}
)yaml" + steel;

struct Sums {
  int interactions = 0;
  double left_out = 0;  // share
};

/// Both runs side by side.
Sums expect_same_bits(const std::string& deck, const std::string& contact, int steps) {
  const auto with = [&](const char* reuse) {
    return deck + "contact: {" + contact + (contact.empty() ? "" : ", ") + "reuse_search: " + reuse + "}\n";
  };
  Scene some(with("true")), all(with("false"));
  Sums sums;
  for (Scene* scene : {&some, &all}) {
    scene->contact.prepare(scene->state.x, scene->state.v);
    scene->stepper.start(scene->state);
  }
  for (int i = 0; i < steps; ++i) {
    some.stepper.advance(some.state);
    all.stepper.advance(all.state);
    EXPECT_EQ(some.stepper.contact_report().interactions, all.stepper.contact_report().interactions) << "step " << i;
    sums.interactions += some.stepper.contact_report().interactions;
  }
  EXPECT_EQ(hash_state(some.model, some.state), hash_state(all.model, all.state));
  const WallCounts counts = some.contact.wall_counts(), every = all.contact.wall_counts();
  EXPECT_EQ(every.looked_at, every.pairs);
  sums.left_out = 1 - static_cast<double>(counts.looked_at) / static_cast<double>(counts.pairs);
  return sums;
}

}  // namespace

TEST(WallSleep, ABlockFallsOnAFloor) {
  for (const char* contact : {"", "surfaces: all"}) {
    const Sums sums = expect_same_bits(
        block + "initial: [{velocity: [3, 0, -20]}]\nwalls: [{normal: z, friction: 0.2}]\n", contact, 150);
    EXPECT_GT(sums.interactions, 1000);
    EXPECT_GT(sums.left_out, 0.5);
  }
}

TEST(WallSleep, WallsThatMoveAndThatGiveWay) {
  const Sums sums = expect_same_bits(block + R"yaml(
initial: [{velocity: [0, 0, -5]}]
walls:
  - {normal: z, speed: {expression: "15 * sin(2e4 * t)"}}
  - {normal: -z, point: [0, 0, 0.0615], mass: 0.05, start_speed: 40, friction: 0.1}
  - {normal: x, point: [-2e-4, 0.001, 0], rectangle: {along: y, size: [0.03, 0.03]}, speed: {table: [[0, 5], [1e-4, 30]]}}
  - {cylinder: {axis: y, radius: 0.03}, point: [0.095, 0, 0.03], direction: -x, speed: 60, friction: 0.2}
  - {sphere: {radius: 0.02}, point: [0.03, 0.045, 0.03], direction: -y, speed: 80}
)yaml",
                                     "", 150);
  EXPECT_GT(sums.interactions, 1000);
  EXPECT_GT(sums.left_out, 0.3);
}

TEST(WallSleep, ConditionsAndDampingMoveNodes) {
  const std::string walls = "walls: [{normal: z, point: [0, 0, 1e-3]}]\n";
  for (const char* more :
       {"conditions: [{nodes: block/z_max, velocity: {z: {table: [[0, 0], [2e-5, -40], [1, -40]]}}}]\n",
        "conditions: [{nodes: block/z_max, displacement: {z: {expression: \"-3e-4 * sin(6e4 * t)\"}}}]\n",
        "initial: [{velocity: [0, 0, -20]}]\ndamping: [{coefficient: 1e4}]\n"}) {
    SCOPED_TRACE(more);
    const Sums sums = expect_same_bits(block + more + walls, "", 150);
    EXPECT_GT(sums.interactions, 100);
    EXPECT_GT(sums.left_out, 0.2);
  }
}

TEST(WallSleep, ARigidBodySpins) {
  const Sums sums = expect_same_bits(R"yaml(
time: {end: 1, max_step: 1e-6}
parts:
  body: {box: {size: [0.06, 0.02, 0.02], cells: [12, 4, 4]}, at: [0, 0, 0.03], material: steel, rigid: true}
  block: {box: {size: [0.06, 0.02, 0.02], cells: [12, 4, 4]}, at: [0, 0.03, 1e-4], material: steel}
initial: [{part: body, velocity: [0, 0, -40], angular_velocity: [0, 2000, 0]}, {part: block, velocity: [0, 0, -10]}]
walls: [{normal: z}]
)yaml" + steel,
                                     "", 600);
  EXPECT_GT(sums.interactions, 100);
  EXPECT_GT(sums.left_out, 0.2);
}

TEST(WallSleep, WallsThatSeeTheThicknessOfShells) {
  const Sums sums = expect_same_bits(R"yaml(
time: {end: 1}
parts: {plate: {shell_plate: {size: [0.1, 0.1], cells: [10, 10]}, thickness: 4e-3, material: steel, at: [0, 0, 2.05e-3]}}
initial: [{velocity: [0, 0, -20]}]
walls: [{normal: z, thickness: included}, {sphere: {radius: 0.05}, point: [0.02, 0.03, 0.0545], thickness: included}]
)yaml" + steel,
                                     "", 100);
  EXPECT_GT(sums.interactions, 100);
}

}  // namespace percuss::test
