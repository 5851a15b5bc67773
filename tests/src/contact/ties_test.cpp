// Nodes that are tied, and where.

#include "src/contact/ties/ties.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"

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
  explicit Tied(const std::string& contact, const std::string& parts = blocks)
      : deck(parse_deck(parts + "contact: " + contact + "\n", "deck.yaml")),
        chunked(load_mesh(deck, Communicator::world())),
        ties(find_ties(chunked, deck, Communicator::world())) {}
  Deck deck;
  ChunkedMesh chunked;
  TiedSurfaces ties;
};

void expect_error(const std::string& contact, const std::string& message, const std::string& parts = blocks) {
  try {
    Tied tied(contact, parts);
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

TEST(Ties, LeaveOutWhatTheMeshJoins) {
  expect_error("{ties: [{a: b/x_min, b: b/z_max}]}", "4 are already shared by the mesh");
}

TEST(Ties, OfASurfaceWithItselfAreRefused) {
  expect_error("{ties: [{a: b, b: b/z_max}]}",
               "deck.yaml:8:18: error: tie of 'b' and 'b/z_max' ties a surface to itself");
}

// A block below z = 0; a sheet of thickness 0.2, 0.01 above it beyond its half thickness; one of 0.1 flat on the sheet,
// unlike mesh; one edge on edge with the sheet.
const std::string sheets = R"(
time: {end: 1}
parts:
  block: {box: {size: [4, 4, 1], cells: [4, 4, 1]}, at: [0, 0, -1], material: m}
  sheet: {shell_plate: {size: [4, 4], cells: [4, 4]}, at: [0, 0, 0.11], thickness: 0.2, material: m}
  cover: {shell_plate: {size: [2, 2], cells: [3, 3]}, at: [1, 1, 0.26], thickness: 0.1, material: m}
  strip: {shell_plate: {size: [4, 2], cells: [8, 2]}, at: [4, 1, 0.11], thickness: 0.2, material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)";

TEST(TiesOfShells, CountTheGapBeyondTheThickness) {
  const Tied t("{ties: [{a: sheet, b: block/z_max, distance: 0.0101}]}", sheets);
  EXPECT_EQ(t.ties.counts[0].tied, 25);
  EXPECT_NEAR(t.ties.counts[0].farthest, 0.11, 1e-15);
  EXPECT_NEAR(t.ties.counts[0].widest, 0.01, 1e-15);
  EXPECT_EQ(
      describe_ties(t.deck, t.ties).at(0),
      "25 nodes of 'sheet' tied to 'block/z_max' (up to 0.11 away, 0.01 beyond the thickness of shells), 0 not in "
      "reach");
  for (const TiedNode& tied : t.ties.nodes) EXPECT_NEAR(tied.geometry.offset.z, 0.11, 1e-15);
  expect_error("{ties: [{a: sheet, b: block/z_max, distance: 0.0099}]}", "25 nodes of 'sheet' are farther", sheets);
  // nodes of a solid on shells likewise, and shells on shells by both halves
  EXPECT_EQ(Tied("{ties: [{a: block/z_max, b: sheet, distance: 0.0101}]}", sheets).ties.counts[0].tied, 25);
  expect_error("{ties: [{a: block/z_max, b: sheet, distance: 0.0099}]}", "ties nothing", sheets);
  const Tied lapped("{ties: [{a: cover, b: sheet, distance: 1e-6}]}", sheets);
  EXPECT_EQ(lapped.ties.counts[0].tied, 16);
  EXPECT_NEAR(lapped.ties.counts[0].farthest, 0.15, 1e-15);
  EXPECT_EQ(describe_ties(lapped.deck, lapped.ties).at(0),
            "16 nodes of 'cover' tied to 'sheet' (up to 0.15 away, 0 beyond the thickness of shells), 0 not in reach");
}

TEST(TiesOfShells, AreToTheFirstSideOfAPartOrToTheSideNamed) {
  for (const auto& [b, side] :
       {std::pair{"sheet", bottom_face}, {"sheet/bottom", bottom_face}, {"sheet/top", top_face}}) {
    const Tied t("{ties: [{a: cover, b: " + std::string(b) + "}]}", sheets);
    EXPECT_EQ(t.ties.counts[0].tied, 16) << b;
    for (const TiedNode& tied : t.ties.nodes) EXPECT_EQ(tied.face % 6, side) << b;
  }
}

TEST(TiesOfShells, KeepContactFromBothSidesOfWhatIsTied) {
  const Tied t("{ties: [{a: cover/bottom, b: sheet/top}]}", sheets);
  EXPECT_EQ(t.ties.faces[0][0].size(), 18U);
  EXPECT_EQ(t.ties.faces[0][1].size(), 32U);
}

TEST(TiesOfShells, TakeTheNodesOfAnEdge) {
  const Tied t("{ties: [{a: strip/x_min, b: sheet}]}", sheets);
  EXPECT_EQ(t.ties.counts[0].tied, 3);
  EXPECT_EQ(t.ties.counts[0].apart, 0);
  EXPECT_EQ(t.ties.faces[0][0].size(), 4U);  // two elements
  // of a part all that is in reach beyond its thickness: no second row, 0.5 away
  EXPECT_EQ(Tied("{ties: [{a: strip, b: sheet}]}", sheets).ties.counts[0].tied, 3);
  expect_error("{ties: [{a: sheet, b: strip/x_min}]}", "'strip/x_min' has no exterior faces", sheets);
}

TEST(TiesOfShells, HoldWhatIsClosestHoweverFineTheMesh) {
  for (const int rows : {5, 10, 40}) {
    const std::string parts = fmt::format(R"(
time: {{end: 1}}
parts:
  base: {{shell_plate: {{size: [2, 2], cells: [4, 4]}}, thickness: 0.08, material: m}}
  web: {{shell_plate: {{size: [1, 0.5], cells: [5, {0}]}}, rotate: [{{axis: x, angle: 90}}], at: [0.5, 1, 0], thickness: 0.04, material: m}}
  pad: {{box: {{size: [0.5, 0.5, 0.05], cells: [2, 2, {0}]}}, at: [0.1, 0.1, 0], material: m}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}}}
)",
                                          rows);
    EXPECT_EQ(Tied("{ties: [{a: web, b: base, distance: 1e-3}]}", parts).ties.counts[0].tied, 6) << rows;
    EXPECT_EQ(Tied("{ties: [{a: pad, b: base, distance: 1e-3}]}", parts).ties.counts[0].tied, 9) << rows;
    // what the distance itself reaches is tied
    EXPECT_EQ(Tied("{ties: [{a: web, b: base, distance: 0.101}]}", parts).ties.counts[0].tied, 6 * (1 + rows / 5))
        << rows;
  }
}

TEST(TiesOfShells, OfOneSideWithTheOtherAreRefused) {
  expect_error("{ties: [{a: sheet/bottom, b: sheet/top}]}", "ties a surface to itself", sheets);
}

}  // namespace
}  // namespace percuss::test
