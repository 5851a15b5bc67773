// What `percuss plan` computes from a plan, and how it tells it.

#include "src/app/reports/plan_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss {
namespace {

using testing::HasSubstr;

// A bar of 32 x 4 x 4 elements: two ranks share one section of 25 nodes and each sends a force for each node of it.
const std::string bar = R"(title: A bar
time: {end: 1}
parts: {bar: {box: {size: [8, 1, 1], cells: [32, 4, 4]}, material: steel}}
materials: {steel: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)";

/// At rest.
ContactScene make_scene(const ChunkedMesh& whole) {
  const Rows3<double> v("test::v", whole.mesh.nodes.size());
  return {{to_rows("test::x", whole.mesh.nodes), v, 0}, 7};
}

/// Plans of a deck for some numbers of ranks.
struct Planned {
  Planned(const std::string& text, const std::vector<int>& rank_counts)
      : deck(parse_deck(text, "deck.yaml")),
        mesh(deck),
        whole(load_mesh(deck, self)),
        contact(whole, deck, make_scene(whole)) {
    for (const int ranks : rank_counts) {
      DecompositionPlan divided = mesh.plan(ranks);
      ContactPlan surfaces = contact.plan(divided.partition.parts, ranks);
      plans.push_back({ranks, std::move(divided), std::move(surfaces)});
    }
  }

  std::string format() const {
    const Numbering& numbering = whole.numbering;
    return format_plan(
        {deck, numbering.element_count(), numbering.node_count(), numbering.chunk_count(), contact.nodes(),
         contact.faces(), contact.contacts(), first_step, find_step_pattern(deck, contact)},
        figures, plans);
  }

  const Communicator self{MPI_COMM_SELF};
  Deck deck;
  DecompositionPlanner mesh;
  ChunkedMesh whole;
  ContactPlanner contact;
  std::vector<RanksPlan> plans;
  PlanFigures figures;
  double first_step = 0.25;
};

TEST(PlanEstimate, AddsUpComputingMessagesAndReductions) {
  Planned planned(bar, {1, 2});
  planned.figures = {.latency = 1e-6, .bandwidth = 1e6, .element_ns = 100, .contact_node_ns = 7};
  const StepPattern pattern = find_step_pattern(planned.deck, planned.contact);
  const StepEstimate one = estimate_step(planned.plans[0], pattern, planned.figures);
  EXPECT_DOUBLE_EQ(one.step(), 512 * 100e-9);
  EXPECT_DOUBLE_EQ(one.efficiency, 1);
  const StepEstimate two = estimate_step(planned.plans[1], pattern, planned.figures);
  EXPECT_DOUBLE_EQ(two.computing, 256 * 100e-9);
  EXPECT_DOUBLE_EQ(two.halo, 1e-6 + 25 * 24 / 1e6);
  EXPECT_DOUBLE_EQ(two.contact, 0);
  EXPECT_DOUBLE_EQ(two.reductions, 1e-6);
  EXPECT_DOUBLE_EQ(two.efficiency, one.step() / (2 * two.step()));
}

TEST(PlanEstimate, CountsTheReductionsOfEveryKindOfScene) {
  const PlanFigures figures{.iterations = 10, .steps_per_search = 4};
  EXPECT_EQ(count_reductions({}, figures), 1);
  EXPECT_EQ(count_reductions({.has_gravity = true}, figures), 2);
  EXPECT_EQ(count_reductions({.has_walls = true}, figures), 1 + 2 + 10);
  EXPECT_EQ(count_reductions({.has_pairs = true}, figures), 1 + 2 + 10 + 1 + 4.0 / 4);
  EXPECT_EQ(count_reductions({.has_pairs = true, .reuses_search = false}, figures), 1 + 2 + 10 + 4);
  EXPECT_EQ(count_reductions({.has_pairs = true, .has_contacts = false}, figures), 1 + 1 + 1 + 4.0 / 4);
}

TEST(PlanReport, HasAColumnForEachNumberOfRanks) {
  const std::string text = Planned(bar, {1, 2, 4}).format();
  EXPECT_THAT(text, HasSubstr("deck     deck.yaml: A bar\n"));
  EXPECT_THAT(text, HasSubstr("512 elements in 8 chunks, 825 nodes\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nranks +1 +2 +4\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nelements per rank, most +512 +256 +128\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nhalo bytes per step, most +0 +600 +1200\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nparallel efficiency .%. +100.0 "));
  EXPECT_EQ(text.find("contact points"), std::string::npos);
  EXPECT_EQ(text.find("warning"), std::string::npos);
}

TEST(PlanEstimate, CountsTheStepsToTheEnd) {
  TimeDeck time;
  time.end = 1;
  EXPECT_EQ(count_steps(time, 0.25), 4);
  EXPECT_EQ(count_steps(time, 0.3), 4);
  time.max_steps = 3;
  EXPECT_EQ(count_steps(time, 0.25), 3);
  time.max_steps = 9;
  EXPECT_EQ(count_steps(time, 0.25), 4);
}

// 512 elements of 1 s are 512 s a step on one core; on two a step takes half of it and 4 s for two messages.
TEST(PlanReport, TellsRunTimeAndCoreHours) {
  Planned planned(bar, {1, 2});
  planned.figures = {.latency = 2, .bandwidth = 1e30, .element_ns = 1e9};
  const std::string text = planned.format();
  EXPECT_THAT(text, HasSubstr("\ntime     0 to 1; first step 0.25, 4 steps of this length\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nrun time +34 min 08 s +17 min 20 s\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\ncore hours +0.57 +0.58\n"));
  planned.figures.element_ns = 1e6;
  EXPECT_THAT(planned.format(), testing::ContainsRegex("\nrun time +2 s +17 s\ncore hours +< 0.01 +< 0.01\n"));
  planned.figures.element_ns = 1e9 * 3600;
  planned.figures.latency = 0;
  EXPECT_THAT(planned.format(),
              testing::ContainsRegex("\nrun time +2048 h 00 min +1024 h 00 min\ncore hours +2048 +2048\n"));
  planned.figures.element_ns = 1;
  EXPECT_THAT(planned.format(), testing::ContainsRegex("\nrun time +< 1 s +< 1 s\ncore hours +< 0.01 +< 0.01\n"));
}

TEST(PlanReport, WarnsOfRanksWithoutElements) {
  const std::string text = Planned(bar, {11}).format();
  EXPECT_THAT(text, HasSubstr("warning: 3 of 11 ranks would have no elements (the mesh has 8 chunks"));
}

TEST(PlanReport, WarnsOfTooFewChunksToBeEven) {
  EXPECT_THAT(Planned(bar, {3}).format(), HasSubstr("warning: on 3 ranks the heaviest has 1.12 times the mean"));
}

TEST(PlanReport, WarnsOfTooFewContactPoints) {
  // 31 sections with 16 nodes outside and two ends of 25; 4 x 4 x 32 + 2 x 16 faces.
  const std::string text = Planned(bar + "contact: {surfaces: all}\n", {2, 16}).format();
  EXPECT_THAT(text, HasSubstr("; 546 contact nodes, 544 contact faces\ncontacts 0, those of the start, for the whole "
                              "run; bodies that meet later"));
  EXPECT_THAT(text, testing::ContainsRegex("\ncontact points per rank, most +545 +69\n"));
  EXPECT_THAT(text, HasSubstr("warning: on 16 ranks each has only 68 contact nodes and faces"));
  EXPECT_EQ(text.find("warning: on 2 ranks"), std::string::npos);
}

// The bar stands on a wall with the 25 nodes of its end.
TEST(PlanReport, TellsForWhichContactsItIs) {
  Planned planned(bar + "walls: [{normal: x}]\n", {1, 2});
  const std::string text = planned.format();
  EXPECT_THAT(text, HasSubstr("\ncontacts 25, those of the start, for the whole run\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\ncontacts per rank, most +25 +25\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\ncontact messages per step, most +0 +1\n"));
  EXPECT_EQ(text.find("contact points"), std::string::npos);
  planned.figures.all_touch = true;
  EXPECT_THAT(planned.format(), HasSubstr("\ncontacts 25: every node near a face touches one (--all-touch)\n"));
}

}  // namespace
}  // namespace percuss
