// The plan of the contact decomposition against the decomposition that ranks make in their first search.

#include "src/contact/plan/plan_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "kernels/core/host_copy.hpp"
#include "kernels/node/motion.hpp"
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
  ball: {sphere: {radius: 0.5, cells: 8}, at: [1.4, 0.5, 1.7], material: m}
)";

/// A share of a mesh in motion. velocity: by the part of an element of each node.
struct MovingNodes {
  MovingNodes(const Mesh& mesh, const std::map<std::string, Vec3>& velocity)
      : x(to_rows("test::x", mesh.nodes)), v("test::v", mesh.nodes.size()) {
    const auto host = Kokkos::create_mirror_view(v);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const auto of_part = velocity.find(mesh.parts[static_cast<std::size_t>(mesh.part_of(e))].name);
      if (of_part == velocity.end()) continue;
      for (const int n : mesh.corners(e))
        for (std::size_t k = 0; k < 3; ++k) host(static_cast<std::size_t>(n), k) = of_part->second[k];
    }
    Kokkos::deep_copy(v, host);
  }

  SurfaceMotion seen() const { return {x, v, dt}; }

  Rows3<double> x, v;
  static constexpr double dt = 1e-4;
};

/// Contact of a scene on the ranks of the program, and the plan for as many ranks.
struct PlanAndRun {
  explicit PlanAndRun(const std::string& text, const std::map<std::string, Vec3>& velocity = {},
                      double steps_per_search = 1)
      : deck(parse_deck(text, "deck.yaml")),
        share(load_mesh(deck, world)),
        whole(load_mesh(deck, Communicator(MPI_COMM_SELF))),
        nodes(share.mesh, velocity),
        stage(share, deck, world),
        planner(whole, deck, {MovingNodes(whole.mesh, velocity).seen(), steps_per_search}),
        plan(planner.plan(share.numbering.ranks, world.size())) {}

  /// From n to n+1. Nothing changes velocities but contact.
  ContactReport step() {
    const std::size_t count = share.mesh.nodes.size();
    const Rows3<double> before("test::before", count), impulse("test::impulse", count);
    const Rows3<double> inverse_mass("test::inverse_mass", count), v("test::moving", count);
    Kokkos::deep_copy(inverse_mass, 1);
    Kokkos::deep_copy(v, nodes.v);
    Kokkos::deep_copy(before, nodes.v);
    const ContactReport report = stage.apply({nodes.x, before, v, inverse_mass, impulse, MovingNodes::dt});
    move_nodes(ExecSpace(), nodes.v, MovingNodes::dt, nodes.x);
    return report;
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

  /// Messages and bytes of all ranks so far.
  PlannedTraffic sum_sent() const {
    const Traffic sent = stage.traffic();
    double sums[2] = {static_cast<double>(sent.messages), static_cast<double>(sent.bytes)};
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return {sums[0], sums[1]};
  }

  const Communicator world = Communicator::world();
  const Deck deck;
  const ChunkedMesh share, whole;
  MovingNodes nodes;
  ContactStage stage;
  const ContactPlanner planner;
  const ContactPlan plan;
};

class PlanContact : public testing::TestWithParam<const char*> {};

TEST_P(PlanContact, DividesNodesAndCopiesFacesAsRanksDo) {
  PlanAndRun both(bricks + GetParam());
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

/// What some steps of a run send against the plan, with its iterations and searches: within a fifth.
void expect_planned_traffic(const std::string& text, const std::map<std::string, Vec3>& velocity) {
  constexpr int steps = 48;
  PlanAndRun run(text, velocity);
  const PlannedTraffic before = run.sum_sent();
  int searches = 0;
  std::int64_t iterations = 0;
  for (int s = 0; s < steps; ++s) {
    const ContactReport report = run.step();
    searches += report.searched ? 1 : 0;
    iterations += report.iterations;
  }
  const PlannedTraffic after = run.sum_sent();
  const double sent_messages = after.messages - before.messages, sent_bytes = after.bytes - before.bytes;
  const PlanAndRun planned(text, velocity, static_cast<double>(steps) / searches);
  double messages = 0, bytes = 0;
  for (const ContactRankPlan& rank : planned.plan.ranks) {
    const double passes = static_cast<double>(iterations + steps);
    messages += rank.telling.messages + searches * rank.search.messages + steps * rank.step.messages +
                passes * rank.pass.messages;
    bytes += rank.telling.bytes + searches * rank.search.bytes + steps * rank.step.bytes + passes * rank.pass.bytes;
  }
  EXPECT_NEAR(messages, sent_messages, 0.2 * sent_messages)
      << steps << " steps, " << searches << " searches, " << iterations << " iterations";
  EXPECT_NEAR(bytes, sent_bytes, 0.2 * sent_bytes);
  EXPECT_EQ(bytes > 0, run.world.size() > 1);
}

TEST(PlanContactTraffic, IsWhatAWallOfBricksSends) {
  expect_planned_traffic(bricks + "contact: {surfaces: all, edges: false}\n", {{"ball", {0, 0, -2}}});
}

TEST(PlanContactTraffic, IsWhatAWallOfBricksWithEdgesSends) {
  expect_planned_traffic(bricks + "contact: {surfaces: all}\n", {{"ball", {0, 0, -2}}});
}

TEST(PlanContactTraffic, IsWhatPlatesSendThatAreNearButDoNotTouch) {
  expect_planned_traffic(R"(
time: {end: 1}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
parts:
  lower: {box: {size: [2, 1, 0.1], cells: [20, 10, 1]}, material: m}
  upper: {box: {size: [2, 1, 0.1], cells: [18, 9, 1]}, at: [0.03, 0.02, 0.13], material: m}
contact: {surfaces: all}
)",
                         {{"upper", {2, 0, 0}}});
}

TEST(PlanContactRows, AreThoseOfTiesWithoutGlue) {
  const std::string blocks = R"(
time: {end: 1}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
parts:
  low: {box: {size: [2, 2, 1], cells: [3, 3, 1]}, material: m}
  high: {box: {size: [2, 2, 1], cells: [2, 2, 1]}, at: [0, 0, 1], material: m}
contact: {ties: [{a: high/z_min, b: low/z_max)";
  EXPECT_EQ(PlanAndRun(blocks + "}]}\n").planner.contacts(), 9);
  EXPECT_EQ(PlanAndRun(blocks + ", cohesive: {normal_stiffness: 1, normal_strength: 1, shear_strength: 1, "
                                "normal_energy: 5, shear_energy: 5}}]}\n")
                .planner.contacts(),
            0);
}

TEST(PlanContactWithoutContact, HasNothingToDivide) {
  PlanAndRun both(bricks);
  EXPECT_EQ(both.planner.points(), 0);
  EXPECT_EQ(both.plan.ranks.front().points(), 0);
  EXPECT_EQ(both.plan.ghost_faces, 0);
}

}  // namespace
}  // namespace percuss::test
