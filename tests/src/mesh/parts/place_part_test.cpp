#include <gtest/gtest.h>

#include <cmath>

#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

PartDeck make_brick_deck() { return make_part_deck("p", BoxShape{{1, 2, 3}, {1, 1, 1}}); }

std::vector<Vec3> place(const PartDeck& part) {
  PartMesh mesh = make_part_mesh(part.shape);
  place_part(mesh, part);
  return mesh.nodes;
}

TEST(PlacePart, TranslatesByAt) {
  PartDeck part = make_brick_deck();
  part.at = {10, 20, 30};
  EXPECT_EQ(place(part).front(), (Vec3{10, 20, 30}));
  EXPECT_EQ(place(part).back(), (Vec3{11, 22, 33}));
}

TEST(PlacePart, QuarterTurnsAreExact) {
  PartDeck part = make_brick_deck();
  part.rotate.push_back({{0, 1, 0}, 90, {}});  // what `axis: x` means: local z onto x
  EXPECT_EQ(place(part).back(), (Vec3{3, 2, -1}));
  part.rotate.assign(1, {{0, 0, 1}, 90, {}});
  EXPECT_EQ(place(part).back(), (Vec3{-2, 1, 3}));
  part.rotate.assign(1, {{0, 0, 1}, -90, {}});
  EXPECT_EQ(place(part).back(), (Vec3{2, -1, 3}));
  part.rotate.assign(1, {{1, 0, 0}, 180, {}});
  EXPECT_EQ(place(part).back(), (Vec3{1, -2, -3}));
  part.rotate.assign(1, {{1, 0, 0}, 360, {}});
  EXPECT_EQ(place(part).back(), (Vec3{1, 2, 3}));
}

TEST(PlacePart, RotationsApplyInOrderAboutTheirCentersAndBeforeAt) {
  PartDeck part = make_brick_deck();
  part.rotate.push_back({{0, 0, 1}, 90, {1, 0, 0}});  // (1, 2, 3) -> (-1, 0, 3)
  part.rotate.push_back({{1, 0, 0}, 90, {}});         // -> (-1, -3, 0)
  part.at = {100, 0, 0};
  EXPECT_EQ(place(part).back(), (Vec3{99, -3, 0}));
}

TEST(PlacePart, AThirdTurnAboutTheCubeDiagonalPermutesTheAxes) {
  PartDeck part = make_brick_deck();
  const double s = 1 / std::sqrt(3.0);
  part.rotate.push_back({{s, s, s}, 120, {}});  // x -> y -> z -> x
  const Vec3 corner = place(part).back();
  EXPECT_NEAR(corner[0], 3, 1e-14);
  EXPECT_NEAR(corner[1], 1, 1e-14);
  EXPECT_NEAR(corner[2], 2, 1e-14);
}

TEST(PlacePart, ArraysShiftOddCoursesAlongY) {
  PartDeck part = make_part_deck("bricks", BoxShape{{0.2, 0.1, 0.06}, {6, 3, 3}});
  part.array = ArrayCopies{{1, 10, 14}, {0.2, 0.1, 0.06}, 0.5};
  const Mesh mesh = build_mesh(make_deck({part}));
  EXPECT_EQ(mesh.elements.size(), 140U * 54);
  const std::vector<int>& bodies = mesh.bodies;
  EXPECT_EQ(bodies.back(), 139);
  const auto first_node = [&](int j, int k) {
    return mesh.nodes[static_cast<std::size_t>(mesh.corners(static_cast<std::size_t>(54 * (j + 10 * k)))[0])];
  };
  for (int k = 0; k < 14; ++k) {
    for (int j = 0; j < 10; ++j) {
      EXPECT_EQ(first_node(j, k)[0], 0);
      EXPECT_DOUBLE_EQ(first_node(j, k)[1], 0.1 * (j + (k % 2 == 1 ? 0.5 : 0)));
      EXPECT_DOUBLE_EQ(first_node(j, k)[2], 0.06 * k);
    }
  }
}

TEST(PlacePart, ArraysOfOneRowAlongYShiftAlongX) {
  PartDeck part = make_brick_deck();
  part.array = ArrayCopies{{2, 1, 2}, {1.5, 2, 4}, 0.5};
  const std::vector<Vec3> nodes = place(part);
  EXPECT_EQ(nodes[8], (Vec3{1.5, 0, 0}));
  EXPECT_EQ(nodes[16], (Vec3{0.75, 0, 4}));
  EXPECT_EQ(nodes[24], (Vec3{2.25, 0, 4}));
}

TEST(PlacePart, SidesOfAnArrayAreThoseOfAllCopies) {
  PartDeck part = make_brick_deck();
  part.array = ArrayCopies{{3, 1, 1}, {2, 0, 0}, 0};
  const Mesh mesh = build_mesh(make_deck({part}));
  EXPECT_EQ(mesh.side_sets.at("p/x_min"), (std::vector<ElementFace>{{0, 3}, {1, 3}, {2, 3}}));
  EXPECT_EQ(mesh.node_sets.at("p/x_min").size(), 12U);
  for (const int n : mesh.node_sets.at("p/x_min"))
    EXPECT_EQ(std::fmod(mesh.nodes[static_cast<std::size_t>(n)][0], 2), 0);
  EXPECT_EQ(join_side_sets(mesh), find_exterior_faces(mesh));
}

TEST(PlacePart, CopiesCountOnFromTheIdsOfTheFile) {
  PartMesh mesh = make_part_mesh(BoxShape{{1, 1, 1}, {2, 1, 1}});
  mesh.element_ids = {70, 50};
  mesh.node_ids.assign(12, 0);
  for (std::size_t n = 0; n < 12; ++n) mesh.node_ids[n] = static_cast<std::int64_t>(100 - n);
  PartDeck part = make_brick_deck();
  part.array = ArrayCopies{{2, 1, 1}, {2, 0, 0}, 0};
  place_part(mesh, part);
  EXPECT_EQ(mesh.element_ids, (std::vector<std::int64_t>{70, 50, 71, 72}));
  EXPECT_EQ(mesh.node_ids[12], 101);
  EXPECT_EQ(mesh.node_ids[23], 112);
}

}  // namespace
}  // namespace percuss
