// The chunks of parts from files: bisection of element centres.

#include "src/mesh/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

std::vector<std::vector<int>> list_chunks(const ElementOrder& order) {
  std::vector<std::vector<int>> chunks;
  for (std::size_t c = 0; c + 1 < order.first_of_chunk.size(); ++c) {
    chunks.emplace_back(order.elements.begin() + order.first_of_chunk[c],
                        order.elements.begin() + order.first_of_chunk[c + 1]);
  }
  return chunks;
}

TEST(BisectElements, CoversEveryElementOnceInAscendingOrderWithinAChunk) {
  const PartMesh mesh = make_part_mesh(SphereShape{1, 12});
  const ElementOrder order = bisect_elements(mesh);
  for (const std::vector<int>& chunk : list_chunks(order)) {
    EXPECT_GE(chunk.size(), 1U);
    EXPECT_LE(chunk.size(), static_cast<std::size_t>(least_chunk_limit));
    EXPECT_TRUE(std::is_sorted(chunk.begin(), chunk.end()));
  }
  std::vector<int> listed = order.elements, all(mesh.elements.size());
  std::sort(listed.begin(), listed.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(listed, all);
}

TEST(BisectElements, CutsIntoTheFewestChunksOfNearEqualSize) {
  for (const int cells : {1, 63, 64, 65, 128, 129, 7777}) {
    const auto chunks = list_chunks(bisect_elements(make_part_mesh(BoxShape{{1, 1, 1}, {cells, 1, 1}})));
    EXPECT_EQ(static_cast<int>(chunks.size()), (cells + least_chunk_limit - 1) / least_chunk_limit) << cells;
    for (std::size_t c = 0; c < chunks.size(); ++c) {
      const int count = static_cast<int>(chunks[c].size()), mean = cells / static_cast<int>(chunks.size());
      // Each level of bisection rounds to the granularity once.
      EXPECT_LT(std::abs(count - mean), 3 * chunk_granularity) << cells;
      if (c + 1 < chunks.size()) {
        EXPECT_EQ(count % chunk_granularity, 0);
      }
    }
  }
}

TEST(BisectElements, CutsAcrossTheWidestExtent) {
  const PartMesh mesh = make_part_mesh(BoxShape{{1, 9, 1}, {4, 8, 4}});
  const auto chunks = list_chunks(bisect_elements(mesh));
  ASSERT_EQ(chunks.size(), 2U);
  for (const int e : chunks[0]) {
    EXPECT_LT(mesh.nodes[static_cast<std::size_t>(mesh.elements.corners(static_cast<std::size_t>(e))[0])][1], 4.49);
  }
}

TEST(BisectElements, PutsTheSameElementsTogetherWhateverTheirOrderInTheInput) {
  const PartMesh mesh = make_part_mesh(CylinderShape{0.1, 5, 5, 100});
  auto chunks = list_chunks(bisect_elements(mesh));
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::vector<int> order(mesh.elements.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    PartMesh shuffled = mesh;
    shuffled.elements = mesh.elements.select(order);
    auto found = list_chunks(bisect_elements(shuffled));
    for (auto& chunk : found) {
      for (int& e : chunk) e = order[static_cast<std::size_t>(e)];
      std::sort(chunk.begin(), chunk.end());
    }
    EXPECT_EQ(found, chunks);
  }
}

TEST(BisectElements, SplitsElementsWithOneCentreByIndex) {
  PartMesh mesh = make_part_mesh(BoxShape{{1, 1, 1}, {1, 1, 1}});
  mesh.elements = mesh.elements.select(std::vector<int>(100, 0));
  const ElementOrder order = bisect_elements(mesh);
  EXPECT_EQ(order.first_of_chunk.size(), 3U);
  EXPECT_TRUE(std::is_sorted(order.elements.begin(), order.elements.end()));
}

TEST(BisectElements, GivesAnEmptyPartNoChunks) { EXPECT_EQ(bisect_elements({}).first_of_chunk.size(), 1U); }

}  // namespace
}  // namespace percuss
