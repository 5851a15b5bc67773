// The plan of the contact decomposition against the decomposition that ranks make in their first search.

#include "src/contact/plan/plan_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

const std::string bricks = R"(
time: {end: 1}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
parts:
  wall: {box: {size: [1, 0.5, 0.4], cells: [4, 3, 2]}, array: {count: [3, 2, 3], pitch: [1, 0.5, 0.4]}, material: m}
  ball: {sphere: {radius: 0.5, cells: 8}, at: [1.4, 0.5, 1.72], material: m}
)";

/// Contact of a scene at rest on the ranks of the program, and the plan for as many ranks.
struct PlanAndRun {
  explicit PlanAndRun(const std::string& contact)
      : deck(parse_deck(bricks + contact, "deck.yaml")),
        share(load_mesh(deck, world)),
        whole(load_mesh(deck, Communicator(MPI_COMM_SELF))),
        stage(share, deck, world),
        planner(whole, deck),
        plan(planner.plan(share.numbering.ranks, world.size())) {}

  ContactReport step() {
    const Rows3<double> x = to_rows("test::x", share.mesh.nodes);
    const std::size_t nodes = share.mesh.nodes.size();
    const Rows3<double> v("test::v", nodes), before("test::before", nodes), impulse("test::impulse", nodes);
    const Rows3<double> inverse_mass("test::inverse_mass", nodes);
    Kokkos::deep_copy(inverse_mass, 1);
    return stage.apply({x, before, v, inverse_mass, impulse, 1e-6});
  }

  /// Searched nodes that each rank owns, on every rank.
  std::vector<std::int64_t> count_owned_nodes() const {
    std::vector<std::int64_t> owned(plan.ranks.size(), 0);
    for (const double rank : stage.contact_ranks()) {
      if (rank >= 0) ++owned[static_cast<std::size_t>(rank)];
    }
    MPI_Allreduce(MPI_IN_PLACE, owned.data(), static_cast<int>(owned.size()), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    return owned;
  }

  const Communicator world = Communicator::world();
  const Deck deck;
  const ChunkedMesh share, whole;
  ContactStage stage;
  const ContactPlanner planner;
  const ContactPlan plan;
};

class PlanContact : public testing::TestWithParam<const char*> {};

TEST_P(PlanContact, DividesNodesAndCopiesFacesAsRanksDo) {
  PlanAndRun both(GetParam());
  both.step();
  EXPECT_EQ(both.planner.nodes(), both.stage.contact_nodes());
  EXPECT_EQ(both.planner.faces(), both.stage.contact_faces());
  const std::vector<std::int64_t> owned = both.count_owned_nodes();
  std::int64_t points = 0, most = 0;
  for (std::size_t r = 0; r < owned.size(); ++r) {
    EXPECT_EQ(both.plan.ranks[r].nodes, owned[r]) << "rank " << r;
    points += both.plan.ranks[r].points();
    most = std::max(most, both.plan.ranks[r].points());
  }
  EXPECT_EQ(points, both.planner.points());
  if (both.world.size() == 1) return;
  const DecompositionReport report = both.stage.decomposition();
  EXPECT_EQ(both.plan.ghost_faces, report.ghost_faces);
  EXPECT_DOUBLE_EQ(static_cast<double>(most) * both.world.size() / static_cast<double>(points), report.imbalance);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, PlanContact,
                         testing::Values("contact: {surfaces: all}\n", "contact: {surfaces: [[ball, wall]]}\n",
                                         "contact: {surfaces: all, reuse_search: false}\n"));

TEST(PlanContactTraffic, ForetellsRoughlyWhatAWallOfBricksSends) {
  PlanAndRun both("contact: {surfaces: all, edges: false}\n");  // the plan counts nodes and faces
  const ContactReport report = both.step();
  const Traffic sent = both.stage.traffic();
  std::int64_t bytes = sent.bytes, planned = 0;
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  for (const ContactRankPlan& rank : both.plan.ranks) {
    planned += rank.telling.bytes + rank.search.bytes + rank.step.bytes + (report.iterations + 1) * rank.pass.bytes;
  }
  std::int64_t messages = sent.messages, planned_messages = 0;
  MPI_Allreduce(MPI_IN_PLACE, &messages, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  for (const ContactRankPlan& rank : both.plan.ranks)
    planned_messages += rank.telling.messages + rank.search.messages + rank.step.messages +
                        (report.iterations + 1) * rank.pass.messages;
  EXPECT_GE(planned_messages, messages / 2);
  EXPECT_LE(planned_messages, messages * 2);
  // Bricks face to face: nearly every node touches a face, but some touch two or three.
  EXPECT_GE(planned, bytes / 2);
  EXPECT_LE(planned, bytes * 2);
  EXPECT_EQ(planned > 0, both.world.size() > 1);
}

TEST(PlanContactWithoutContact, HasNothingToDivide) {
  PlanAndRun both("");
  EXPECT_EQ(both.planner.points(), 0);
  EXPECT_EQ(both.plan.ranks.front().points(), 0);
  EXPECT_EQ(both.plan.ghost_faces, 0);
}

}  // namespace
}  // namespace percuss::test
