// The contact stage on several ranks against the stage on one: the same bits for every node, step after step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/contact/geometry/point3.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

const std::string head =
    "time: {end: 1}\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n";

Communicator self() { return Communicator(MPI_COMM_SELF); }

/// A velocity that brings bodies together, shears them and shakes every node, from its place and number alone.
Point3 find_velocity(const Vec3& x, std::int64_t number) {
  const auto shake = [&](double seed) { return 0.2 * std::sin(seed * static_cast<double>(number + 1)); };
  return {0.3 * std::sin(2.1 * x[1] + x[2]) - 0.2 * x[0] + shake(12.9), 0.2 * std::cos(1.7 * x[0]) + shake(7.3),
          -0.35 * x[2] + shake(3.1)};
}

/// Nodes of a deck moved by the stage alone.
struct Nodes {
  Nodes(const Deck& deck, const Communicator& ranks)
      : chunked(load_mesh(deck, ranks)),
        stage(chunked, deck, ranks),
        x("test::x", count()),
        v("test::v", count()),
        before("test::before", count()),
        inverse_mass("test::inverse_mass", count()),
        impulse("test::impulse", count()) {
    for (std::size_t n = 0; n < count(); ++n) {
      const Vec3& p = chunked.mesh.nodes[n];
      const auto i = static_cast<int>(n);
      store_row(x, i, {p[0], p[1], p[2]});
      store_row(v, i, find_velocity(p, chunked.mesh.node_numbers[n]));
      const double m = 1 + 0.01 * static_cast<double>(chunked.mesh.node_numbers[n] % 7);
      store_row(inverse_mass, i, {1 / m, 1 / m, p[2] < 1e-3 ? 0 : 1 / m});
    }
  }

  std::size_t count() const { return chunked.mesh.nodes.size(); }
  ContactReport step(double dt) {
    Kokkos::deep_copy(before, v);
    const ContactReport report = stage.apply({x, before, v, inverse_mass, impulse, dt});
    for (int n = 0; n < static_cast<int>(count()); ++n) store_row(x, n, load_row(x, n) + dt * load_row(v, n));
    return report;
  }

  ChunkedMesh chunked;
  ContactStage stage;
  Rows3<double> x, v, before, inverse_mass, impulse;
};

void expect_equal(const Rows3<double>& share, const Rows3<double>& whole, const Nodes& nodes, const char* what) {
  int different = 0;
  for (std::size_t n = 0; n < nodes.count(); ++n) {
    const auto g = static_cast<std::size_t>(nodes.chunked.mesh.node_numbers[n]);
    for (std::size_t k = 0; k < 3; ++k) different += share(n, k) == whole(g, k) ? 0 : 1;
  }
  ASSERT_EQ(different, 0) << what;
}

/// One step of both; returns the number of contacts.
int step_both(Nodes& whole, Nodes& share, double dt) {
  const ContactReport a = whole.step(dt), b = share.step(dt);
  EXPECT_EQ(b.interactions, a.interactions);
  EXPECT_EQ(b.candidates, a.candidates);
  EXPECT_EQ(b.searched, a.searched);
  EXPECT_EQ(b.iterations, a.iterations);
  EXPECT_EQ(b.residual, a.residual);
  EXPECT_EQ(b.complementarity, a.complementarity);
  EXPECT_EQ(b.normal_work, a.normal_work);
  EXPECT_EQ(b.friction_work, a.friction_work);
  EXPECT_EQ(b.deepest, a.deepest);
  EXPECT_EQ(b.deepest_node, a.deepest_node);
  expect_equal(share.v, whole.v, share, "velocities");
  expect_equal(share.impulse, whole.impulse, share, "impulses");
  return a.interactions;
}

void compare(const std::string& text, int steps, double dt, int least_contacts) {
  const Deck deck = parse_deck(text + head, "deck.yaml");
  Nodes whole(deck, self()), share(deck, Communicator::world());
  EXPECT_EQ(share.stage.prepare(share.x, share.v), whole.stage.prepare(whole.x, whole.v));
  EXPECT_EQ(share.stage.contact_nodes(), whole.stage.contact_nodes());
  EXPECT_EQ(share.stage.contact_faces(), whole.stage.contact_faces());
  int most = 0;
  for (int i = 0; i < steps; ++i) most = std::max(most, step_both(whole, share, dt));
  EXPECT_GE(most, least_contacts);  // else the scene tests nothing
  EXPECT_EQ(share.stage.measure_penetration(share.x), whole.stage.measure_penetration(whole.x));
}

const std::string bricks = R"(
parts:
  wall: {box: {size: [1, 0.5, 0.4], cells: [4, 3, 2]}, array: {count: [3, 2, 3], pitch: [1, 0.5, 0.4]}, material: m}
  ball: {sphere: {radius: 0.5, cells: 8}, at: [1.4, 0.5, 1.72], material: m}
)";

TEST(ContactOnRanks, ABrickWallThatTouchesEverywhereGivesTheSameBits) {
  compare(bricks + "contact: {surfaces: all, friction: 0.3}\n", 4, 0.02, 100);
}

TEST(ContactOnRanks, RowsSolvedTogetherGiveTheSameBits) {
  compare(bricks + R"(
contact: {surfaces: all, friction: 0.3, enforcement: lagrange}
walls: [{point: [0, 0, 0.005], normal: [0, 0, 1], friction: 0.2}]
)",
          2, 0.02, 100);
}

TEST(ContactOnRanks, NeitherRebalancingNorReuseOfTheSearchChangesABit) {
  for (const char* more : {"rebalance: always, reuse_search: false", "rebalance: never", "rebalance: always"}) {
    compare(bricks + "contact: {surfaces: all, friction: 0.3, " + more + "}\n", 2, 0.02, 100);
  }
}

TEST(ContactOnRanks, ShellsAmongSolidsGiveTheSameBits) {
  compare(R"(
parts:
  wall: {box: {size: [1, 0.5, 0.4], cells: [4, 3, 2]}, array: {count: [2, 2, 2], pitch: [1, 0.5, 0.4]}, material: m}
  sheet: {shell_plate: {size: [2, 1], cells: [9, 7]}, at: [0.03, 0.02, 0.83], thickness: 0.06, material: m}
  other: {shell_plate: {size: [1.7, 0.9], cells: [8, 5]}, at: [0.1, 0.05, 0.89], thickness: 0.05, material: m}
  upright: {shell_box_tube: {size: [0.5, 0.6], length: 0.7, cells: [4, 5, 4]}, at: [0.9, 0.5, 0.93], thickness: 0.03, material: m}
contact: {surfaces: all, friction: 0.3}
)",
          6, 0.02, 50);
}

TEST(ContactOnRanks, NamedSurfacesAndWallsGiveTheSameBits) {
  compare(bricks + R"(
contact: {surfaces: [{a: ball, b: wall, friction: 0.1}], friction: 0}
walls: [{point: [0, 0, 0.005], normal: [0, 0, 1], friction: 0.2}, {point: [0, 0.01, 0], normal: [0, 1, 0], nodes: [wall]}]
)",
          4, 0.02, 20);
}

TEST(ContactOnRanks, OverlapAtTheStartIsTheSameReferenceOnAnyRanks) {
  compare(R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [6, 6, 3]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0.43, 0.41, 0.98], material: m}
contact: {surfaces: all, friction: 0.2}
)",
          4, 0.02, 5);
}

// Bars that lie across one another: only their edges meet.
const std::string crossed = R"(
parts:
  lower: {box: {size: [4, 0.5, 0.5], cells: [7, 1, 1]}, at: [-2, 0, 0], material: m}
  upper: {box: {size: [0.5, 4, 0.5], cells: [1, 7, 1]}, rotate: [{axis: z, angle: 20}], at: [0.2, -2, 0.505], material: m}
  roof:  {box: {size: [0.5, 0.5, 0.5], cells: [3, 3, 3]}, rotate: [{axis: x, angle: 45}, {axis: z, angle: 30}], at: [-0.4, -0.7, 1.012], material: m}
)";

TEST(ContactOnRanks, CrossedEdgesGiveTheSameBits) {
  compare(crossed + "contact: {surfaces: all, friction: 0.3}\n", 8, 0.02, 2);
  compare(crossed + "contact: {surfaces: [[lower, upper], [upper, roof]], rebalance: always, reuse_search: false}\n", 8,
          0.02, 2);
}

TEST(ContactOnRanks, OverlapOfEdgesAtTheStartIsTheSameReferenceOnAnyRanks) {
  compare(R"(
parts:
  lower: {box: {size: [4, 0.5, 0.5], cells: [7, 1, 1]}, at: [-2, 0, 0], material: m}
  upper: {box: {size: [0.5, 4, 0.5], cells: [1, 7, 1]}, rotate: [{axis: z, angle: 20}], at: [0.2, -2, 0.48], material: m}
contact: {surfaces: all, friction: 0.2}
)",
          4, 0.02, 1);
}

/// Sets the velocity of all nodes of a part along z.
void set_velocity(Nodes& nodes, const std::string& part, double velocity) {
  for (const int n : nodes.chunked.mesh.node_sets.at(part)) store_row(nodes.v, n, {0, 0, velocity});
}

TEST(ContactOnRanks, BodiesThatPartAndMeetAgainGiveTheSameBits) {
  const Deck deck = parse_deck(R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [6, 6, 3]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0.43, 0.41, 1.001], material: m}
contact: {surfaces: all, friction: 0.2}
)" + head,
                               "deck.yaml");
  Nodes whole(deck, self()), share(deck, Communicator::world());
  std::vector<int> contacts;
  for (const double velocity : {-1.0, 2.0, -2.0, 2.0}) {
    for (Nodes* nodes : {&whole, &share}) {
      set_velocity(*nodes, "a", 0);
      set_velocity(*nodes, "b", velocity);
    }
    contacts.push_back(0);
    for (int i = 0; i < 2; ++i) contacts.back() = std::max(contacts.back(), step_both(whole, share, 0.02));
  }
  EXPECT_GT(contacts[0], 0);
  EXPECT_EQ(contacts[1], 0);
  EXPECT_GT(contacts[2], 0);
  EXPECT_EQ(contacts[3], 0);
}

// A long way over a plate that is long in numbers of faces: faces come to other ranks, lists of near pairs are made,
// used, made anew and dropped, by ranks with many pairs and by ranks without.
TEST(ContactOnRanks, ABodyThatSlidesOverALongPlateGivesTheSameBits) {
  const Deck deck = parse_deck(R"(
parts:
  plate: {box: {size: [8, 1, 0.1], cells: [48, 6, 1]}, material: m}
  sledge: {box: {size: [1, 0.8, 0.3], cells: [7, 5, 2]}, at: [0.2, 0.1, 0.105], material: m}
contact: {surfaces: all, friction: 0.2}
)" + head,
                               "deck.yaml");
  Nodes whole(deck, self()), share(deck, Communicator::world());
  EXPECT_EQ(share.stage.prepare(share.x, share.v), whole.stage.prepare(whole.x, whole.v));
  int most = 0, touched = 0;
  constexpr int steps = 500;
  for (int i = 0; i < steps; ++i) {
    for (Nodes* nodes : {&whole, &share}) {  // pressed on every third step, as if by forces
      for (const int n : nodes->chunked.mesh.node_sets.at("plate")) store_row(nodes->v, n, {0, 0, 0});
      for (const int n : nodes->chunked.mesh.node_sets.at("sledge"))
        store_row(nodes->v, n, {1, 0.2 * std::sin(0.1 * i), i % 3 == 0 ? -0.6 : 0.2});
    }
    const int contacts = step_both(whole, share, 0.002);
    most = std::max(most, contacts);
    touched += contacts > 0 ? 1 : 0;
    if (testing::Test::HasFailure()) FAIL() << "in step " << i;
  }
  EXPECT_GE(most, 20);
  EXPECT_GT(touched, steps / 10);
  EXPECT_LT(touched, steps);
  const PairCounts pairs = whole.stage.pair_counts();
  EXPECT_GT(pairs.left_out, pairs.candidates / 10);  // else no near pairs were in use
  std::int64_t counts[2] = {share.stage.pair_counts().candidates, share.stage.pair_counts().left_out};
  MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(counts[0], pairs.candidates);
  EXPECT_GT(counts[1], pairs.candidates / 10);
  EXPECT_GT(whole.stage.searches(), 5);
  EXPECT_LT(whole.stage.searches(), steps / 2);
}

TEST(ContactOnRanks, WhatIsFarFromAnyContactIsNotSent) {
  const Deck deck = parse_deck(R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [6, 6, 3]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [40, 41, 98], material: m}
contact: {surfaces: all}
)" + head,
                               "deck.yaml");
  Nodes whole(deck, self()), share(deck, Communicator::world());
  step_both(whole, share, 1e-4);  // searches
  const Traffic before = share.stage.traffic();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(step_both(whole, share, 1e-4), 0);
  EXPECT_EQ(share.stage.searches(), 1);
  EXPECT_EQ(share.stage.traffic().messages, before.messages);
}

TEST(ContactOnRanks, ANodeThatRunsAwayIsRefusedByAllRanksAlike) {
  const Deck deck = parse_deck(R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [28, 28, 14]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [40, 41, 98], material: m}
contact: {surfaces: all}
)" + head,
                               "deck.yaml");
  const auto fail = [&](const Communicator& ranks) -> std::string {
    Nodes nodes(deck, ranks);
    for (const int n : nodes.chunked.mesh.node_sets.at("b")) store_row(nodes.v, n, {1e9, 0, 0});
    try {
      nodes.step(1);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  };
  const std::string alone = fail(self());
  EXPECT_NE(alone, "");
  EXPECT_EQ(fail(Communicator::world()), alone);
}

}  // namespace
}  // namespace percuss::test
