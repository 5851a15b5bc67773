#include "src/contact/approach/wall_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A node before a wall.
struct BeforeWall {
  double gap = 0, closing = 0;  // to the surface; speed at which it closes
  Point3 velocity{};            // relative to the wall
};

/// `wall` is where it is at the end of the motion.
BeforeWall look_at_node(const ContactWall& wall, const Point3& x, const Point3& v) {
  const bool is_plane = wall.shape == WallShape::plane;
  const Point3 from_axis = is_plane ? wall.normal : find_radial(wall, x - wall.point);
  const double length = norm(from_axis);
  BeforeWall node;
  node.gap = find_wall_height(wall, x);
  node.velocity = v - wall.speed * (is_plane ? wall.normal : wall.direction);
  node.closing = length > 0 ? -dot(node.velocity, from_axis) / length : norm(node.velocity);
  return node;
}

template <std::size_t count>
std::array<double, count> find_means(const ExactSum* sums, std::int64_t of) {
  std::array<double, count> means{};
  for (std::size_t k = 0; k < count; ++k) means[k] = sums[k].round() / static_cast<double>(of);
  return means;
}

/// Where the wall is at the end of a step, as it goes now.
ContactWall move_wall(ContactWall wall, double speed, double dt) {
  wall.speed = speed;
  wall.point = wall.point + dt * speed * (wall.shape == WallShape::plane ? wall.normal : wall.direction);
  return wall;
}

}  // namespace

struct WallWatch::Front {
  int wall = 0, part = 0;
  double size = 0;              // shortest edge
  double gap = 0, closing = 0;  // the least, and the fastest
  double speed = 0;             // of a node relative to the wall, the fastest
  double drift = 0;             // of all, their mean
};

void WallWatch::redefine(const WallPairs& pairs) {
  const auto size = to_host(pairs.size);
  least_size_ = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < size.extent(0); ++p) least_size_ = std::min(least_size_, size(p));
  if (!deck_.walls.empty()) all_reduce(ranks_, Reduce::least, least_size_);
}

double WallWatch::find_way(const WallPairs& pairs, const SurfaceMotion& motion) const {
  const Array<const int> node = pairs.node;
  const Rows3<const double> v = motion.v;
  double square = 0;
  parallel_reduce(
      "contact::way_to_walls", RangeOf(ExecSpace(), 0, static_cast<int>(node.extent(0))),
      KOKKOS_LAMBDA(int p, double& largest) {
        const Point3 u = load_row(v, node(p));
        const double s = dot(u, u);
        if (s > largest) largest = s;
      },
      Kokkos::Max<double>(square));
  square = std::max(square, 0.0);
  all_reduce(ranks_, Reduce::largest, square);
  return motion.dt * std::sqrt(square);
}

bool WallWatch::may_limit(double way, const std::vector<WallMotion>& motions, double dt) const {
  double fastest = 0;
  for (const WallMotion& motion : motions) fastest = std::max(fastest, std::abs(motion.speed));
  return most_step_growth * (way + dt * fastest) > approach_share * least_size_;
}

/// By wall and part: extremes and exact sums, the same on any ranks. Nodes deep behind a wall that ends have passed it.
std::vector<WallWatch::Front> WallWatch::measure_fronts(const MovedWalls& moved, const SurfaceMotion& motion) const {
  constexpr double passed = 0.5;  // share of h, as in is_beside()
  constexpr std::size_t count = 4;
  const std::size_t parts = mesh_.parts.size(), fronts = deck_.walls.size() * parts;
  std::vector<double> values(count * fronts, std::numeric_limits<double>::lowest());
  std::vector<ExactSum> sums(count * fronts);
  std::vector<std::int64_t> nodes(fronts, 0);
  const WallPairs& pairs = moved.pairs;
  const auto walls = to_host(pairs.walls);
  const auto wall = to_host(pairs.wall), node = to_host(pairs.node), part = to_host(pairs.part);
  const auto size = to_host(pairs.size), offset = to_host(pairs.offset);
  const auto x = to_host(motion.x), v = to_host(motion.v);
  for (std::size_t p = 0; p < wall.extent(0); ++p) {
    const ContactWall to = move_wall(walls(at(wall(p))), moved.motions[at(wall(p))].speed, motion.dt);
    const Point3 velocity = load_row(v, node(p));
    BeforeWall found = look_at_node(to, load_row(x, node(p)) + motion.dt * velocity, velocity);
    if (offset.extent(0) > 0) found.gap -= offset(p);
    if (to.size[0] > 0 && found.gap < -passed * size(p)) continue;
    const std::size_t front = at(wall(p)) * parts + at(part(p));
    const double speed = to.friction > 0 ? norm(found.velocity) : std::abs(found.closing);
    const double of[count] = {-size(p), -found.gap, found.closing, speed};
    const double added[count] = {found.velocity.x, found.velocity.y, found.velocity.z, found.closing};
    for (std::size_t k = 0; k < count; ++k) {
      values[count * front + k] = std::max(values[count * front + k], of[k]);
      sums[count * front + k].add(added[k]);
    }
    ++nodes[front];
  }
  all_reduce(ranks_, Reduce::largest, values);
  sum_over_ranks(ranks_, sums);
  all_reduce(ranks_, Reduce::sum, nodes);
  std::vector<Front> found;
  for (std::size_t f = 0; f < fronts; ++f) {
    if (nodes[f] == 0) continue;
    const std::array<double, count> mean = find_means<count>(&sums[count * f], nodes[f]);
    const bool rubs = walls(f / parts).friction > 0;
    const double drift = rubs ? norm(Point3{mean[0], mean[1], mean[2]}) : std::abs(mean[3]);
    const double* const of = &values[count * f];
    found.push_back({static_cast<int>(f / parts), static_cast<int>(f % parts), -of[0], -of[1], of[2], of[3], drift});
  }
  return found;
}

Approach WallWatch::find_shortest(const std::vector<Front>& fronts, double horizon, Moment moment) const {
  Approach shortest;
  for (const Front& front : fronts) {
    const bool is_apart = front.gap > 0;
    if (!(front.closing > 0) || !(front.size > 0)) continue;  // beams have no size: they have no contact either
    const double speed = is_apart || moment == Moment::start ? front.speed : front.drift;
    if (!(speed > 0)) continue;
    const double travel_step = approach_share * front.size / speed;
    const double step = (is_apart ? front.gap / front.closing : 0) + travel_step;
    if (step < horizon && step < shortest.step) shortest = {step, travel_step, speed, front.part, -1 - front.wall};
  }
  return shortest;
}

Approach WallWatch::look_at_start(const MovedWalls& walls, const Rows3<const double>& x, const Rows3<const double>& v,
                                  double dt) const {
  return find_shortest(measure_fronts(walls, {x, v, 0}), dt, Moment::start);
}

Approach WallWatch::look(const MovedWalls& walls, const SurfaceMotion& motion) const {
  return find_shortest(measure_fronts(walls, motion), most_step_growth * motion.dt, Moment::later);
}

}  // namespace percuss
