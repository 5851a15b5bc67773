#include "src/mesh/topology/connectivity.hpp"

#include <gtest/gtest.h>

#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

std::vector<ElementFace> list_exterior_faces(const PartMesh& part) {
  Mesh mesh;
  mesh.elements = part.elements;
  mesh.exterior = mark_exterior_faces(part.elements, part.nodes.size());
  return find_exterior_faces(mesh);
}

std::vector<int> count_bodies(const PartMesh& part) { return find_bodies(part.elements, part.nodes.size()); }

TEST(ExteriorFaces, OfABoxAreItsSixSides) {
  const std::vector<ElementFace> faces = list_exterior_faces(make_part_mesh(BoxShape{{1, 1, 1}, {5, 4, 3}}));
  EXPECT_EQ(faces.size(), 2U * (5 * 4 + 4 * 3 + 5 * 3));
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
}

TEST(ExteriorFaces, OfPartsThatTouchAreThoseOfEach) {
  PartDeck left = make_part_deck("left", BoxShape{{1, 1, 1}, {2, 2, 2}}), right = left;
  right.name = "right";
  right.at = {1, 0, 0};
  EXPECT_EQ(find_exterior_faces(build_mesh(make_deck({left, right}))).size(), 2U * 24);
}

TEST(ExteriorFaces, ReappearWhereAnElementIsMissing) {
  PartMesh mesh = make_part_mesh(BoxShape{{1, 1, 1}, {3, 3, 3}});
  std::vector<int> others;
  for (int e = 0; e < 27; ++e)
    if (e != 13) others.push_back(e);  // the one in the middle
  mesh.elements = mesh.elements.select(others);
  EXPECT_EQ(list_exterior_faces(mesh).size(), 54U + 6);
}

TEST(Bodies, AreCountedFromTheLowestElement) {
  PartDeck row = make_part_deck("row", BoxShape{{1, 1, 1}, {2, 1, 1}});
  row.array = ArrayCopies{{3, 1, 1}, {1, 0, 0}, 0};  // copies touch, yet share no node
  const std::vector<int> bodies = build_mesh(make_deck({row, make_part_deck("ball", SphereShape{1, 3})})).bodies;
  const std::vector<int> first(bodies.begin(), bodies.begin() + 6);
  EXPECT_EQ(first, (std::vector<int>{0, 0, 1, 1, 2, 2}));
  for (std::size_t e = 6; e < bodies.size(); ++e) EXPECT_EQ(bodies[e], 3);
}

TEST(Bodies, JoinedByASingleNodeAreOne) {
  PartMesh mesh = make_part_mesh(BoxShape{{2, 2, 2}, {2, 2, 2}});
  mesh.elements = mesh.elements.select(std::array{0, 7});  // opposite corners share the node in the middle
  EXPECT_EQ(count_bodies(mesh), (std::vector<int>{0, 0}));
}

TEST(Bodies, MeetingLateAreOne) {
  PartMesh mesh = make_part_mesh(BoxShape{{5, 1, 1}, {5, 1, 1}});
  mesh.elements = mesh.elements.select(std::array{4, 0, 2, 1});
  EXPECT_EQ(count_bodies(mesh), (std::vector<int>{0, 1, 1, 1}));
}

}  // namespace
}  // namespace percuss
