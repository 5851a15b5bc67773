// The chunks of generated parts: boxes of cells, cut by index.

#include "src/mesh/shapes/tiling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "src/mesh/ordering.hpp"

namespace percuss {
namespace {

std::array<int, 3> count_tiles(const std::array<int, 3>& cells, const Vec3& edges = {1, 1, 1},
                               int limit = least_chunk_limit) {
  return choose_tiles({0, cells, {1, cells[0], cells[0] * cells[1]}, edges}, limit).counts;
}

TEST(ChooseTiles, MakesCubesOfFourCells) {
  EXPECT_EQ(count_tiles({16, 16, 16}), (std::array<int, 3>{4, 4, 4}));
  EXPECT_EQ(count_tiles({100, 200, 40}), (std::array<int, 3>{25, 50, 10}));
}

TEST(ChooseTiles, MakesLargerTilesWhereTheyMayBeLarger) {
  EXPECT_EQ(count_tiles({64, 64, 64}, {1, 1, 1}, 512), (std::array<int, 3>{8, 8, 8}));
  EXPECT_EQ(count_tiles({16, 16, 32}, {1, 1, 1}, 128), (std::array<int, 3>{4, 4, 4}));
}

TEST(ChunkLimit, GrowsWithThePartSoThatItHasEnoughChunks) {
  EXPECT_EQ(find_chunk_limit(1), 64);
  EXPECT_EQ(find_chunk_limit(262'143), 64);
  EXPECT_EQ(find_chunk_limit(262'144), 128);
  EXPECT_EQ(find_chunk_limit(1'000'000), 256);
  EXPECT_EQ(find_chunk_limit(1'048'576), 512);
  EXPECT_EQ(find_chunk_limit(std::int64_t{1} << 40), 512);
}

TEST(ChooseTiles, KeepsWhatFitsWhole) {
  EXPECT_EQ(count_tiles({6, 3, 3}), (std::array<int, 3>{1, 1, 1}));
  EXPECT_EQ(count_tiles({4, 4, 4}), (std::array<int, 3>{1, 1, 1}));
}

TEST(ChooseTiles, FollowsTheFormOfThinBlocks) {
  EXPECT_EQ(count_tiles({32, 32, 1}), (std::array<int, 3>{4, 4, 1}));
  EXPECT_EQ(count_tiles({2, 2, 160}), (std::array<int, 3>{1, 1, 10}));
}

TEST(ChooseTiles, PrefersTheLeastSurfaceAmongNearEqualCuts) {
  // 8 x 8 x 1 cells each way, the same number of node copies: the long direction is the one to cut.
  EXPECT_EQ(count_tiles({1, 16, 8}, {1, 4, 1}), (std::array<int, 3>{1, 2, 1}));
  EXPECT_EQ(count_tiles({8, 16, 1}, {1, 4, 1}), (std::array<int, 3>{1, 2, 1}));
}

struct PartCase {
  Shape shape;
  int copies;
};

class PartTilingOf : public testing::TestWithParam<PartCase> {};

TEST_P(PartTilingOf, ListsEveryElementOnceInChunksOfTheirSize) {
  const auto source = make_source(GetParam().shape);
  const PartTiling tiling(*source, GetParam().copies);
  std::set<std::pair<int, int>> seen;
  int last_copy = 0;
  for (int c = 0; c < tiling.chunk_count(); ++c) {
    const std::vector<SourceElement> elements = tiling.list_elements(c);
    EXPECT_EQ(static_cast<int>(elements.size()), tiling.count_elements(c));
    EXPECT_GE(elements.size(), 1U);
    EXPECT_LE(elements.size(), static_cast<std::size_t>(least_chunk_limit));
    for (const SourceElement& e : elements) {
      EXPECT_TRUE(seen.emplace(e.copy, e.element).second);
      EXPECT_GE(e.copy, last_copy) << "bodies are counted in the order of copies";
      last_copy = e.copy;
    }
  }
  EXPECT_EQ(seen.size(),
            static_cast<std::size_t>(source->element_count()) * static_cast<std::size_t>(GetParam().copies));
  EXPECT_EQ(seen.rbegin()->second, source->element_count() - 1);
}

INSTANTIATE_TEST_SUITE_P(
    Parts, PartTilingOf,
    testing::Values(PartCase{BoxShape{{1, 1, 1}, {1, 1, 1}}, 1}, PartCase{BoxShape{{1, 1, 1}, {1, 1, 1}}, 1000},
                    PartCase{BoxShape{{1, 1, 1}, {3, 3, 3}}, 7}, PartCase{BoxShape{{0.2, 0.1, 0.06}, {6, 3, 3}}, 140},
                    PartCase{BoxShape{{1, 2, 3}, {13, 17, 19}}, 2}, PartCase{CylinderShape{0.05, 0.4, 5, 40}, 1},
                    PartCase{CylinderShape{0.05, 0.4, 3, 1}, 5}, PartCase{SphereShape{1, 3}, 20},
                    PartCase{SphereShape{1, 13}, 2}, PartCase{TubeShape{1, 2, 3, {2, 31, 11}, 180}, 3},
                    PartCase{TubeShape{1, 1.1, 3, {1, 100, 50}}, 1}));

TEST(PartTiling, LetsSmallCopiesShareAChunk) {
  EXPECT_EQ(PartTiling(*make_source(BoxShape{{1, 1, 1}, {2, 2, 2}}), 80).chunk_count(), 10);
  EXPECT_EQ(PartTiling(*make_source(BoxShape{{1, 1, 1}, {4, 4, 2}}), 9).chunk_count(), 5);
  EXPECT_EQ(PartTiling(*make_source(BoxShape{{1, 1, 1}, {6, 3, 3}}), 9).chunk_count(), 9);
}

}  // namespace
}  // namespace percuss
