// Pairs of edges that are left out of the check: none whose boxes meet before the travel is used up.

#include "kernels/contact/check/near_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "kernels/contact/check/edge_check.hpp"

namespace percuss::test::near_edges_test {
namespace {

constexpr int num_edges = 200;

/// Short edges here and there in a unit cube, and all pairs of them.
struct LooseEdges {
  LooseEdges() {
    surface.num_edges = num_edges;
    surface.ends = ends;
    surface.wings = Rows4<int>("test::wings", num_edges);
    pairs.num_edges = num_edges;
    pairs.edges = Array<int>("test::edges", num_edges);
    pairs.num_pairs = num_edges * (num_edges - 1) / 2;
    pairs.a = Array<int>("test::a", static_cast<std::size_t>(pairs.num_pairs));
    pairs.b = Array<int>("test::b", static_cast<std::size_t>(pairs.num_pairs));
    for (int a = 0, p = 0; a < num_edges; ++a) {
      pairs.edges(a) = a;
      for (int b = a + 1; b < num_edges; ++b, ++p) pairs.a(p) = a, pairs.b(p) = b;
    }
    for (int e = 0; e < num_edges; ++e) {
      for (int i = 0; i < 2; ++i) ends(e, i) = 2 * e + i;
      for (int k = 0; k < 3; ++k) {
        x(2 * e, k) = 0.5 + 0.5 * part(random);
        x(2 * e + 1, k) = x(2 * e, k) + 0.05 * part(random);
      }
    }
  }

  /// A place that every node can have gone to.
  Rows3<double> go(double travel) {
    Rows3<double> gone("test::gone", 2 * num_edges);
    for (int n = 0; n < 2 * num_edges; ++n)
      for (int k = 0; k < 3; ++k) gone(n, k) = x(n, k) + travel / std::sqrt(3.0) * part(random);
    return gone;
  }

  std::mt19937 random{7};
  std::uniform_real_distribution<double> part{-1, 1};
  Rows2<int> ends = Rows2<int>("test::ends", num_edges);
  Rows3<double> x = Rows3<double>("test::x", 2 * num_edges);
  EdgeSurface surface;
  EdgePairs pairs;
};

std::set<std::pair<int, int>> list(const EdgePairs& pairs) {
  std::set<std::pair<int, int>> found;
  for (int p = 0; p < pairs.num_pairs; ++p) found.emplace(pairs.a(p), pairs.b(p));
  return found;
}

}  // namespace

TEST(NearEdges, HoldAllPairsWhoseBoxesMeetBeforeTheTravelIsUsedUp) {
  constexpr double travel = 0.02;
  LooseEdges edges;
  NearEdgeScratch scratch;
  EdgePairs near;
  ASSERT_TRUE(list_near_edges(ExecSpace(), {edges.surface, {edges.x, edges.x, 0}, {}, {}}, edges.pairs,
                              {travel, 0.5 * edges.pairs.num_pairs}, scratch, near));
  ExecSpace().fence();
  const auto listed = list(near);
  EXPECT_LT(near.num_pairs, edges.pairs.num_pairs / 10);
  EXPECT_LE(near.num_edges, num_edges);
  EdgeState state;
  state.boxes = Boxes("test::boxes", num_edges);
  int meeting = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Rows3<double> now = edges.go(travel), next = edges.go(travel), v("test::v", 2 * num_edges);
    for (int n = 0; n < 2 * num_edges; ++n)
      for (int k = 0; k < 3; ++k) v(n, k) = next(n, k) - now(n, k);
    StillEdges still;
    still.begin(false, num_edges);
    update_edges(ExecSpace(), edges.surface, {now, v, 1}, edges.pairs, still, state);
    ExecSpace().fence();
    for (int p = 0; p < edges.pairs.num_pairs; ++p) {
      if (!do_boxes_meet(state.boxes, edges.pairs.a(p), edges.pairs.b(p))) continue;
      ++meeting;
      EXPECT_TRUE(listed.count({edges.pairs.a(p), edges.pairs.b(p)}) > 0) << "pair " << p;
    }
  }
  EXPECT_GT(meeting, 100);
}

TEST(NearEdges, AreNotListedWhereThisSavesLittle) {
  LooseEdges edges;
  NearEdgeScratch scratch;
  EdgePairs near;
  EXPECT_FALSE(list_near_edges(ExecSpace(), {edges.surface, {edges.x, edges.x, 0}, {}, {}}, edges.pairs,
                               {2, 0.5 * edges.pairs.num_pairs}, scratch, near));
}

}  // namespace percuss::test::near_edges_test
