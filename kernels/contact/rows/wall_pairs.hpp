#pragma once
// Rigid walls with the nodes that each stops, and the gap between them in a step.

#include "kernels/contact/geometry/wall_geometry.hpp"
#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// Walls and the nodes of this rank that each stops, const after set-up but for where moving walls are.
struct WallPairs {
  Array<ContactWall> walls;      // [walls]
  Array<const int> wall;         // [pairs] ascending
  Array<const int> node;         // [pairs] mesh node, ascending within a wall
  Array<const double> size;      // [pairs] shortest edge at the node at the start, the h of its row
  Array<const double> offset{};  // [pairs] distance that the node keeps, by its thickness; empty: none does [length]
  Array<const int> is_inner{};   // [pairs] whether the node is inside its body; empty: none is
  Array<const double> spring{};  // [pairs] stiffness of the node, of springs.hpp; 0 without penalty
  // Pairs that may come near in this step, ascending (wall_sleep.hpp); num_awake < 0: all.
  Array<int> awake{};
  int num_awake = -1;
  // For reports.
  Array<const int> part{};             // [pairs] of the mesh that the node belongs to
  Array<const std::int64_t> number{};  // [pairs] of the node in the whole mesh

  int count() const { return static_cast<int>(node.extent(0)); }
  /// How many pairs a step looks at, and the i-th of them.
  int count_looked_at() const { return num_awake < 0 ? count() : num_awake; }
  KOKKOS_INLINE_FUNCTION int look_at(int i) const { return num_awake < 0 ? i : awake(i); }
};

/// Gap of pair p, of a wall that is a cylinder or a sphere.
KOKKOS_INLINE_FUNCTION WallGap find_round_gap(const WallPairs& walls, const SurfaceMotion& motion, int p) {
  const double offset = walls.offset.extent(0) > 0 ? walls.offset(p) : 0;
  return find_round_gap(walls.walls(walls.wall(p)), load_row(motion.x, walls.node(p)),
                        load_row(motion.v, walls.node(p)), motion.dt, offset);
}

/// Gap between the node and the wall of pair p, `share` of the step after n: 0 or 1.
KOKKOS_INLINE_FUNCTION double find_wall_gap(const WallPairs& walls, const SurfaceMotion& motion, int p, double share) {
  const ContactWall& wall = walls.walls(walls.wall(p));
  const int node = walls.node(p);
  if (wall.shape != WallShape::plane) {
    const WallGap gap = find_round_gap(walls, motion, p);
    return share > 0 ? gap.end : gap.start;
  }
  const Point3 from_wall = load_row(motion.x, node) - wall.point;
  const double closing = dot(wall.normal, load_row(motion.v, node)) - wall.speed;
  const double gap = dot(wall.normal, from_wall) + share * motion.dt * closing;
  return walls.offset.extent(0) > 0 ? gap - walls.offset(p) : gap;
}

/// Whether the wall of pair p can stop its node at n.
KOKKOS_INLINE_FUNCTION bool can_stop(const WallPairs& walls, const SurfaceMotion& motion, int p) {
  const ContactWall& wall = walls.walls(walls.wall(p));
  if (!(wall.size[0] > 0)) return true;
  return !is_beside(wall, load_row(motion.x, walls.node(p)), -find_wall_gap(walls, motion, p, 0), walls.size(p));
}

}  // namespace percuss
