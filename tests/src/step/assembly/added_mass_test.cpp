// Mass that the deck adds to nodes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

std::string write_deck(const std::string& more) {
  return "time: {end: 1e-3}\nparts: {block: {box: {size: [0.2, 0.1, 0.1], cells: [4, 2, 2]}, material: steel}}\n" +
         more + steel_text;
}

constexpr double own_mass = 7850 * 0.2 * 0.1 * 0.1;

}  // namespace

TEST(AddedMass, ByMassIsThatOfAHigherDensity) {
  const Scene plain(write_deck("")), heavy(write_deck("added_mass: [{nodes: block, mass: 300}]\n"));
  EXPECT_NEAR(heavy.model.total_mass / (own_mass + 300), 1, 1e-14);
  for (std::size_t n = 0; n < 45; ++n) {
    EXPECT_NEAR(heavy.model.mass(n) / plain.model.mass(n), 1 + 300 / own_mass, 1e-12);
    EXPECT_DOUBLE_EQ(heavy.model.inverse_mass(n, 1) * heavy.model.mass(n), 1);
  }
  ASSERT_EQ(heavy.model.mass_notes.size(), 1U);
  EXPECT_EQ(heavy.model.mass_notes[0],
            "added mass of 'block': 300 on 45 nodes, by their mass, which have 15.7 of their own");
}

TEST(AddedMass, EvenlyGivesEachNodeTheSame) {
  const Scene plain(write_deck("")),
      heavy(write_deck("added_mass: [{nodes: block/z_max, mass: 30, spread: evenly}, {nodes: "
                       "{inside: [[0, 0, 0], [0, 0, 0]]}, mass: 2}]\n"));
  double sum = 0;
  for (std::size_t n = 0; n < 45; ++n) {
    const double z = plain.chunked.mesh.nodes[n][2], added = heavy.model.mass(n) - plain.model.mass(n);
    const Vec3& x = plain.chunked.mesh.nodes[n];
    EXPECT_NEAR(added, (z > 0.099 ? 2 : 0) + (x == Vec3{} ? 2 : 0), 1e-13);
    sum += added;
  }
  EXPECT_NEAR(sum, 32, 1e-12);
}

TEST(AddedMass, FallsAndCountsInMomentumAndEnergy) {
  const Summary summary =
      run_scene(
          parse_deck(write_deck("added_mass: [{nodes: block/x_max, mass: 300}]\ninitial: [{velocity: [0, 0, -10]}]\n"
                                "loads: {gravity: [0, 0, -100]}\n"),
                     "deck.yaml"),
          {})
          .summary;
  EXPECT_NEAR(summary.momentum.linear[2] / (-(own_mass + 300) * 10), 1.01, 1e-4);  // of the middle of the last step
  EXPECT_NEAR(summary.energy.initial / (0.5 * (own_mass + 300) * 100), 1, 1e-9);
  EXPECT_LT(summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(summary.energy.error), 1e-10);  // round-off in stiff elements
}

TEST(AddedMass, StaysWhereMassIsScaledDuringTheRun) {
  const std::string driven =
      "conditions: [{nodes: block/x_min, fixed: [x]}, {nodes: block/x_max, velocity: {x: 100}}]\n"
      "added_mass: [{nodes: block/z_max, mass: 30}]\n";
  Scene first(write_deck(driven));
  first.stepper.start(first.state);
  Scene scene("time: {end: 1e-3, mass_scaling: {step: " + fmt::format("{:.17g}", 0.999 * first.state.bound.step) +
              ", max_added: 9, every: 1}}\n" + write_deck(driven).substr(std::string("time: {end: 1e-3}\n").size()));
  scene.run(100);
  EXPECT_GT(scene.state.books.added_mass, 0);
  double elements = 0, nodes = 0;
  for (std::size_t e = 0; e < 16; ++e) elements += scene.state.element_mass(e);
  for (std::size_t n = 0; n < 45; ++n) nodes += scene.state.mass(n);
  EXPECT_NEAR(nodes / (elements + 30), 1, 1e-14);
}

TEST(AddedMass, OfAnUnknownSideIsRefused) {
  EXPECT_ERROR(Scene(write_deck("added_mass: [{nodes: block/lid, mass: 3}]\n")), InputError,
               "part 'block' has no side 'lid'");
}

}  // namespace percuss::test
