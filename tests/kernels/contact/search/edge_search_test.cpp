// Pairs of edges of all kinds: by either method those of brute force.

#include "kernels/contact/search/edge_search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::edge_search_test {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Random edges in chains of four, of three parts, each of one to three pieces. kinds: EdgeSurface::is_blunt below
/// this.
struct RandomEdges {
  RandomEdges(unsigned seed, int count, int kinds) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-2, 2), length(0.2, 2);
    std::uniform_int_distribution<int> kind(0, kinds - 1), part(0, 2), piece(1, 3);
    std::vector<std::array<int, 2>> ends;
    std::vector<std::array<int, 4>> wings;
    std::vector<std::array<std::int64_t, 2>> elements;
    std::vector<int> blunt, pieces, first{0}, edge_of_point;
    std::vector<EdgeScale> scales;
    for (int e = 0; e < count; ++e) {
      const int node = e + e / 4;
      ends.push_back({node, node + 1});
      wings.push_back({node, node + 1, node, node + 1});
      elements.push_back({2 * e, 2 * e + 1});
      blunt.push_back(kind(random));
      scales.push_back({part(random), blunt.back() == warped_ridge ? 0 : length(random)});
      pieces.push_back(piece(random));
      edge_of_point.insert(edge_of_point.end(), static_cast<std::size_t>(pieces.back()), e);
      first.push_back(first.back() + pieces.back());
    }
    for (int n = 0; n < count + count / 4 + 1; ++n)
      x.push_back({coordinate(random), coordinate(random), 0.1 * coordinate(random)});
    surface.num_edges = count;
    surface.ends = percuss::to_rows("test::ends", ends);
    surface.wings = percuss::to_rows("test::wings", wings);
    surface.elements = percuss::to_rows("test::elements", elements);
    surface.edge_class = to_array(std::vector<int>(ends.size(), 0));
    surface.pair_friction = to_array(std::vector<double>{0.1});
    surface.is_blunt = to_array(blunt);
    if (kinds > smooth_line) surface.scale = to_array(scales);
    points = {first.back(), surface.ends, to_array(pieces), to_array(first)};
    std::vector<int> all(edge_of_point.size()), edges(ends.size());
    std::iota(all.begin(), all.end(), 0);
    std::iota(edges.begin(), edges.end(), 0);
    const Rows3<double> rows = to_rows(x), places("test::places", all.size());
    const Boxes boxes("test::boxes", ends.size());
    place_edge_points(SmallSpace(), points, rows, places);
    bound_edges(SmallSpace(), surface.ends, {rows, rows, 0}, {0.1, 0.1, 0.1}, boxes);
    query = {{to_array(edge_of_point), to_array(first), to_array(all), to_array(edges)}, places, rows, boxes, {}};
  }

  bool is_pair(int a, int b) const {
    bool has_point = false;
    for (int p = points.first_point(a); p < points.first_point(a + 1); ++p) {
      bool is_inside = true;
      for (int k = 0; k < 3; ++k)
        is_inside = is_inside && query.places(p, k) >= query.boxes(b, k) && query.places(p, k) <= query.boxes(b, k + 3);
      has_point = has_point || is_inside;
    }
    return has_point && may_meet(surface, a, b) && !are_joined(surface, a, b);
  }

  Pairs find_by_brute_force() const {
    Pairs pairs;
    for (int a = 0; a < surface.num_edges; ++a)
      for (int b = a + 1; b < surface.num_edges; ++b)
        if (is_pair(a, b)) pairs.emplace_back(a, b);
    return pairs;
  }

  std::vector<Point3> x;
  EdgeSurface surface;
  EdgePoints points;
  EdgeQuery query;
};

Pairs find_pairs(const RandomEdges& edges, EdgeSearchScratch& scratch) {
  EdgePairs found;
  find_edge_pairs(ExecSpace(), edges.surface, edges.query, 10'000'000, scratch, found);
  Pairs pairs;
  for (int i = 0; i < found.num_pairs; ++i) pairs.emplace_back(found.a(i), found.b(i));
  return pairs;
}

TEST(EdgeSearch, FindsTheRandomPairsOfBruteForce) {
  for (const int kinds : {1, 2, 3, 4}) {
    const RandomEdges edges(static_cast<unsigned>(kinds), 300, kinds);
    const Pairs expected = edges.find_by_brute_force();
    EXPECT_GT(expected.size(), 100u);
    for (const SearchMethod method : {SearchMethod::points_in_box, SearchMethod::blocks}) {
      EdgeSearchScratch scratch;
      scratch.points.method = method;
      EXPECT_EQ(find_pairs(edges, scratch), expected) << kinds;
    }
  }
}

TEST(EdgeSearch, GoesOnWithTheOrderOfOtherEdges) {
  EdgeSearchScratch scratch;
  const auto tell = [&](const RandomEdges& edges) {
    std::vector<std::int64_t> points(static_cast<std::size_t>(edges.points.num_points));
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(edges.surface.num_edges));
    std::iota(points.begin(), points.end(), 0);
    std::iota(numbers.begin(), numbers.end(), 0);
    identify(points, numbers, scratch.points.blocks);
  };
  for (const int count : {300, 310, 305}) {
    const RandomEdges edges(7, count, 4);
    tell(edges);
    EXPECT_EQ(find_pairs(edges, scratch), edges.find_by_brute_force()) << count;
  }
}

}  // namespace
}  // namespace percuss::test::edge_search_test
