// How long candidate and near pairs may be used, of a surface of one face with nodes behind it.

#include "src/contact/search/reuse_bound.hpp"

#include <gtest/gtest.h>

#include "kernels/core/host_copy.hpp"

namespace percuss::test {
namespace {

/// Nodes 0 to 3 are corners of a face of edge 1, nodes 4 to 7 lie behind it and are no contact nodes.
struct ReuseBounds : testing::Test {
  ReuseBounds() {
    const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int n = 0; n < 8; ++n) store_row(x, n, {corners[n % 4][0], corners[n % 4][1], n < 4 ? 0.0 : -1.0});
    store_row(v, 0, {0, 0, 1e-4});
    bound.restart(motion());
  }

  static SurfaceShare make_share() {
    SurfaceShare share;
    share.nodes.mesh_nodes = {0, 1, 2, 3};
    share.node_list = to_view("test::nodes", share.nodes.mesh_nodes);
    share.watched_list = to_view("test::watched", std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
    share.corner_list = to_rows("test::corners", std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
    share.searched_faces = {0};
    share.total_searched_faces = 1;
    return share;
  }
  SurfaceMotion motion() const { return {x, v, 1}; }

  const SurfaceShare share = make_share();
  Rows3<double> x = Rows3<double>("test::x", 8), v = Rows3<double>("test::v", 8);
  ReuseBound bound{Communicator::world(), share, true};  // has just searched
};

TEST_F(ReuseBounds, AFirstListIsAskedForAfterASearchAndHoldsWhileNodesStay) {
  const NearWay first = bound.restart_near(motion());
  EXPECT_GT(first.near, 0);
  EXPECT_GT(first.search, first.near);
  EXPECT_FALSE(first.keeps_first);
  x(1, 2) += 0.5 * first.near;
  EXPECT_TRUE(bound.covers_near(motion()));
  x(1, 2) += first.near;
  EXPECT_FALSE(bound.covers_near(motion()));
  EXPECT_TRUE(bound.covers(motion()));
  const NearWay next = bound.restart_near(motion());
  EXPECT_GT(next.near, 0);
  EXPECT_TRUE(next.keeps_first);
  EXPECT_EQ(next.search, 0);
}

TEST_F(ReuseBounds, NodesBehindFacesEndBothLists) {
  const NearWay first = bound.restart_near(motion());
  x(5, 2) += 1.1 * first.near;
  EXPECT_FALSE(bound.covers_near(motion()));
  EXPECT_TRUE(bound.restart_near(motion()).keeps_first);
  x(5, 2) += first.search;
  EXPECT_TRUE(bound.covers(motion()));  // no contact node has moved
  EXPECT_FALSE(bound.covers_near(motion()));
  const NearWay next = bound.restart_near(motion());
  EXPECT_FALSE(next.keeps_first);
  EXPECT_GT(next.search, 0);
}

TEST_F(ReuseBounds, TheFirstListIsWatchedWhereNoNearOneIsWorthIt) {
  const NearWay first = bound.restart_near(motion());
  store_row(v, 2, {0, 0, 0.2 * first.search});  // fewer than three steps
  NearWay next = bound.restart_near(motion());
  EXPECT_EQ(next.near, 0);
  EXPECT_TRUE(next.keeps_first);
  store_row(v, 6, {0, 0, 2 * first.search});  // within the step
  next = bound.restart_near(motion());
  EXPECT_EQ(next.near, 0);
  EXPECT_FALSE(next.keeps_first);
}

TEST_F(ReuseBounds, SearchesAndOtherSurfacesEndTheFirstList) {
  bound.restart_near(motion());
  bound.restart(motion());
  EXPECT_FALSE(bound.restart_near(motion()).keeps_first);
  EXPECT_TRUE(bound.restart_near(motion()).keeps_first);
  bound.redefine();
  EXPECT_FALSE(bound.covers(motion()));
  EXPECT_FALSE(bound.restart_near(motion()).keeps_first);
}

TEST_F(ReuseBounds, SwitchedOffNothingIsUsedAgain) {
  ReuseBound off(Communicator::world(), share, false);
  off.restart(motion());
  EXPECT_FALSE(off.covers(motion()));
  const NearWay way = off.restart_near(motion());
  EXPECT_EQ(way.near, 0);
  EXPECT_EQ(way.search, 0);
  EXPECT_FALSE(way.keeps_first);
}

}  // namespace
}  // namespace percuss::test
