#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "src/error.hpp"
#include "src/mesh/id_allotment.hpp"
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
  EXPECT_EQ(mesh.element_part, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(mesh.node_sets.at("b"), (std::vector<int>{12, 13, 14, 15, 16, 17, 18, 19}));
  EXPECT_EQ(mesh.side_sets.at("b/x_min"), (std::vector<ElementFace>{{2, 3}}));
  EXPECT_EQ(mesh.elements[2][0], 12);
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

TEST(BuildMesh, NamesTheMaterialOfEachPart) {
  Deck deck = make_deck({make_part_deck("a", SphereShape{1, 3}), make_part_deck("b", SphereShape{1, 3})});
  deck.materials.push_back({"brick", ElasticDeck{2000, 15e9, 0.2}, {}});
  deck.parts[0].material = "brick";
  const Mesh mesh = build_mesh(deck);
  EXPECT_EQ(mesh.parts[0].name, "a");
  EXPECT_EQ(mesh.parts[0].material, 1);
  EXPECT_EQ(mesh.parts[1].material, 0);
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
