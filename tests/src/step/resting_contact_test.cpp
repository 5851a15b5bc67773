// Bodies that touch and rest: nothing of them is computed again until something reaches them, and no bit tells.

#include <gtest/gtest.h>

#include "tests/src/step/eroding_scene.hpp"

namespace percuss::test {
namespace {

// Bricks in touch, beams that cross on them, sheets on those, and a pin that comes down on it all. Pitches that no
// binary number meets leave the round-off of places between all of them.
const std::string pile = R"(
time: {end: 1, max_step: 4e-5}
parts:
  bricks: {box: {size: [0.3, 0.2, 0.1], cells: [3, 2, 1]}, array: {count: [3, 2, 3], pitch: [0.3, 0.2, 0.1]}, at: [0.1, 0.7, 1.1], material: m}
  lower:  {box: {size: [0.7, 0.1, 0.1], cells: [7, 1, 1]}, at: [0.17, 0.83, 1.4], material: m}
  upper:  {box: {size: [0.1, 0.35, 0.1], cells: [1, 7, 1]}, rotate: [{axis: z, angle: 17}], at: [0.61, 0.71, 1.5], material: m}
  sheets: {shell_plate: {size: [0.5, 0.3], cells: [5, 4]}, array: {count: [1, 1, 3], pitch: [1, 1, 0.007]}, at: [0.33, 0.73, 1.6035], thickness: 0.007, material: m}
  pin:    {box: {size: [0.11, 0.11, 0.11], cells: [2, 2, 2]}, at: [0.57, 0.81, 1.626], material: m}
materials: {m: {model: j2_plasticity, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, yield_stress: 1e7, hardening_modulus: 1e8, failure: {principal_strain: 9}}}
initial: [{part: pin, velocity: [1, 2, -15]}]
contact: {surfaces: all, friction: 0.3, MORE}
elements: {skip_resting: SKIP}
)";

std::string write_deck(const std::string& more, bool skips) {
  std::string deck = pile;
  const auto put = [&](const std::string& mark, const std::string& text) {
    deck.replace(deck.find(mark), mark.size(), text);
  };
  put(", MORE", (more.empty() ? "" : ", " + more) + (skips ? "" : ", reuse_search: false"));
  put("SKIP", skips ? "true" : "false");
  return deck;
}

void expect_same_report(const ContactReport& a, const ContactReport& b, int step) {
  EXPECT_EQ(a.interactions, b.interactions) << "step " << step;
  EXPECT_EQ(a.iterations, b.iterations) << "step " << step;
  EXPECT_EQ(a.residual, b.residual) << "step " << step;
  EXPECT_EQ(a.deepest, b.deepest) << "step " << step;
  EXPECT_EQ(a.deepest_node, b.deepest_node) << "step " << step;
  EXPECT_EQ(a.converged, b.converged) << "step " << step;
  EXPECT_EQ(a.normal_work, b.normal_work) << "step " << step;
  EXPECT_EQ(a.stored, b.stored) << "step " << step;
}

double find_share(const PairCounts& now, const PairCounts& before) {
  return static_cast<double>(now.left_out - before.left_out) / static_cast<double>(now.candidates - before.candidates);
}

TEST(RestingContact, IsTheSameToTheBitWhereNothingIsSkipped) {
  for (const char* more : {"", "edges: true", "enforcement: penalty", "enforcement: lagrange, edges: true"}) {
    ErodingScene together(write_deck(more, true)), alone(write_deck(more, true), Communicator(MPI_COMM_SELF)),
        all(write_deck(more, false), Communicator(MPI_COMM_SELF));
    PairCounts before;
    int most = 0, iterating = 0;
    const bool is_lagrange = all.scene.deck.contact.enforcement == ContactDeck::Enforcement::lagrange;
    for (int step = 0; step < (is_lagrange ? 25 : 60); ++step) {
      for (ErodingScene* scene : {&together, &alone, &all}) scene->advance();
      const ContactReport& report = all.scene.stepper.contact_report();
      expect_same_report(alone.scene.stepper.contact_report(), report, step);
      expect_same_report(together.scene.stepper.contact_report(), report, step);
      const std::uint64_t hash = hash_state(all.scene.model, all.scene.state);
      ASSERT_EQ(hash_state(alone.scene.model, alone.scene.state), hash) << more << ", step " << step;
      ASSERT_EQ(hash_state(together.scene.model, together.scene.state), hash) << more << ", step " << step;
      most = std::max(most, report.interactions);
      iterating += report.iterations > 0 ? 1 : 0;
      if (step == 1) before = alone.scene.contact.pair_counts();
      if (step == 6) {
        // There are rows, but none that pushes: a pass for springs, and one for what is iterated.
        const bool is_automatic = all.scene.deck.contact.enforcement == ContactDeck::Enforcement::automatic;
        EXPECT_EQ(report.iterations, is_lagrange ? 0 : is_automatic ? 2 : 1);
        EXPECT_EQ(most, 0);
        EXPECT_GT(find_share(alone.scene.contact.pair_counts(), before), 0.95);
      }
    }
    EXPECT_GT(most, 20);
    EXPECT_EQ(all.scene.contact.pair_counts().left_out, 0);
    if (is_lagrange) continue;  // which iterates where something closes only
    EXPECT_EQ(all.scene.contact.enforcements(), iterating);
    EXPECT_LT(alone.scene.contact.enforcements(), iterating);
    EXPECT_LT(together.scene.contact.enforcements(), iterating);
  }
}

TEST(RestingContact, RestsToTheLastBit) {
  ErodingScene scene(write_deck("edges: true", true));
  for (int step = 0; step < 7; ++step) scene.advance();
  for (const char* part : {"bricks", "lower", "upper", "sheets"}) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(scene.find_least(scene.scene.state.v, part, k), 0) << part;
      EXPECT_EQ(scene.find_largest_of(scene.scene.state.v, part, k), 0) << part;
    }
  }
}

/// Bodies that touch, but for which nothing happens.
std::string write_resting(const std::string& parts, const std::string& contact) {
  return "time: {end: 1, max_step: 4e-5}\nparts:\n" + parts +
         "materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, failure: "
         "{principal_strain: 9}}}\ncontact: {surfaces: all, " +
         contact + "}\n";
}

/// Whether nothing of contact is computed from the fourth step on, though all touches.
void expect_rest(const std::string& deck) {
  ErodingScene scene(deck);
  PairCounts before;
  for (int step = 0; step < 30; ++step) {
    scene.advance();
    if (step == 3) before = scene.scene.contact.pair_counts();
  }
  const ContactReport& report = scene.scene.stepper.contact_report();
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.interactions, 0);
  EXPECT_LE(scene.scene.contact.enforcements(), 3);
  const PairCounts after = scene.scene.contact.pair_counts();
  if (after.candidates > before.candidates) {
    EXPECT_EQ(find_share(after, before), 1);
  }
}

TEST(RestingContact, IsLeftOutWhereFewOfTheFacesTouch) {
  expect_rest(write_resting(R"(
  plate: {box: {size: [0.9, 0.9, 0.1], cells: [3, 3, 1]}, material: m}
  brick: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, at: [0.41, 0.39, 0.1], material: m}
)",
                            "friction: 0.3"));
}

TEST(RestingContact, IsLeftOutWhereEdgesRememberAnOverlap) {
  expect_rest(write_resting(R"(
  lower: {box: {size: [0.7, 0.1, 0.1], cells: [7, 1, 1]}, material: m}
  upper: {box: {size: [0.1, 0.7, 0.1], cells: [1, 7, 1]}, at: [0.333, -0.27, 0.098], material: m}
)",
                            "edges: true, overlap: accept"));
}

TEST(RestingContact, IsTheSameToTheBitWhereElementsDie) {
  ErodingScene together(write_deck("", true)), alone(write_deck("", true), Communicator(MPI_COMM_SELF)),
      all(write_deck("", false), Communicator(MPI_COMM_SELF));
  for (ErodingScene* scene : {&together, &alone, &all}) {
    scene->run(4);
    scene->kill({{0.45, 0.75, 1.35}, {0.85, 0.85, 1.15}});
    scene->run(3);
    scene->kill({{0.55, 0.75, 1.25}});
    scene->run(50);
  }
  EXPECT_EQ(alone.events, 2);
  EXPECT_EQ(hash_state(alone.scene.model, alone.scene.state), hash_state(all.scene.model, all.scene.state));
  EXPECT_EQ(hash_state(together.scene.model, together.scene.state), hash_state(all.scene.model, all.scene.state));
}

}  // namespace
}  // namespace percuss::test
