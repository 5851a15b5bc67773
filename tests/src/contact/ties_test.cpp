// Which nodes are tied where.

#include "src/contact/ties.hpp"

#include <gtest/gtest.h>

#include "src/deck/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decompose.hpp"

namespace percuss::test {
namespace {

// Two blocks face to face at x = 2 with a gap of 0.01, meshes 2 : 3; a third on top of the second.
const std::string blocks = R"(
time: {end: 1}
parts:
  a: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, material: m}
  b: {box: {size: [3, 2, 2], cells: [3, 3, 3]}, at: [2.01, 0, 0], material: m}
  c: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, at: [2.01, 0, 2], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)";

struct Tied {
  explicit Tied(const std::string& contact)
      : deck(parse_deck(blocks + "contact: " + contact + "\n", "deck.yaml")),
        chunked(load_mesh(deck, Communicator::world())),
        ties(find_ties(chunked, deck, Communicator::world())) {}
  Deck deck;
  ChunkedMesh chunked;
  TiedSurfaces ties;
};

void expect_error(const std::string& contact, const std::string& message) {
  try {
    Tied tied(contact);
    ADD_FAILURE() << "no error: " << message;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Ties, TieEachNodeInReachToTheFaceInFrontOfIt) {
  const Tied t("{ties: [{a: b, b: a/x_max}]}");
  ASSERT_EQ(t.ties.counts.size(), 1U);
  EXPECT_EQ(t.ties.counts[0].tied, 16);        // 4 x 4 nodes of b face a
  EXPECT_EQ(t.ties.counts[0].apart, 56 - 16);  // of b's surface: 4^3 less 2^3 inside
  EXPECT_NEAR(t.ties.counts[0].farthest, 0.01, 1e-15);
  ASSERT_EQ(t.ties.nodes.size(), 16U);
  for (const TiedNode& tied : t.ties.nodes) {
    double sum = 0;
    for (const double weight : tied.geometry.weight) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR(tied.geometry.offset.x, 0.01, 1e-15);
    EXPECT_NEAR(tied.geometry.offset.y, 0, 1e-15);
    EXPECT_NEAR(tied.geometry.offset.z, 0, 1e-15);
    EXPECT_EQ(tied.geometry.size, 1);
  }
  EXPECT_EQ(t.ties.faces[0][1].size(), 4U);
}

TEST(Ties, GoNoFartherThanTheirDistance) {
  expect_error("{ties: [{a: b/x_min, b: a/x_max, distance: 9e-3}]}",
               "deck.yaml:8:18: error: tie of 'b/x_min' and 'a/x_max' ties nothing (16 nodes of 'b/x_min' are farther "
               "than 0.009 from it");
  EXPECT_EQ(Tied("{ties: [{a: b/x_min, b: a/x_max, distance: 1.1e-2}]}").ties.counts[0].tied, 16);
}

TEST(Ties, TheFirstOfTwoTiesHoldsANode) {
  // c stands on b: its lower side is tied to b, but for the nodes that hold to a.
  const Tied t("{ties: [{a: c/x_min, b: a, distance: 0.02}, {a: c/z_min, b: b/z_max}]}");
  EXPECT_EQ(t.ties.counts[0].tied, 3);  // the lower edge
  EXPECT_EQ(t.ties.counts[1].earlier, 3);
  EXPECT_EQ(t.ties.counts[1].tied, 6);
  const std::vector<std::string> lines = describe_ties(t.deck, t.ties);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "3 nodes of 'c/x_min' tied to 'a' (up to 0.01 away), 6 not in reach");
  EXPECT_EQ(lines[1],
            "6 nodes of 'c/z_min' tied to 'b/z_max' (up to 0 away), 0 not in reach, 3 tied by an earlier tie");
}

TEST(Ties, LeaveOutWhatTheMeshJoins) { expect_error("{ties: [{a: b/x_min, b: b/z_max}]}", "4 the mesh joins"); }

TEST(Ties, OfASurfaceWithItselfAreRefused) {
  expect_error("{ties: [{a: b, b: b/z_max}]}",
               "deck.yaml:8:18: error: tie of 'b' and 'b/z_max' ties a surface to itself");
}

}  // namespace
}  // namespace percuss::test
