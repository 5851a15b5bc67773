#include "src/contact/surface/surface_sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace percuss {
namespace {

using Corners = std::array<int, 4>;

/// Bottom and top of each shell, so that the sides of shell e are faces 2 e and 2 e + 1.
struct Shells {
  explicit Shells(const std::vector<Corners>& elements) {
    int nodes = 0;
    for (const Corners& e : elements) {
      corners.push_back({e[0], e[3], e[2], e[1]});
      corners.push_back(e);
      nodes = std::max(nodes, *std::max_element(e.begin(), e.end()) + 1);
    }
    offset.assign(corners.size(), 0.5);
    around.first.push_back(0);
    for (int n = 0; n < nodes; ++n) {
      for (std::size_t f = 0; f < corners.size(); ++f)
        if (std::count(corners[f].begin(), corners[f].end(), n) > 0) around.items.push_back(static_cast<int>(f));
      around.first.push_back(static_cast<int>(around.items.size()));
    }
  }

  /// The ring of a face around a node, ascending.
  std::vector<int> ring(int face, int node) const {
    const SideRings rings = find_side_rings(corners, offset, around);
    const Corners& c = corners[static_cast<std::size_t>(face)];
    const auto corner = std::find(c.begin(), c.end(), node) - c.begin();
    const auto row = static_cast<std::size_t>(4 * face + corner);
    std::vector<int> found(rings.faces.begin() + rings.first[row], rings.faces.begin() + rings.first[row + 1]);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Whether the shell ends at a node of a face.
  bool ends(int face, int node) const {
    const Corners& c = corners[static_cast<std::size_t>(face)];
    const auto corner = std::find(c.begin(), c.end(), node) - c.begin();
    return find_side_rings(corners, offset, around).is_open[static_cast<std::size_t>(4 * face + corner)] != 0;
  }

  std::vector<Corners> corners;
  std::vector<double> offset;
  Buckets around;
};

TEST(SurfaceSides, GoAroundANodeOfAPlateOnOneSideOnly) {
  // Four shells around node 4 of a 3 x 3 grid; the last is upside down.
  const Shells plate({{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 7, 8, 5}});
  EXPECT_EQ(plate.ring(1, 4), (std::vector<int>{3, 5, 6}));
  EXPECT_EQ(plate.ring(0, 4), (std::vector<int>{2, 4, 7}));
  EXPECT_EQ(plate.ring(6, 4), (std::vector<int>{1, 3, 5}));
  EXPECT_FALSE(plate.ends(1, 4));
}

TEST(SurfaceSides, EndWhereAShellEnds) {
  const Shells strip({{0, 1, 4, 3}, {1, 2, 5, 4}});
  EXPECT_EQ(strip.ring(1, 1), (std::vector<int>{3}));
  EXPECT_EQ(strip.ring(1, 0), (std::vector<int>{}));
  for (const int node : {0, 1, 3, 4}) EXPECT_TRUE(strip.ends(1, node));
}

TEST(SurfaceSides, EndWhereThreeShellsMeet) {
  const Shells junction({{0, 1, 4, 3}, {1, 2, 5, 4}, {1, 4, 7, 6}});
  EXPECT_EQ(junction.ring(1, 1), (std::vector<int>{}));
  EXPECT_TRUE(junction.ends(1, 1));  // at the edge to node 0
}

TEST(SurfaceSides, OfSolidsAreAllFacesAroundANode) {
  Shells cube({{0, 1, 2, 3}, {0, 4, 5, 1}});
  std::fill(cube.offset.begin(), cube.offset.end(), 0);
  EXPECT_EQ(cube.ring(0, 0), (std::vector<int>{1, 2, 3}));
}

}  // namespace
}  // namespace percuss
