#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "src/mesh/surface_nodes.hpp"
#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

using Box = std::array<Vec3, 2>;

Box box(const Vec3& low, const Vec3& high) { return {low, high}; }

class Select : public testing::Test {
 protected:
  Select() {
    PartDeck rod = make_part_deck("rod", CylinderShape{0.5, 2, 4, 3});
    rod.at = {10, 0, 0};
    deck_ = make_deck({make_part_deck("block", BoxShape{{1, 1, 1}, {4, 4, 4}}), rod});
    mesh_ = build_mesh(deck_);
  }

  std::vector<int> nodes(const std::string& name, std::optional<Box> inside = {}) const {
    return select_nodes(mesh_, deck_, {name, inside, {7, 9}});
  }
  std::vector<ElementFace> faces(const std::string& name, std::optional<Box> inside = {}) const {
    return select_faces(mesh_, deck_, {name, inside, {7, 9}});
  }

  Deck deck_;
  Mesh mesh_;
};

TEST_F(Select, NodesOfTheWholeMeshAPartOrASide) {
  EXPECT_EQ(nodes("").size(), mesh_.nodes.size());
  EXPECT_EQ(nodes("block").size(), 125U);
  EXPECT_EQ(nodes("block/x_max").size(), 25U);
  EXPECT_EQ(nodes("block").size() + nodes("rod").size(), mesh_.nodes.size());
}

TEST_F(Select, NodesInsideABoxItsFacesIncluded) {
  EXPECT_EQ(nodes("block", box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})).size(), 8U);
  EXPECT_EQ(nodes("block", box({0.25 + 1e-13, -1, -1}, {0.5 - 1e-13, 2, 2})).size(), 50U);
  EXPECT_EQ(nodes("", box({-1, -1, -1}, {100, 100, 0})).size(), 25U + nodes("rod/start").size());
  EXPECT_EQ(nodes("block/x_max", box({0, 0, 0}, {1, 1, 0})).size(), 5U);
}

TEST_F(Select, FacesOfTheWholeMeshAPartOrASide) {
  EXPECT_EQ(faces(""), find_exterior_faces(mesh_));
  EXPECT_EQ(faces("block").size(), 96U);
  EXPECT_EQ(faces("block/z_min"), mesh_.side_sets.at("block/z_min"));
  EXPECT_EQ(faces("block").size() + faces("rod").size(), faces("").size());
}

TEST_F(Select, FacesWithAllCornersInsideABox) {
  EXPECT_EQ(faces("block", box({0, 0, 0}, {0.5, 0.5, 0.5})).size(), 12U);
  EXPECT_EQ(faces("block/x_min", box({-1, 0, 0}, {1, 0.6, 1})).size(), 8U);
}

TEST_F(Select, OnlyExteriorFacesOfASideSet) {
  mesh_.side_sets["block/cut"] = {{0, 1}, {0, 3}};  // the first lies between two elements
  EXPECT_EQ(faces("block/cut"), (std::vector<ElementFace>{{0, 3}}));
}

TEST_F(Select, ASetWithoutItsPartWhereOnlyOneHasIt) {
  EXPECT_EQ(nodes("z_min"), nodes("block/z_min"));
  EXPECT_EQ(faces("end"), faces("rod/end"));
  mesh_.node_sets["rod/z_min"] = {0};
  EXPECT_THAT(
      [&] { nodes("z_min"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("deck.yaml:7:9"), HasSubstr("block/z_min"), HasSubstr("rod/z_min"))));
}

TEST_F(Select, RefusesUnknownNamesWithTheNearest) {
  EXPECT_THAT([&] { nodes("blok"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("deck.yaml:7:9: error: "), HasSubstr("'block'"))));
  EXPECT_THAT([&] { faces("rod/stat"); }, ThrowsMessage<InputError>(HasSubstr("'rod/start'")));
}

TEST_F(Select, RefusesANodeSetWhereFacesAreNeeded) {
  mesh_.node_sets["block/corner"] = {0};
  EXPECT_THAT([&] { faces("block/corner"); }, ThrowsMessage<InputError>(HasSubstr("it is a node set")));
}

TEST_F(Select, NodesOfASurfaceOrOfASetWithTheFacesAroundThem) {
  const auto select = [&](const std::string& name) { return select_surface_nodes(mesh_, deck_, {name, {}, {7, 9}}); };
  const SurfaceNodes side = select("block/x_max");
  EXPECT_FALSE(side.is_node_set);
  EXPECT_EQ(side.nodes, nodes("block/x_max"));
  EXPECT_EQ(side.faces, faces("block/x_max"));
  const int corner = nodes("block", box({1, 1, 1}, {1, 1, 1})).at(0);
  mesh_.node_sets["block/spot"] = {corner};
  mesh_.side_sets["block/spot"] = {};  // as the edge of a shell: a side without faces
  for (const char* name : {"block/spot", "spot"}) {
    const SurfaceNodes spot = select(name);
    EXPECT_TRUE(spot.is_node_set);
    EXPECT_EQ(spot.nodes, std::vector<int>{corner});
    EXPECT_EQ(spot.faces.size(), 3U);
  }
}

TEST_F(Select, RefusesAnEmptySelection) {
  EXPECT_THAT(
      [&] {
        nodes("block", box({5, 5, 5}, {6, 6, 6}));
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("deck.yaml:7:9: error: "), HasSubstr("no nodes inside the box"))));
  EXPECT_THAT(
      [&] {
        faces("", box({0, 0, 0}, {0.1, 0.1, 0.1}));
      },
      ThrowsMessage<InputError>(HasSubstr("the mesh has no exterior faces inside")));
}

}  // namespace
}  // namespace percuss
