// Chunks that lie next to each other are tied in the graph of the decomposition.

#include "src/mesh/decomposition/near_chunks.hpp"

#include <gtest/gtest.h>

namespace percuss::test {
namespace {

/// A brick of cells of edge 1 at a place, all of its surface exterior.
ChunkBox make_brick(const Vec3& low, int nx, int ny, int nz) {
  return {low, {low[0] + nx, low[1] + ny, low[2] + nz}, 2 * (nx * ny + ny * nz + nz * nx)};
}

TEST(NearChunks, BricksFaceToFaceAreTiedByTheFacesBetweenThem) {
  // Two bricks of 4 x 3 x 2 side by side, 3 x 2 faces against each other: widened by a face, 4 x 3 are counted at most.
  const std::vector<GraphEdge> edges =
      add_near_chunks({make_brick({0, 0, 0}, 4, 3, 2), make_brick({4, 0, 0}, 4, 3, 2)}, {});
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].a, 0);
  EXPECT_EQ(edges[0].b, 1);
  EXPECT_GE(edges[0].weight, 6 * near_face_weight);
  EXPECT_LE(edges[0].weight, 12 * near_face_weight);
}

TEST(NearChunks, ThoseFartherApartThanAFaceAreNot) {
  EXPECT_TRUE(add_near_chunks({make_brick({0, 0, 0}, 4, 3, 2), make_brick({5.01, 0, 0}, 4, 3, 2)}, {}).empty());
  EXPECT_EQ(add_near_chunks({make_brick({0, 0, 0}, 4, 3, 2), make_brick({4.99, 0, 0}, 4, 3, 2)}, {}).size(), 1u);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 low{0, 0, 0};
    low[axis] = 10;
    EXPECT_TRUE(add_near_chunks({make_brick({0, 0, 0}, 4, 3, 2), make_brick(low, 4, 3, 2)}, {}).empty()) << axis;
  }
}

TEST(NearChunks, ThoseThatShareNodesAreTiedByTheseAlone) {
  const std::vector<GraphEdge> shared{{0, 2, 12}};
  const std::vector<GraphEdge> edges = add_near_chunks(
      {make_brick({0, 0, 0}, 4, 3, 2), make_brick({0, 0, 2}, 4, 3, 2), make_brick({4, 0, 0}, 4, 3, 2)}, shared);
  ASSERT_EQ(edges.size(), 3u);  // ascending
  EXPECT_EQ(edges[0].b, 1);
  EXPECT_EQ(edges[1], shared[0]);
  EXPECT_EQ(edges[2].a, 1);
}

TEST(NearChunks, ThoseOfOneBodyAreNot) {
  // A tube of four chunks in a ring, by shared nodes one body: opposite ones lie next to each other.
  const std::vector<GraphEdge> ring{{0, 1, 9}, {1, 2, 9}, {2, 3, 9}};
  const std::vector<ChunkBox> chunks(4, make_brick({0, 0, 0}, 4, 3, 2));
  EXPECT_EQ(add_near_chunks(chunks, ring), ring);
  EXPECT_EQ(add_near_chunks(chunks, {ring[0], ring[2]}).size(), 6u);  // two bodies: each of one with each of the other
}

TEST(NearChunks, WeightsThatNoIntHoldsTogetherAreLeftOut) {
  ChunkBox large = make_brick({0, 0, 0}, 4, 3, 2);
  large.faces = 2'000'000'000;
  EXPECT_TRUE(add_near_chunks({large, large}, {}).empty());
}

TEST(NearChunks, ThoseWithoutSurfaceTouchNothing) {
  ChunkBox inside = make_brick({1, 1, 1}, 2, 2, 2);
  inside.faces = 0;
  EXPECT_TRUE(add_near_chunks({make_brick({0, 0, 0}, 4, 4, 4), inside}, {}).empty());
}

TEST(NearChunks, BoxesThatAllMeetSayNothing) {
  std::vector<ChunkBox> chunks;
  for (int c = 0; c < 400; ++c) chunks.push_back(make_brick({0.001 * c, 0, 0}, 4, 3, 2));
  const std::vector<GraphEdge> shared{{3, 5, 2}};
  EXPECT_EQ(add_near_chunks(chunks, shared), shared);
}

}  // namespace
}  // namespace percuss::test
