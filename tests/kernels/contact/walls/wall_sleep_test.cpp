// Nodes that sleep far from walls: none that could have a row.

#include "kernels/contact/rows/wall_sleep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "kernels/core/host_copy.hpp"

namespace percuss::test::wall_sleep_test {
namespace {

constexpr int num_nodes = 400;
constexpr double size = 0.1, dt = 0.01;

ContactWall make_round(WallShape shape, const Point3& at, double radius) {
  ContactWall wall{at, {}};
  wall.shape = shape;
  wall.radius = radius;
  wall.along = {0, 1, 0};
  wall.across = {1, 0, 0};
  wall.direction = {0, 0, 1};
  return wall;
}

/// Nodes in a cube of edge 2 that fly about, and four walls at it, of which each may stop any of them.
struct Cloud {
  explicit Cloud(double offset) : x("test::x", num_nodes), v("test::v", num_nodes) {
    ContactWall rectangle{{-0.5, -0.5, -1.1}, {0, 0, 1}};
    rectangle.along = {1, 0, 0};
    rectangle.across = {0, 1, 0};
    rectangle.size[0] = rectangle.size[1] = 1;
    const std::vector<ContactWall> all{{{0, 0, -1.02}, {0, 0, 1}},
                                       rectangle,
                                       make_round(WallShape::cylinder, {1.5, 0, 0.2}, 0.4),
                                       make_round(WallShape::sphere, {0, 0, 0}, 0.3)};
    std::vector<int> wall, node;
    for (std::size_t w = 0; w < all.size(); ++w)
      for (int n = 0; n < num_nodes; ++n) {
        wall.push_back(static_cast<int>(w));
        node.push_back(n);
      }
    walls.walls = to_view("test::walls", all);
    walls.wall = to_view("test::wall", wall);
    walls.node = to_view("test::node", node);
    walls.size = to_view("test::size", std::vector<double>(wall.size(), size));
    if (offset > 0) walls.offset = to_view("test::offset", std::vector<double>(wall.size(), offset));
    for (int n = 0; n < num_nodes; ++n) store_row(x, n, draw(1));
  }

  Point3 draw(double most) {
    std::uniform_real_distribution<double> within(-most, most);
    const double a = within(random), b = within(random), c = within(random);
    return {a, b, c};
  }

  /// New velocities; returns the largest speed.
  double turn(double most) {
    double fastest = 0;
    for (int n = 0; n < num_nodes; ++n) {
      store_row(v, n, draw(most));
      fastest = std::max(fastest, norm(load_row(v, n)));
    }
    return fastest;
  }

  void move() {
    for (int n = 0; n < num_nodes; ++n) store_row(x, n, load_row(x, n) + dt * load_row(v, n));
  }

  void move_walls(double speed) {
    for (int w = 0; w < 4; ++w) {
      ContactWall& wall = walls.walls(static_cast<std::size_t>(w));
      wall.speed = speed;
    }
  }
  void place_walls(double speed) {
    for (int w = 0; w < 4; ++w) {
      ContactWall& wall = walls.walls(static_cast<std::size_t>(w));
      wall.point = wall.point + dt * speed * (wall.shape == WallShape::plane ? wall.normal : wall.direction);
    }
  }

  /// All pairs that would have a row are looked at; returns how many these are.
  int expect_none_missed() const {
    std::vector<char> is_awake(static_cast<std::size_t>(walls.count()), 0);
    for (int i = 0; i < walls.count_looked_at(); ++i) is_awake[static_cast<std::size_t>(walls.look_at(i))] = 1;
    int rows = 0;
    for (int p = 0; p < walls.count(); ++p) {
      const bool has_row =
          find_wall_gap(walls, {x, v, dt}, p, 1) <= contact_limits::row_gap * size && can_stop(walls, {x, v, dt}, p);
      if (!has_row) continue;
      ++rows;
      EXPECT_EQ(is_awake[static_cast<std::size_t>(p)], 1) << "pair " << p;
    }
    return rows;
  }

  std::mt19937_64 random{7};
  WallPairs walls;
  Rows3<double> x, v;
};

}  // namespace

TEST(WallSleep, LooksAtEveryPairThatHasARow) {
  for (const double offset : {0.0, 0.03})
    for (const double wall_speed : {0.0, 0.02}) {
      Cloud cloud(offset);
      WallSleep sleep(true);
      double last = -1;
      int rows = 0;
      for (int step = 0; step < 200; ++step) {
        // Slow, ten times as fast for a while, and slow again.
        const double fastest = cloud.turn(step / 50 == 1 ? 0.2 : 0.02), next = dt * (fastest + wall_speed);
        sleep.enter_step({last, next}, cloud.x, cloud.walls);
        cloud.move_walls(wall_speed);
        rows += cloud.expect_none_missed();
        cloud.move();
        cloud.place_walls(wall_speed);
        last = next;
      }
      EXPECT_GT(rows, 100);
      EXPECT_EQ(sleep.counts().pairs, 200 * cloud.walls.count());
      EXPECT_LT(static_cast<double>(sleep.counts().looked_at), 0.6 * static_cast<double>(sleep.counts().pairs));
    }
}

TEST(WallSleep, AnUnknownWayWakesAll) {
  Cloud cloud(0);
  WallSleep sleep(true), never(false);
  const double next = dt * cloud.turn(0.01);
  sleep.enter_step({-1, next}, cloud.x, cloud.walls);
  const int some = cloud.walls.count_looked_at();
  EXPECT_LT(some, cloud.walls.count());
  sleep.enter_step({next, -1}, cloud.x, cloud.walls);
  EXPECT_EQ(cloud.walls.count_looked_at(), cloud.walls.count());
  never.enter_step({next, next}, cloud.x, cloud.walls);
  EXPECT_EQ(cloud.walls.count_looked_at(), cloud.walls.count());
  // Nodes that something else has put elsewhere: the list is made again.
  sleep.enter_step({-1, next}, cloud.x, cloud.walls);
  for (int n = 0; n < num_nodes; ++n) store_row(cloud.x, n, {0, 0, -1.02});
  sleep.wake();
  sleep.enter_step({next, next}, cloud.x, cloud.walls);
  EXPECT_GE(cloud.expect_none_missed(), num_nodes);
}

}  // namespace percuss::test::wall_sleep_test
