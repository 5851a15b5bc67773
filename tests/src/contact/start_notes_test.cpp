// Notes of contact on the start: the smallest gaps between parts.

#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"

namespace percuss::test {
namespace {

std::vector<std::string> find_notes(const std::string& contact) {
  const Deck deck = parse_deck(R"(
time: {end: 1}
parts:
  a: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, material: m}
  b: {box: {size: [3, 2, 2], cells: [3, 3, 3]}, at: [2.01, 0, 0], material: m}
  c: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, at: [2.01, 0, 2], material: m}
  far: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, at: [20, 0, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)" + ("contact: " + contact),
                               "deck.yaml");
  const ChunkedMesh chunked = load_mesh(deck, Communicator::world());
  ContactStage stage(chunked, deck, Communicator::world());
  const Rows3<double> x = to_rows("test::x", chunked.mesh.nodes), v("test::v", chunked.mesh.nodes.size());
  stage.prepare(x, v);
  return stage.start_notes();
}

TEST(StartNotes, TellTheSmallestGapsOfPartsWithinReach) {
  const std::vector<std::string> notes = find_notes("{surfaces: all}");
  ASSERT_EQ(notes.size(), 1U);
  // a and c are 0.01 apart, too: corner to edge
  EXPECT_EQ(notes[0],
            "smallest gaps: 0 (they touch) between 'b' and 'c', 0.01 between 'a' and 'b', 0.01 between 'a' and 'c'");
}

TEST(StartNotes, TellOfPairsThatMayTouchOnly) {
  const std::vector<std::string> notes = find_notes("{surfaces: [[a, b], [a, far]]}");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "smallest gaps: 0.01 between 'a' and 'b'");
}

TEST(StartNotes, TellOfTiesWithoutContact) {
  const std::vector<std::string> notes = find_notes("{surfaces: none, ties: [{a: b/x_min, b: a}]}");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "16 nodes of 'b/x_min' tied to 'a' (up to 0.01 away), 0 not in reach");
}

}  // namespace
}  // namespace percuss::test
