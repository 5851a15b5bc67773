// What is skipped changes no bit: chunks of elements that rest, nodes far from walls.

#include <gtest/gtest.h>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::skip_test {
namespace {

// 2048 elements in a row of chunks; the wave has gone through a quarter of them at the end.
const std::string bar = R"(
title: a wave runs into a bar at rest
time: {end: 1.0, max_steps: 120}
parts: {bar: {box: {size: [5.12, 0.04, 0.04], cells: [512, 2, 2]}, material: steel}}
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 100e6, hardening_modulus: 1e9}
conditions: [{nodes: bar/x_min, velocity: {x: 5}}]
output: {history: {every: 0, nodes: [{name: a, near: [0.1, 0.02, 0.02]}]}}
)";

void expect_same_without(const std::string& deck, const std::vector<std::string>& settings, double least) {
  std::vector<std::string> every = settings;
  every.emplace_back("elements.skip_resting=false");
  const Outcome all = run_deck(deck, every), some = run_deck(deck, settings);
  EXPECT_EQ(some.summary.state_hash, all.summary.state_hash);
  EXPECT_EQ(all.summary.skipped.chunk_updates, 0);
  EXPECT_GE(some.summary.skipped.chunk_updates, least);
  EXPECT_LT(some.summary.skipped.chunk_updates, 1);
  ASSERT_EQ(some.history.rows(), all.history.rows());
  for (const char* column : {"kinetic", "internal", "hourglass", "viscous", "energy_error", "a_vx"})
    EXPECT_EQ(some.history[column], all.history[column]) << column;
}

}  // namespace

TEST(Skip, ChunksAheadOfAWaveAreLeftAlone) {
  for (const char* choice : {"elements.hourglass=assumed_strain", "elements.hourglass=stiffness",
                             "elements.hourglass=viscous", "elements.integration=full"}) {
    SCOPED_TRACE(choice);
    expect_same_without(bar, {choice}, 0.7);
  }
}

// With `mixed`, what a neighbour's motion averages at the nodes of a chunk wakes it too.
TEST(Skip, ChunksOfOtherSolidsRestTheSame) {
  for (const char* kind : {"tetrahedra", "wedges", "pyramids"}) {
    for (const char* form : {"mixed", "plain"}) {
      SCOPED_TRACE(std::string(kind) + ", " + form);
      expect_same_without(bar,
                          {std::string("parts.bar.elements=") + kind, std::string("elements.tetrahedra=") + form,
                           "parts.bar.box.cells=[128, 2, 2]", "time.max_steps=24"},
                          0.5);
    }
  }
}

// Elements of two kinds die, and beside them some wait for the first wave.
TEST(Skip, SolidsThatFailRestTheSame) {
  const std::string deck = R"(
title: a block falls on blocks at rest
time: {end: 1.0, max_steps: 80}
parts:
  top: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, at: [0.001, 0.002, 0.0602], material: steel, elements: tetrahedra}
  low: {box: {size: [0.02, 0.02, 0.06], cells: [4, 4, 12]}, material: soft, elements: wedges}
  beside: {box: {size: [0.02, 0.02, 0.06], cells: [4, 4, 12]}, at: [0.0205, 0, 0], material: soft, elements: pyramids}
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  soft: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 100e6, hardening_modulus: 1e9, failure: {plastic_strain: 0.05}}
initial: [{part: top, velocity: [60, 0, -400]}]
contact: {surfaces: all}
conditions: [{nodes: low/z_min, velocity: {z: 0}}, {nodes: beside/z_min, velocity: {x: 0, y: 0, z: 0}}]
)";
  for (const char* form : {"mixed", "plain"}) {
    SCOPED_TRACE(form);
    const std::string choice = std::string("elements.tetrahedra=") + form;
    const Outcome some = run_deck(deck, {choice}), all = run_deck(deck, {choice, "elements.skip_resting=false"});
    EXPECT_GT(some.summary.eroded.elements, 0);
    EXPECT_GT(some.summary.skipped.chunk_updates, 0.01);
    EXPECT_EQ(some.summary.state_hash, all.summary.state_hash);
  }
}

TEST(Skip, AnElasticBarWakesAndRestsAgain) {
  // Pushed for a moment, held later: what has rung out to nothing may rest again, what has not must continue.
  expect_same_without(
      bar,
      {"materials.steel={model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}",
       "conditions.0.velocity={x: {table: [[0, 0], [1e-5, 1], [2e-5, 0], [1, 0]]}}", "time.max_steps=400"},
      0.2);
}

TEST(Skip, NothingRestsUnderGravity) {
  const Outcome run = run_deck(bar, {"loads={gravity: [0, 0, -9.81]}"});
  EXPECT_EQ(run.summary.skipped.chunk_updates, 0);
}

// Bricks that a ball pushes apart, a soft block crushed in a corner of stiff ones: faces beside those that hold a node
// are not looked at, while all of it moves, turns, slides and comes apart. Scenes with shells look at all faces: in the
// stack of sheets only what lies still is left out.
TEST(Skip, FacesBesideThoseThatHoldANodeAreNotLookedAt) {
  const std::string materials = R"(
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, hardening_modulus: 1e9}
  soft: {model: neo_hookean, density: 1000, youngs_modulus: 3e7, poissons_ratio: 0.3}
)";
  const std::string bricks = R"(
time: {end: 1.0, max_steps: 250}
parts:
  bricks: {box: {size: [0.06, 0.03, 0.02], cells: [4, 3, 2]}, array: {count: [1, 3, 4], pitch: [0.06, 0.03, 0.02], stagger: 0.5}, material: steel}
  ball: {sphere: {radius: 0.02, cells: 4}, at: [-0.0205, 0.05, 0.045], material: steel}
initial: [{part: ball, velocity: [150, 10, -20]}]
)";
  const std::string sheets = R"(
time: {end: 1.0, max_steps: 250}
parts:
  sheets: {shell_plate: {size: [0.06, 0.04], cells: [6, 4]}, array: {count: [1, 1, 6], pitch: [0.06, 0.04, 0.002]}, at: [0, 0, 0.001], thickness: 0.002, material: steel}
  block: {box: {size: [0.03, 0.02, 0.02], cells: [3, 2, 2]}, rotate: [{axis: y, angle: 7}], at: [0.013, 0.011, 0.0155], material: steel}
initial: [{part: block, velocity: [5, 0, -30]}]
walls: [{normal: z, friction: 0.2}]
)";
  const std::string corner = R"(
time: {end: 1.0, max_steps: 700}
parts:
  soft: {box: {size: [0.03, 0.03, 0.03], cells: [4, 4, 4]}, material: soft}
  low: {box: {size: [0.06, 0.06, 0.01], cells: [6, 6, 1]}, at: [0, 0, -0.01], material: steel}
  left: {box: {size: [0.01, 0.06, 0.05], cells: [1, 6, 5]}, at: [-0.01, 0, 0], material: steel}
  front: {box: {size: [0.06, 0.01, 0.05], cells: [6, 1, 5]}, at: [0, -0.01, 0], material: steel}
  ram: {box: {size: [0.06, 0.06, 0.01], cells: [4, 4, 1]}, rotate: [{axis: [1, -1, 0], angle: 10}], at: [0.005, -0.005, 0.0345], material: steel}
conditions:
  - {nodes: low, fixed: [x, y, z]}
  - {nodes: left, fixed: [x, y, z]}
  - {nodes: front, fixed: [x, y, z]}
  - {nodes: ram, velocity: {x: -10, y: -10, z: -30}}
)";
  const auto run = [&](const std::string& deck, const std::string& reuse) {
    return run_deck("title: faces beside\n" + deck + materials + "contact: {surfaces: all, friction: 0.2}\n",
                    {"contact.reuse_search=" + reuse});
  };
  for (const std::string& deck : {bricks, sheets, corner}) {
    SCOPED_TRACE(deck);
    const Outcome some = run(deck, "true"), all = run(deck, "false");
    EXPECT_EQ(some.summary.state_hash, all.summary.state_hash);
    EXPECT_EQ(all.summary.skipped.pair_checks, 0);
    EXPECT_GT(some.summary.skipped.pair_checks, 0.1);
    EXPECT_LT(some.summary.energy.friction, 0);
  }
}

// Elements die, a sensor switches a condition on, and steps before time 0 bring the block to rest.
TEST(Skip, NodesFarFromWallsAreNotLookedAt) {
  const std::string deck = R"(
title: a block is pushed against a wall and erodes
time: {end: 1.0, max_steps: 300}
parts: {block: {box: {size: [0.02, 0.02, 0.06], cells: [4, 4, 12]}, at: [0, 0, 2e-4], material: steel}}
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, failure: {plastic_strain: 0.1}}
initial: [{velocity: [0, 0, -100]}]
conditions: [{nodes: block/z_max, velocity: {z: -300}, from: late}]
sensors: {late: {time: 1e-5}}
walls: [{name: floor, normal: z, friction: 0.1}]
output: {history: {every: 0, forces: [{name: push, wall: floor}]}}
)";
  const auto run = [&](std::vector<std::string> settings, const std::string& reuse) {
    settings.emplace_back("contact={surfaces: all, reuse_search: " + reuse + "}");
    return run_deck(deck, settings);
  };
  for (const std::string nodes : {"keep", "remove"}) {
    const std::string free = "erosion={free_nodes: " + nodes + "}";
    const Outcome some = run({free}, "true"), all = run({free}, "false");
    EXPECT_GT(some.summary.eroded.elements, 0);
    EXPECT_EQ(some.summary.state_hash, all.summary.state_hash);
    EXPECT_EQ(all.summary.skipped.wall_looks, 0);
    EXPECT_GT(some.summary.skipped.wall_looks, 0.2);
    EXPECT_EQ(some.history["fz:push"], all.history["fz:push"]);
  }
  const std::vector<std::string> relaxed{"start={relaxation: {tolerance: 1e-6}}", "loads={gravity: [0, 0, -1e5]}",
                                         "parts.block.at=[0, 0, 0]"};
  EXPECT_EQ(run(relaxed, "true").summary.state_hash, run(relaxed, "false").summary.state_hash);
}

}  // namespace percuss::test::skip_test
