#include "kernels/contact/rows/wall_sleep.hpp"

#include <cmath>
#include <limits>

#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// A list is meant to serve this many steps as fast as this one: fewer lists against more pairs in them.
constexpr double steps_ahead = 64;

/// Round-off of the ways that are added up to a list's reach, as a share, and of places, of their coordinates: a list
/// serves no more steps than that allows.
constexpr double way_round_off = 1e-9, place_round_off = 1e-11, size_round_off = 1e-6;  // the last of an edge
constexpr int most_steps = 4096;

/// Sum of the sizes of the coordinates of a point.
KOKKOS_INLINE_FUNCTION double find_extent(const Point3& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

/// How far node and wall of a pair may go together before the gap can be that of a row. All gaps change by the ways at
/// most; that to a round wall in one direction is never less than the distance while the node is outside.
KOKKOS_INLINE_FUNCTION double find_slack(const WallPairs& walls, const Rows3<const double>& x, int p) {
  const ContactWall& wall = walls.walls(walls.wall(p));
  const Point3 place = load_row(x, walls.node(p));
  const double offset = walls.offset.extent(0) > 0 ? walls.offset(p) : 0;
  const double round_off = place_round_off * (find_extent(place) + find_extent(wall.point) + wall.radius);
  return find_wall_height(wall, place) - offset - (contact_limits::row_gap + size_round_off) * walls.size(p) -
         round_off;
}

}  // namespace

int list_pairs_in_reach(const WorkSpace& space, const WallPairs& walls, const Rows3<const double>& x, double reach,
                        const Array<int>& list) {
  const WallPairs w = walls;
  const Rows3<const double> places = x;
  return list_where(
      space, walls.count(), [w, places, reach] KOKKOS_FUNCTION(int p) { return !(find_slack(w, places, p) > reach); },
      list);
}

void WallSleep::list_again(double way, const Rows3<const double>& x, WallPairs& walls) {
  reach_ = steps_ahead * way;
  travel_ = 0;
  steps_ = 0;
  is_valid_ = true;
  reserve(walls.awake, walls.count());
  run_where_it_pays(walls.count() / 8, [&](const auto& space) {
    walls.num_awake = list_pairs_in_reach(space, walls, x, reach_, walls.awake);
    space.fence();
  });
}

void WallSleep::enter_step(const WallWays& ways, const Rows3<const double>& x, WallPairs& walls) {
  counts_.pairs += walls.count();
  if (!enabled_ || !(ways.next >= 0)) {
    is_valid_ = false;
    walls.num_awake = -1;
    counts_.looked_at += walls.count();
    return;
  }
  const double way = (1 + way_round_off) * ways.next;
  if (ways.last >= 0)
    travel_ += (1 + way_round_off) * ways.last;
  else
    is_valid_ = false;
  const bool holds = is_valid_ && travel_ + way <= reach_ && ++steps_ < most_steps;
  if (!holds) list_again(way, x, walls);
  counts_.looked_at += holds ? walls.num_awake : walls.count();
}

}  // namespace percuss
