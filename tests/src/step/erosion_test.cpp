// What the death of elements does to surface, contact, loads and ties: on any number of ranks the same bits.

#include <gtest/gtest.h>

#include "tests/src/step/eroding_scene.hpp"

namespace percuss::test {
namespace {

const std::string soft = R"(
materials:
  m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, failure: {principal_strain: 9}}
)";

/// A block of 5 x 5 x 3 cubes; more bodies by the caller.
std::string block_with(const std::string& parts, const std::string& rest) {
  return "time: {end: 1000}\nparts:\n  block: {box: {size: [5, 5, 3], cells: [5, 5, 3]}, material: m}\n" + parts +
         soft + rest;
}

const std::string pin = "  pin: {box: {size: [0.4, 0.4, 0.4], cells: [1, 1, 1]}, at: [2.3, 2.3, 3.05], material: m}\n";
const std::string falls = "initial: [{part: pin, velocity: [0, 0, -0.5]}]\ncontact: {friction: 0}\n";

/// A plate of 5 x 5 shells of edge 1 and thickness 0.1 at height 0; more bodies by the caller.
std::string plate_with(const std::string& parts, const std::string& rest) {
  return "time: {end: 1000}\nparts:\n  plate: {shell_plate: {size: [5, 5], cells: [5, 5]}, thickness: 0.1, material: "
         "m}\n" +
         parts + soft + rest;
}

std::int64_t sum(const Communicator& ranks, std::int64_t value) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, ranks.handle());
  return value;
}

std::int64_t count_exterior(const ErodingScene& eroding) {
  return sum(eroding.scene.model.ranks,
             static_cast<std::int64_t>(find_exterior_faces(eroding.scene.chunked.mesh).size()));
}

}  // namespace

TEST(Erosion, ADeadElementOpensTheFacesOfItsNeighbours) {
  ErodingScene eroding(block_with(pin, falls));
  const std::int64_t before = count_exterior(eroding);
  eroding.kill({{2.5, 2.5, 2.5}});
  eroding.advance();
  EXPECT_EQ(eroding.events, 1);
  EXPECT_EQ(count_exterior(eroding), before + 4);  // five for one
  EXPECT_EQ(eroding.scene.contact.contact_faces(), before + 4);
  eroding.kill({{2.5, 2.5, 1.5}, {2.5, 1.5, 2.5}});
  eroding.advance();
  EXPECT_EQ(count_exterior(eroding), before + 4 + 4 + 2);  // five for one; four for two
  eroding.kill({{2.5, 2.5, 0.5}});
  eroding.advance();
  EXPECT_EQ(count_exterior(eroding), before + 4 + 4 + 2 + 2);  // four for two: through
  EXPECT_EQ(eroding.scene.state.books.eroded_elements, 4);
}

TEST(Erosion, APinFallsIntoTheHoleAndMeetsItsGround) {
  for (const bool has_hole : {false, true}) {
    ErodingScene eroding(block_with(pin, falls));
    if (has_hole) eroding.kill({{2.5, 2.5, 2.5}});
    double lowest = 10;
    for (int i = 0; i < 150; ++i) {
      eroding.advance();
      lowest = std::min(lowest, eroding.find_least(eroding.scene.state.x, "pin", 2));
      ASSERT_LT(eroding.scene.contact.measure_penetration(eroding.scene.state.x), 2e-3) << i;
    }
    // The ground gives way by the depth that the blow presses it to.
    EXPECT_NEAR(lowest, has_hole ? 2 : 3, 0.1);
    EXPECT_GT(eroding.find_least(eroding.scene.state.v, "pin", 2), 0);  // thrown back
  }
}

TEST(Erosion, WhatLiesInsideAnOpenedFaceIsHeldThere) {
  // The pin overlaps the upper layer wholly and the middle one by 0.1, deeper than contact can hold from the start.
  const std::string deep =
      "  pin: {box: {size: [0.4, 0.4, 0.4], cells: [1, 1, 1]}, at: [2.3, 2.3, 1.9], material: m}\n";
  ErodingScene eroding(block_with(deep, falls));
  eroding.kill({{2.5, 2.5, 2.5}});
  double lowest = 10;
  for (int i = 0; i < 60; ++i) {
    eroding.advance();
    lowest = std::min(lowest, eroding.find_least(eroding.scene.state.x, "pin", 2));
  }
  EXPECT_GT(lowest, 1.8);  // 0.02 are made in the step of the death, the rest is how the ground gives way
  EXPECT_GT(eroding.find_least(eroding.scene.state.v, "pin", 2), 0);
}

TEST(Erosion, ParticlesMeetFacesAndWalls) {
  const std::string cube = "  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [2.2, 2.2, 3.05], material: m}\n";
  for (const double velocity : {-0.5, 0.5}) {
    ErodingScene eroding(block_with(cube, "initial: [{part: cube, velocity: [0, 0, " + std::to_string(velocity) +
                                              "]}]\nwalls: [{point: [0, 0, 4.2], normal: [0, 0, -1]}]\n"
                                              "contact: {friction: 0}\n"));
    eroding.kill({{2.7, 2.7, 3.55}});
    double lowest = 10, highest = 0;
    for (int i = 0; i < 60; ++i) {
      eroding.advance();
      lowest = std::min(lowest, eroding.find_least(eroding.scene.state.x, "cube", 2));
      highest = std::max(highest, eroding.find_largest_of(eroding.scene.state.x, "cube", 2));
    }
    EXPECT_EQ(eroding.scene.state.books.eroded_elements, 1);
    EXPECT_GT(eroding.scene.state.time, 3);  // long enough to go through
    EXPECT_GT(lowest, 2.95);
    EXPECT_LT(highest, 4.2 + 1e-9);
    if (velocity < 0) {
      EXPECT_LT(lowest, 3.01);
    } else {
      EXPECT_GT(highest, 4.19);
    }
    EXPECT_LT(std::abs(eroding.audit(eroding.scene.state).energy.error), 1e-3);
  }
}

TEST(Erosion, PressureGoesWithItsElement) {
  ErodingScene eroding(block_with("", "loads: {pressure: [{faces: block/z_max, value: 0.01}]}\n"));
  eroding.run(3);
  eroding.kill({{2.5, 2.5, 2.5}});
  eroding.run(2);
  const auto host = to_host(eroding.scene.state.pressure_faces.share);
  std::int64_t off = 0;
  for (std::size_t f = 0; f < host.extent(0); ++f) off += host(f) == 0 ? 1 : 0;
  EXPECT_EQ(sum(eroding.scene.model.ranks, off), 1);
  eroding.run(60);
  const AuditResult audited = eroding.audit(eroding.scene.state);
  EXPECT_LT(std::abs(audited.energy.error), 1e-3);
  EXPECT_LT(audited.momentum.linear_error, 1e-12);
}

TEST(Erosion, TiesGoWithTheElementsOfTheirFaces) {
  const std::string top = "  top: {box: {size: [5, 5, 1], cells: [5, 5, 1]}, at: [0, 0, 3], material: m}\n";
  ErodingScene eroding(block_with(top, "contact: {ties: [{a: top/z_min, b: block/z_max}]}\n"));
  eroding.run(2);
  std::vector<Vec3> layer;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) layer.push_back({i + 0.5, j + 0.5, 2.5});
  EXPECT_GT(eroding.scene.stepper.contact_report().interactions, 0);
  eroding.kill({layer.begin(), layer.begin() + 5});
  eroding.run(2);
  const int some = eroding.scene.stepper.contact_report().interactions;
  EXPECT_GT(some, 0);
  EXPECT_LT(some, 36);
  eroding.kill({layer.begin() + 5, layer.end()});
  eroding.run(3);
  EXPECT_EQ(eroding.scene.stepper.contact_report().interactions, 0);
}

TEST(Erosion, TiesGoWithTheShellsOfTheirFacesAndNodes) {
  const std::string top = "  top: {box: {size: [5, 5, 1], cells: [5, 5, 1]}, at: [0, 0, 0.05], material: m}\n";
  const auto count = [](const ErodingScene& eroding) { return eroding.scene.stepper.contact_report().interactions; };
  const std::vector<Vec3> row = {{0.5, 0.5, 0}, {1.5, 0.5, 0}, {2.5, 0.5, 0}, {3.5, 0.5, 0}, {4.5, 0.5, 0}};
  ErodingScene faces(plate_with(top, "contact: {ties: [{a: top/z_min, b: plate}]}\n"));
  faces.run(2);
  EXPECT_EQ(count(faces), 36);
  faces.kill(row);
  faces.run(2);
  EXPECT_LE(count(faces), 30);
  EXPECT_GE(count(faces), 24);
  ErodingScene nodes(plate_with(top, "contact: {ties: [{a: plate/top, b: top/z_min}]}\n"));
  nodes.run(2);
  EXPECT_EQ(count(nodes), 36);
  nodes.kill(row);
  nodes.run(2);
  EXPECT_EQ(count(nodes), 30);
}

TEST(Erosion, ADeadShellTakesItsTwoFaces) {
  ErodingScene eroding(plate_with("", "contact: {friction: 0}\n"));
  EXPECT_EQ(eroding.scene.contact.contact_faces(), 50);
  eroding.kill({{2.5, 2.5, 0}});
  eroding.advance();
  EXPECT_EQ(eroding.scene.contact.contact_faces(), 48);
  EXPECT_EQ(count_exterior(eroding), 48);
  EXPECT_EQ(eroding.scene.contact.contact_nodes(), 36);
  eroding.kill({{0.5, 0.5, 0}});  // its corner becomes a particle
  eroding.advance();
  EXPECT_EQ(eroding.scene.contact.contact_faces(), 46);
  EXPECT_EQ(eroding.scene.contact.contact_nodes(), 36);
  EXPECT_EQ(eroding.scene.state.books.eroded_elements, 2);
}

TEST(Erosion, APinGoesThroughAHoleInAPlateAndIsHeldByItsRim) {
  // Over the middle of the element, over its edge to a neighbour, and across the hole.
  for (const auto& [x, width] : {std::pair{2.3, 0.4}, std::pair{2.8, 0.4}, std::pair{1.9, 1.2}}) {
    for (const bool has_hole : {false, true}) {
      const std::string block = "  pin: {box: {size: [" + std::to_string(width) +
                                ", 0.4, 0.4], cells: [1, 1, 1]}, at: [" + std::to_string(x) +
                                ", 2.3, 0.1], material: m}\n";
      ErodingScene eroding(
          plate_with(block,
                     "initial: [{part: pin, velocity: [0, 0, -0.2]}]\nconditions: [{nodes: "
                     "plate, fixed: [x, y, z, rx, ry, rz]}]\ncontact: {friction: 0, enforcement: kinematic}\n"));
      if (has_hole) eroding.kill({{2.5, 2.5, 0}});
      const bool goes_through = has_hole && x > 2 && x < 2.5;
      double lowest = 10;
      for (int i = 0; i < 150; ++i) {
        eroding.advance();
        lowest = std::min(lowest, eroding.find_least(eroding.scene.state.x, "pin", 2));
      }
      EXPECT_GT(eroding.scene.state.time, 3);  // long enough to go through
      if (goes_through) {
        EXPECT_LT(lowest, -0.3);
      } else {
        EXPECT_GT(lowest, 0.05 - 1e-3) << x << " " << has_hole;  // the top of the plate
      }
    }
  }
}

/// The deck with a search in every step.
std::string without_reuse(std::string deck) {
  const std::string contact = "contact: {";
  return deck.insert(deck.find(contact) + contact.size(), "reuse_search: false, ");
}

TEST(Erosion, OfShellsIsTheSameOnAnyNumberOfRanks) {
  for (const char* more : {"", "erosion: {free_nodes: remove}\n"}) {
    const std::string deck =
        plate_with("  pin: {box: {size: [0.4, 0.4, 0.4], cells: [1, 1, 1]}, at: [2.8, 2.3, 0.1], material: m}\n",
                   std::string("initial: [{part: pin, velocity: [0, 0, -0.5]}, {part: plate, angular_velocity: [0.1, "
                               "0.2, 0.3]}]\ncontact: {friction: 0.1}\nloads: {gravity: [0, 0.1, -0.2], pressure: "
                               "[{faces: plate/top, value: 0.01}]}\n") +
                       more);
    ErodingScene together(deck), alone(deck, Communicator(MPI_COMM_SELF)), searching(without_reuse(deck));
    for (ErodingScene* eroding : {&together, &alone, &searching}) {
      eroding->kill({{2.5, 2.5, 0}});
      eroding->run(20);
      eroding->kill({{0.5, 0.5, 0}, {1.5, 0.5, 0}, {0.5, 1.5, 0}, {1.5, 1.5, 0}, {4.5, 4.5, 0}});
      eroding->run(60);
    }
    EXPECT_EQ(hash_state(together.scene.model, together.scene.state), hash_state(alone.scene.model, alone.scene.state));
    EXPECT_EQ(hash_state(searching.scene.model, searching.scene.state),
              hash_state(alone.scene.model, alone.scene.state));
    EXPECT_EQ(searching.scene.contact.searches(), 80);  // steps, in two of which elements died
    EXPECT_LT(together.scene.contact.searches(), 40);
    EXPECT_EQ(together.scene.contact.contact_nodes(), alone.scene.contact.contact_nodes());
    EXPECT_EQ(together.scene.contact.contact_faces(), alone.scene.contact.contact_faces());
    const AuditResult a = together.audit(together.scene.state), b = alone.audit(alone.scene.state);
    EXPECT_EQ(a.energy.error, b.energy.error);
    EXPECT_EQ(a.eroded.energy, b.eroded.energy);
    EXPECT_EQ(a.momentum.angular_error, b.momentum.angular_error);
    EXPECT_LT(a.momentum.linear_error, 1e-12);
    EXPECT_LT(a.momentum.angular_error, 1e-12);
    EXPECT_LT(std::abs(a.energy.error), 1e-2);
  }
}

TEST(Erosion, IsTheSameOnAnyNumberOfRanks) {
  for (const char* more : {"", "erosion: {free_nodes: remove}\n"}) {
    const std::string deck =
        block_with(pin, falls +
                            "walls: [{point: [0, 0, 0], normal: [0, 0, 1]}]\n"
                            "loads: {gravity: [0, 0.1, -0.2], pressure: [{faces: block/z_max, value: 0.01}]}\n" +
                            more);
    ErodingScene together(deck), alone(deck, Communicator(MPI_COMM_SELF)), searching(without_reuse(deck));
    for (ErodingScene* eroding : {&together, &alone, &searching}) {
      eroding->kill({{2.5, 2.5, 2.5}});
      eroding->run(20);
      eroding->kill({{2.5, 2.5, 1.5}, {1.5, 2.5, 2.5}, {0.5, 0.5, 2.5}, {0.5, 0.5, 1.5}, {0.5, 0.5, 0.5}});
      eroding->run(60);
    }
    EXPECT_EQ(hash_state(together.scene.model, together.scene.state), hash_state(alone.scene.model, alone.scene.state));
    EXPECT_EQ(hash_state(searching.scene.model, searching.scene.state),
              hash_state(alone.scene.model, alone.scene.state));
    EXPECT_EQ(searching.scene.contact.searches(), 80);  // steps, in two of which elements died
    EXPECT_LT(together.scene.contact.searches(), 40);
    EXPECT_EQ(together.scene.contact.contact_nodes(), alone.scene.contact.contact_nodes());
    EXPECT_EQ(together.scene.contact.contact_faces(), alone.scene.contact.contact_faces());
    const AuditResult a = together.audit(together.scene.state), b = alone.audit(alone.scene.state);
    EXPECT_EQ(a.energy.error, b.energy.error);
    EXPECT_EQ(a.eroded.energy, b.eroded.energy);
    EXPECT_EQ(a.momentum.angular_error, b.momentum.angular_error);
    EXPECT_LT(a.momentum.linear_error, 1e-12);
    EXPECT_LT(a.momentum.angular_error, 1e-12);
  }
}

}  // namespace percuss::test
