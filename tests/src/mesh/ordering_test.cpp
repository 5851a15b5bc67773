#include "src/mesh/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using namespace testing_mesh;

Mesh make_scene() {
  PartDeck ball = make_part_deck("ball", SphereShape{1, 12}),
           bricks = make_part_deck("bricks", BoxShape{{1, 1, 1}, {4, 3, 5}});
  bricks.array = ArrayCopies{{3, 4, 5}, {1.1, 1.1, 1.1}, 0.5};
  bricks.at = {10, 0, 0};
  return build_mesh(make_deck({ball, bricks, make_part_deck("rod", CylinderShape{0.1, 5, 5, 100})}));
}

/// Mesh with elements in another order.
Mesh shuffle_elements(const Mesh& mesh, unsigned seed) {
  std::vector<int> order(mesh.elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  Mesh shuffled = mesh;
  shuffled.side_sets.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto from = static_cast<std::size_t>(order[i]);
    shuffled.elements[i] = mesh.elements[from];
    shuffled.element_ids[i] = mesh.element_ids[from];
    shuffled.element_part[i] = mesh.element_part[from];
  }
  return shuffled;
}

/// What an element is, whatever its number: its id and the places of its corners.
std::vector<std::pair<std::int64_t, HexCorners>> describe_elements(const Mesh& mesh) {
  std::vector<std::pair<std::int64_t, HexCorners>> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    elements.emplace_back(mesh.element_ids[e], corners_of(mesh, e));
  std::sort(elements.begin(), elements.end());
  return elements;
}

std::vector<std::vector<std::int64_t>> list_chunk_ids(const ChunkedMesh& ordered) {
  std::vector<std::vector<std::int64_t>> chunks;
  for (const Chunk& chunk : ordered.chunks) {
    const auto first = ordered.mesh.element_ids.begin() + chunk.first_element;
    chunks.emplace_back(first, first + chunk.element_count);
    std::sort(chunks.back().begin(), chunks.back().end());
  }
  return chunks;
}

TEST(OrderChunks, CoversEveryElementOnceInChunksOfOnePart) {
  const ChunkedMesh ordered = order_chunks(make_scene());
  int next = 0;
  for (const Chunk& chunk : ordered.chunks) {
    EXPECT_EQ(chunk.first_element, next);
    EXPECT_GE(chunk.element_count, 1);
    EXPECT_LE(chunk.element_count, max_chunk_elements);
    next += chunk.element_count;
    for (int e = chunk.first_element; e < next; ++e) {
      ASSERT_EQ(ordered.mesh.element_part[static_cast<std::size_t>(e)], chunk.part);
    }
  }
  EXPECT_EQ(next, static_cast<int>(ordered.mesh.elements.size()));
}

TEST(OrderChunks, KeepsElementsIdsAndSetsTogether) {
  const Mesh mesh = make_scene();
  const ChunkedMesh ordered = order_chunks(mesh);
  EXPECT_EQ(describe_elements(ordered.mesh), describe_elements(mesh));
  for (const auto& [name, faces] : mesh.side_sets) {
    const std::vector<ElementFace>& moved = ordered.mesh.side_sets.at(name);
    EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
    const auto list = [](const Mesh& m, const std::vector<ElementFace>& set) {
      std::vector<std::pair<std::int64_t, int>> ids;
      for (const ElementFace& f : set) ids.emplace_back(m.element_ids[static_cast<std::size_t>(f.element)], f.face);
      std::sort(ids.begin(), ids.end());
      return ids;
    };
    EXPECT_EQ(list(ordered.mesh, moved), list(mesh, faces)) << name;
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    const std::vector<int>& moved = ordered.mesh.node_sets.at(name);
    EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
    const auto list = [](const Mesh& m, const std::vector<int>& set) {
      std::vector<std::pair<std::int64_t, Vec3>> ids;
      for (const int n : set)
        ids.emplace_back(m.node_ids[static_cast<std::size_t>(n)], m.nodes[static_cast<std::size_t>(n)]);
      std::sort(ids.begin(), ids.end());
      return ids;
    };
    EXPECT_EQ(list(ordered.mesh, moved), list(mesh, nodes)) << name;
  }
}

TEST(OrderChunks, NumbersNodesByFirstUse) {
  const ChunkedMesh ordered = order_chunks(make_scene());
  int next = 0;
  for (const auto& element : ordered.mesh.elements) {
    for (const int node : element) {
      ASSERT_LE(node, next);
      if (node == next) ++next;
    }
  }
  EXPECT_EQ(next, static_cast<int>(ordered.mesh.nodes.size()));
}

TEST(OrderChunks, KeepsTheOrderOfElementsWithinAChunk) {
  const ChunkedMesh ordered = order_chunks(make_scene());  // generated ids ascend
  for (const Chunk& chunk : ordered.chunks) {
    const auto first = ordered.mesh.element_ids.begin() + chunk.first_element;
    EXPECT_TRUE(std::is_sorted(first, first + chunk.element_count));
  }
}

TEST(OrderChunks, CutsIntoTheFewestChunksOfNearEqualSize) {
  for (const int cells : {1, 511, 512, 513, 1024, 1025, 7777}) {
    const ChunkedMesh ordered =
        order_chunks(build_mesh(make_deck({make_part_deck("b", BoxShape{{1, 1, 1}, {cells, 1, 1}})})));
    EXPECT_EQ(static_cast<int>(ordered.chunks.size()), (cells + 511) / 512) << cells;
    for (std::size_t c = 0; c < ordered.chunks.size(); ++c) {
      const int count = ordered.chunks[c].element_count, mean = cells / static_cast<int>(ordered.chunks.size());
      // Each level of bisection rounds to the granularity once.
      EXPECT_LT(std::abs(count - mean), 3 * chunk_granularity) << cells;
      if (c + 1 < ordered.chunks.size()) {
        EXPECT_EQ(count % chunk_granularity, 0);
      }
    }
  }
}

TEST(OrderChunks, CutsAcrossTheWidestExtent) {
  const ChunkedMesh ordered =
      order_chunks(build_mesh(make_deck({make_part_deck("b", BoxShape{{1, 9, 1}, {8, 16, 8}})})));
  ASSERT_EQ(ordered.chunks.size(), 2U);
  for (std::size_t e = 0; e < 1024; ++e) {
    const double y = ordered.mesh.nodes[static_cast<std::size_t>(ordered.mesh.elements[e][0])][1];
    EXPECT_EQ(y < 4.49, e < 512);
  }
}

TEST(OrderChunks, PutsTheSameElementsTogetherWhateverTheirOrderInTheInput) {
  const Mesh mesh = make_scene();
  const auto chunks = list_chunk_ids(order_chunks(mesh));
  for (const unsigned seed : {1U, 2U, 3U})
    EXPECT_EQ(list_chunk_ids(order_chunks(shuffle_elements(mesh, seed))), chunks);
}

TEST(OrderChunks, GivesTheSameOrderTwiceAndLeavesAnOrderedMeshAsItIs) {
  const ChunkedMesh once = order_chunks(make_scene()), again = order_chunks(make_scene()),
                    twice = order_chunks(once.mesh);
  EXPECT_EQ(once.mesh.elements, again.mesh.elements);
  EXPECT_EQ(once.mesh.elements, twice.mesh.elements);
  EXPECT_EQ(once.mesh.nodes, twice.mesh.nodes);
  EXPECT_EQ(once.chunks, twice.chunks);
}

TEST(OrderChunks, SplitsElementsWithOneCentreByIndex) {
  Mesh mesh = build_mesh(make_deck({make_part_deck("b", BoxShape{{1, 1, 1}, {1, 1, 1}})}));
  const auto element = mesh.elements[0];
  mesh.elements.assign(600, element);
  mesh.element_part.assign(600, 0);
  mesh.element_ids.resize(600);
  std::iota(mesh.element_ids.begin(), mesh.element_ids.end(), 1);
  const ChunkedMesh ordered = order_chunks(mesh);
  EXPECT_EQ(ordered.chunks.size(), 2U);
  EXPECT_EQ(ordered.mesh.element_ids, mesh.element_ids);
}

TEST(OrderChunks, GivesAnEmptyMeshNoChunks) { EXPECT_TRUE(order_chunks({}).chunks.empty()); }

}  // namespace
}  // namespace percuss
