// Parts that share nodes: merged ones of generated parts, and those of one mesh file; on any number of ranks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <limits>
#include <set>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/mesh/exodus_writer.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

std::size_t position(std::int64_t index) { return static_cast<std::size_t>(index); }

Communicator alone() { return Communicator(MPI_COMM_SELF); }

PartDeck make_box(const std::string& name, double length, int cells, double at_x) {
  PartDeck part = make_part_deck(name, BoxShape{{length, 1, 1}, {cells, 4, 4}});
  part.at = {at_x, 0, 0};
  return part;
}

/// A bar of 32 x 4 x 4 cells cut in three, its middle part with an array of two copies, and a shell on its end.
Deck make_joined_bar() {
  PartDeck middle = make_box("middle", 2, 8, 2);
  middle.array = ArrayCopies{{2, 1, 1}, {100, 0, 0}, 0};
  PartDeck cap = make_part_deck("cap", ShellPlateShape{{1, 1}, {4, 4}});
  cap.rotate.push_back({{0, 1, 0}, -90, {}});
  cap.at = {8, 0, 0};
  cap.thickness = 0.01;
  Deck deck = make_deck({make_box("first", 2, 8, 0), middle, make_box("last", 4, 16, 4), cap});
  deck.joins.push_back({{}, {}, {7, 1}});
  return deck;
}

std::int64_t count_exterior(const ChunkedMesh& chunked) {
  std::int64_t count = 0;
  for (const std::uint8_t mask : chunked.mesh.exterior) count += std::popcount(mask);
  all_reduce(Communicator::world(), Reduce::sum, count);
  return count;
}

TEST(Joints, MergeTheNodesOfPartsThatTouch) {
  const ChunkedMesh share = load_mesh(make_joined_bar(), Communicator::world());
  const std::int64_t bar = 33 * 25, copy = 9 * 25;
  EXPECT_EQ(share.numbering.node_count(), bar + copy);
  ASSERT_EQ(share.mesh.joints.size(), 3U);
  for (const PartJoint& joint : share.mesh.joints) {
    EXPECT_EQ(joint.other, joint.part + 1);
    EXPECT_EQ(joint.nodes, 25);
    EXPECT_LT(joint.farthest, 1e-14);
  }
  const std::int64_t faces = 2 * 16 + 4 * 32 * 4, copy_faces = 2 * 16 + 4 * 8 * 4, cap = 2 * 16;
  EXPECT_EQ(count_exterior(share), faces + copy_faces + cap);
  int bodies = 0;
  for (std::size_t e = 0; e < share.mesh.elements.size(); ++e) {
    bodies = std::max(bodies, share.mesh.bodies[e] + 1);
    const bool is_copy = share.mesh.nodes[position(share.mesh.corners(e)[0])][0] > 50;
    EXPECT_EQ(share.mesh.bodies[e], is_copy ? 1 : 0);
  }
  all_reduce(Communicator::world(), Reduce::largest, bodies);
  EXPECT_EQ(bodies, 2);
}

/// Every rank that holds a node knows all sets and parts that it is in.
TEST(Joints, TellEveryRankTheSetsOfItsNodes) {
  const Deck deck = make_joined_bar();
  const ChunkedMesh whole = load_mesh(deck, alone()), share = load_mesh(deck, Communicator::world());
  ASSERT_EQ(share.mesh.node_sets.size(), whole.mesh.node_sets.size());
  for (const auto& [name, nodes] : whole.mesh.node_sets) {
    std::vector<std::int64_t> expected, told;
    for (const int n : nodes) {
      const std::int64_t number = whole.mesh.node_numbers[position(n)];
      const auto& held = share.mesh.node_numbers;
      if (std::binary_search(held.begin(), held.end(), number)) expected.push_back(number);
    }
    for (const int n : share.mesh.node_sets.at(name)) told.push_back(share.mesh.node_numbers[position(n)]);
    EXPECT_EQ(told, expected) << name;
  }
  EXPECT_EQ(whole.mesh.node_sets.at("first").size(), 9U * 25);
  EXPECT_EQ(whole.mesh.node_sets.at("last").size(), 17U * 25);
  EXPECT_EQ(whole.mesh.node_sets.at("cap").size(), 25U);
}

TEST(Joints, MoveANodeToThatOfTheFirstPart) {
  Deck deck = make_deck({make_box("a", 1, 2, 0), make_box("b", 1, 2, 1.001)});
  deck.joins.push_back({{"a", "b"}, 2e-3, {7, 1}});
  const ChunkedMesh whole = load_mesh(deck, alone());
  EXPECT_EQ(whole.numbering.node_count(), 5 * 25);
  EXPECT_NEAR(whole.mesh.joints.at(0).farthest, 1e-3, 1e-12);
  for (const int n : whole.mesh.node_sets.at("b/x_min")) EXPECT_EQ(whole.mesh.nodes[position(n)][0], 1.0);
  std::set<std::int64_t> ids(whole.mesh.node_ids.begin(), whole.mesh.node_ids.end());
  EXPECT_EQ(ids.size(), whole.mesh.nodes.size());
}

TEST(Joints, LeavePartsApartThatNoneNames) {
  Deck deck = make_deck({make_box("a", 1, 2, 0), make_box("b", 1, 2, 1), make_box("c", 1, 2, 2)});
  deck.joins.push_back({{"b", "c"}, {}, {7, 1}});
  const ChunkedMesh whole = load_mesh(deck, alone());
  EXPECT_EQ(whole.numbering.node_count(), 3 * 25 + 5 * 25);
  ASSERT_EQ(whole.mesh.joints.size(), 1U);
  EXPECT_EQ(whole.mesh.joints[0].part, 1);
}

auto refuses(const Deck& deck, const std::string& text) {
  EXPECT_THAT(
      [&] { load_mesh(deck, Communicator::world()); },
      ThrowsMessage<InputError>(testing::AllOf(testing::StartsWith("deck.yaml:7:1: error: join: "), HasSubstr(text))));
}

TEST(Joints, AreRefusedWhereTheyMergeNothing) {
  Deck deck = make_deck({make_box("a", 1, 2, 0), make_box("b", 1, 2, 1.01)});
  deck.joins.push_back({{"a", "b"}, {}, {7, 1}});
  refuses(deck, "no node of part 'a' lies at a node of the other parts");
}

TEST(Joints, AreRefusedWhereElementsWouldCollapse) {
  Deck deck = make_deck({make_box("a", 1, 2, 0), make_box("b", 1, 2, 1)});
  deck.joins.push_back({{}, 0.3, {7, 1}});
  refuses(deck, "of part 'a' would become one");
  deck.joins[0].tolerance = 1e30;
  refuses(deck, "the tolerance, 1e+30, is larger than elements");
}

/// Parts with a shape that cannot be placed are refused as such.
TEST(Joints, OfPartsFarAwayAreLeftToTheirChecks) {
  Deck deck = make_deck({make_box("a", 1, 2, 0), make_box("b", 1, 2, std::numeric_limits<double>::infinity())});
  deck.joins.push_back({{}, {}, {7, 1}});
  EXPECT_ERROR(load_mesh(deck, Communicator::world()), InputError, "coordinates must be finite");
}

class JoinedFile : public testing::Test {
 protected:
  JoinedFile() {
    WrittenMesh written = make_two_cubes();
    written.node_sets.push_back({9, "across", {1, 5, 12}, {}});
    const Communicator world = Communicator::world();
    if (world.rank() == 0) path_ = write_exodus(written, "joined.exo");
    path_ = broadcast_text(world, path_, 0);
  }
  ~JoinedFile() override {
    Communicator::world().barrier();
    if (Communicator::world().rank() == 0) std::remove(path_.c_str());
  }

  Deck make_scene(double second_at = 0) const {
    PartDeck left = make_part_deck("l", FileMesh{path_, {"left"}, 1, false}),
             right = make_part_deck("r", FileMesh{path_, {"block_20"}, 1, false});
    left.array = right.array = ArrayCopies{{2, 1, 1}, {5, 0, 0}, 0};
    right.at = {second_at, 0, 0};
    return make_deck({left, right});
  }

  std::string path_;
};

TEST_F(JoinedFile, GivesItsPartsTheNodesThatTheyShareAndKeepsItsIds) {
  const ChunkedMesh whole = load_mesh(make_scene(), alone());
  EXPECT_EQ(whole.numbering.node_count(), 24);
  ASSERT_EQ(whole.mesh.joints.size(), 1U);
  EXPECT_EQ(whole.mesh.joints[0].nodes, 8);
  EXPECT_EQ(whole.mesh.joints[0].farthest, 0);
  EXPECT_THAT(whole.mesh.warnings, IsEmpty());
  EXPECT_THAT(whole.mesh.element_ids, ElementsAre(101, 203, 102, 204));
  const std::set<std::int64_t> ids(whole.mesh.node_ids.begin(), whole.mesh.node_ids.end());
  EXPECT_EQ(ids.size(), 24U);
  EXPECT_EQ(*ids.begin(), 1001);
  EXPECT_EQ(*ids.rbegin(), 1012 + 1012);
  EXPECT_EQ(count_exterior(load_mesh(make_scene(), Communicator::world())), 20);
}

TEST_F(JoinedFile, HasSetsThatGoAcrossItsParts) {
  const Deck deck = make_scene();
  const ChunkedMesh whole = load_mesh(deck, alone());
  EXPECT_EQ(select_nodes(whole.mesh, deck, {"across", {}, {}}).size(), 6U);
  EXPECT_EQ(select_nodes(whole.mesh, deck, {"l/across", {}, {}}).size(), 4U);
  EXPECT_EQ(select_faces(whole.mesh, deck, {"sides_6", {}, {}}).size(), 4U);
}

TEST_F(JoinedFile, SharesNothingBetweenPartsThatStandApart) {
  const ChunkedMesh whole = load_mesh(make_scene(0.5), alone());
  EXPECT_EQ(whole.numbering.node_count(), 32);
  EXPECT_THAT(whole.mesh.joints, IsEmpty());
}

TEST_F(JoinedFile, RefusesAnElementOfTwoParts) {
  Deck deck = make_scene();
  std::get<FileMesh>(deck.parts[1].shape).blocks = {};
  EXPECT_THAT([&] { load_mesh(deck, Communicator::world()); },
              ThrowsMessage<InputError>(HasSubstr("element 101 of the file is in another part as well")));
}

}  // namespace
}  // namespace percuss
