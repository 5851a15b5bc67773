#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "src/error.hpp"
#include "src/mesh/id_allotment.hpp"
#include "tests/src/mesh/hand_made.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

TEST(BuildMesh, PutsPartsTogetherWithoutMergingNodes) {
  const Mesh mesh = build_mesh(make_deck(
      {make_part_deck("a", BoxShape{{1, 1, 1}, {2, 1, 1}}), make_part_deck("b", BoxShape{{1, 1, 1}, {1, 1, 1}})}));
  EXPECT_EQ(mesh.nodes.size(), 12U + 8);
  EXPECT_EQ(list_parts(mesh.elements), (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(mesh.node_sets.at("b"), (std::vector<int>{12, 13, 14, 15, 16, 17, 18, 19}));
  EXPECT_EQ(mesh.side_sets.at("b/x_min"), (std::vector<ElementFace>{{2, 3}}));
  EXPECT_EQ(mesh.corners(2)[0], 12);
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(BuildMesh, NumbersGeneratedPartsThrough) {
  const Mesh mesh = build_mesh(
      make_deck({make_part_deck("a", BoxShape{{1, 1, 1}, {2, 1, 1}}), make_part_deck("b", SphereShape{1, 4})}));
  const auto expect_counted = [](std::vector<std::int64_t> ids) {
    std::vector<std::int64_t> counted(ids.size());
    std::iota(counted.begin(), counted.end(), 1);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, counted);
  };
  expect_counted(mesh.node_ids);
  expect_counted(mesh.element_ids);
  // Parts in the order of the deck, each as its shape counts.
  const PartMesh ball = make_part_mesh(SphereShape{1, 4});
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.node_ids[n] > 12) {
      EXPECT_EQ(mesh.nodes[n], ball.nodes[static_cast<std::size_t>(mesh.node_ids[n] - 13)]);
    }
  }
}

TEST(BuildMesh, KeepsElementsIdsAndSetsTogether) {
  PartDeck balls = make_part_deck("balls", SphereShape{1, 9});
  balls.array = ArrayCopies{{2, 1, 2}, {3, 0, 2.5}, 0.5};
  balls.rotate.push_back({{0, 1, 0}, 25, {1, 2, 3}});
  balls.at = {0.1, 0.2, 0.3};
  const Mesh mesh = build_mesh(make_deck({make_part_deck("a", BoxShape{{1, 1, 1}, {5, 6, 7}}), balls}));
  PartMesh whole = make_part_mesh(balls.shape);
  place_part(whole, balls);
  add_side_nodes(whole);
  const std::int64_t nodes_before = 6 * 7 * 8, elements_before = 5 * 6 * 7;
  const auto node_of = [&](int n) { return mesh.node_ids[static_cast<std::size_t>(n)] - 1 - nodes_before; };
  const auto element_of = [&](int e) { return mesh.element_ids[static_cast<std::size_t>(e)] - 1 - elements_before; };
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    if (mesh.part_of(static_cast<std::size_t>(e)) != 1) continue;
    for (std::size_t c = 0; c < 8; ++c) {
      const int n = mesh.corners(static_cast<std::size_t>(e))[c];
      ASSERT_EQ(node_of(n), whole.elements.corners(static_cast<std::size_t>(element_of(e)))[c]);
      ASSERT_EQ(mesh.nodes[static_cast<std::size_t>(n)], whole.nodes[static_cast<std::size_t>(node_of(n))]);
    }
  }
  std::vector<std::int64_t> nodes;
  for (const int n : mesh.node_sets.at("balls/surface")) nodes.push_back(node_of(n));
  std::sort(nodes.begin(), nodes.end());
  const std::vector<int>& expected = whole.node_sets.at("surface");
  EXPECT_EQ(nodes, std::vector<std::int64_t>(expected.begin(), expected.end()));
  std::vector<ElementFace> faces;
  for (const ElementFace& f : mesh.side_sets.at("balls/surface")) {
    faces.push_back({static_cast<int>(element_of(f.element)), f.face});
  }
  std::sort(faces.begin(), faces.end());
  EXPECT_EQ(faces, whole.side_sets.at("surface"));
}

TEST(BuildMesh, NamesTheMaterialOfEachPart) {
  Deck deck = make_deck({make_part_deck("a", SphereShape{1, 3}), make_part_deck("b", SphereShape{1, 3})});
  deck.materials.push_back({"brick", 2000, {}, {}, {}, {}, {}});
  deck.parts[0].material = "brick";
  const Mesh mesh = build_mesh(deck);
  EXPECT_EQ(mesh.parts[0].name, "a");
  EXPECT_EQ(mesh.elements.blocks[0].material, 1);
  EXPECT_EQ(mesh.elements.blocks[1].material, 0);
}

TEST(BuildMesh, ReportsTheProblemsOfAllParts) {
  Deck deck = make_deck({make_part_deck("a", BoxShape{{1, 0, 1}, {1, 1, 1}}), make_part_deck("good", SphereShape{1, 3}),
                         make_part_deck("b", SphereShape{1, 3})});
  deck.parts[0].place = {4, 2};
  deck.parts[2].place = {6, 2};
  deck.parts[2].material = "steal";
  EXPECT_THAT([&] { build_mesh(deck); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("deck.yaml:4:2: error: part 'a': element 1 at (0.5, 0, 0.5) has no volume"),
                        HasSubstr("\ndeck.yaml:6:2: error: part 'b': material 'steal'"), Not(HasSubstr("good")))));
}

TEST(BuildMesh, ShowsTenProblemsAndCountsTheRest) {
  const Deck deck = make_deck({make_part_deck("a", BoxShape{{1, -1, 1}, {3, 3, 3}})});
  EXPECT_THAT([&] { build_mesh(deck); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("element 10 "), Not(HasSubstr("element 11 ")),
                                              HasSubstr("is inverted"), HasSubstr("and 17 more"))));
}

TEST(BuildMesh, RefusesAMeshThatRoundOffCollapses) {
  Deck deck = make_deck({make_part_deck("a", SphereShape{1, 3})});
  deck.parts[0].at = {1e20, 0, 0};
  EXPECT_THAT([&] { build_mesh(deck); }, ThrowsMessage<InputError>(HasSubstr("has no volume")));
}

TEST(BuildMesh, RefusesCoordinatesThatAreNotFinite) {
  Deck deck = make_deck({make_part_deck("a", BoxShape{{std::numeric_limits<double>::max(), 1, 1}, {1, 1, 1}})});
  deck.parts[0].at = {std::numeric_limits<double>::max(), 0, 0};
  EXPECT_THAT([&] { build_mesh(deck); }, ThrowsMessage<InputError>(HasSubstr("node 2 lies at (inf")));
}

TEST(BuildMesh, AcceptsAnyUnitOfLength) {
  for (const double unit : {1e-30, 1e-9, 1e6, 1e30}) {
    EXPECT_NO_THROW(build_mesh(make_deck({make_part_deck("a", CylinderShape{unit, 3 * unit, 5, 4})}))) << unit;
  }
}

TEST(BuildMesh, AcceptsFlatAndLongElements) {
  EXPECT_NO_THROW(build_mesh(make_deck({make_part_deck("a", BoxShape{{1, 1, 1e-7}, {3, 3, 1}})})));
  EXPECT_NO_THROW(build_mesh(make_deck({make_part_deck("a", BoxShape{{1e-7, 1e-7, 1}, {3, 3, 1}})})));
}

TEST(BuildMesh, RefusesMoreThanItCanCountBeforeAskingForMemory) {
  EXPECT_THAT(
      [&] {
        build_mesh(make_deck({make_part_deck("a", BoxShape{{1, 1, 1}, {100000, 100000, 1}})}));
      },
      ThrowsMessage<InputError>(HasSubstr("would have 1e+10 elements")));
  Deck deck = make_deck({make_part_deck("a", SphereShape{1, 30})});
  deck.parts[0].array = ArrayCopies{{1000, 1000, 1}, {2, 2, 2}, 0};
  EXPECT_THAT([&] { build_mesh(deck); }, ThrowsMessage<InputError>(HasSubstr("use fewer cells")));
}

TEST(IdAllotment, KeepsTheIdsOfFilesAndCountsOnForTheOthers) {
  IdAllotment ids;
  ids.add({}, 2);
  ids.add({7, 3}, 2);
  ids.add({5, 4}, 2);  // between those of the part before, yet none of them
  ids.add({}, 1);
  ids.assign();
  EXPECT_EQ(ids.first_id(0), 8);
  EXPECT_EQ(ids.ids(1), (std::vector<std::int64_t>{7, 3}));
  EXPECT_EQ(ids.ids(2), (std::vector<std::int64_t>{5, 4}));
  EXPECT_EQ(ids.first_id(3), 10);
  EXPECT_FALSE(ids.raised(1));
  EXPECT_FALSE(ids.raised(2));
}

TEST(IdAllotment, RaisesIdsThatAreTaken) {
  IdAllotment ids;
  ids.add({7, 3}, 2);
  ids.add({9, 3}, 2);
  ids.add({12}, 1);
  ids.assign();
  EXPECT_EQ(ids.ids(0), (std::vector<std::int64_t>{7, 3}));
  EXPECT_EQ(ids.ids(1), (std::vector<std::int64_t>{16, 10}));
  EXPECT_EQ(ids.ids(2), (std::vector<std::int64_t>{12}));
  EXPECT_TRUE(ids.raised(1));
  EXPECT_FALSE(ids.raised(2));
}

}  // namespace
}  // namespace percuss
