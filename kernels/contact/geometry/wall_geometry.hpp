#pragma once
// Rigid walls: planes, cylinders and spheres, and how near a node is to one.

#include <cstdint>

#include "kernels/contact/geometry/point3.hpp"

namespace percuss {

enum class WallShape : std::uint8_t { plane, cylinder, sphere };

/// A rigid plane; bodies live where (x - point) . normal > 0. Or a cylinder or a sphere, which bodies are outside of.
struct ContactWall {
  Point3 point{}, normal{};  // the point at n: of a cylinder one end of its axis, of a sphere the centre
  double friction = 0;
  double speed = 0;          // along the normal or the direction, from n to n+1
  Point3 along{}, across{};  // of a rectangle with a corner at `point`: unit vectors of its edges; along: also an axis
  double size[2] = {0, 0};   // their lengths; 0: the wall does not end
  WallShape shape = WallShape::plane;
  double radius = 0;
  Point3 direction{};  // in which a cylinder or a sphere moves
};

/// Gap between a node and a wall, and the way in which a push acts.
struct WallGap {
  double start = 0, end = 0;  // at n and predicted
  Point3 normal{}, gradient{};
};

/// Vector from the centre or the axis, without its part along the axis.
KOKKOS_INLINE_FUNCTION Point3 find_radial(const ContactWall& wall, const Point3& a) {
  return wall.shape == WallShape::cylinder ? a - dot(wall.along, a) * wall.along : a;
}

/// Height of a point above a wall: above the plane, or outside the cylinder or the sphere.
KOKKOS_INLINE_FUNCTION double find_wall_height(const ContactWall& wall, const Point3& x) {
  if (wall.shape == WallShape::plane) return dot(wall.normal, x - wall.point);
  return norm(find_radial(wall, x - wall.point)) - wall.radius;
}

/// Gap to a cylinder or a sphere. Pushes act along the normal at n, as constraints do in the central difference: a node
/// that slides around keeps its energy. The predicted gap is the way along this normal to the surface, so that a push
/// brings the node there exactly. offset: that the node keeps.
KOKKOS_INLINE_FUNCTION WallGap find_round_gap(const ContactWall& wall, const Point3& x, const Point3& v, double dt,
                                              double offset) {
  constexpr double steepest = 0.5;  // tangential slope of the gap that rows can follow
  const Point3 at_n = find_radial(wall, x - wall.point);
  const double distance = norm(at_n), radius = wall.radius + offset;
  WallGap gap;
  gap.normal = distance > 0 ? (1 / distance) * at_n : wall.across;
  gap.gradient = gap.normal;
  gap.start = distance - radius;
  const Point3 at_end = at_n + dt * find_radial(wall, v - wall.speed * wall.direction);
  const double height = dot(gap.normal, at_end);
  const Point3 beside = at_end - height * gap.normal;
  const double square = radius * radius - dot(beside, beside);
  if (!(square > 0)) {  // it passes
    gap.end = norm(at_end) - radius;
    return gap;
  }
  const double rest = std::sqrt(square), slope = norm(beside) / rest;
  gap.end = height - rest;
  gap.gradient = gap.normal + ((slope > steepest ? steepest / slope : 1) / rest) * beside;
  return gap;
}

/// Whether a point lies beside a wall that ends, or farther behind it than what has come through it could; false where
/// the wall does not end. depth: of the point behind the surface; size: h of its row.
KOKKOS_INLINE_FUNCTION bool is_beside(const ContactWall& wall, const Point3& x, double depth, double size) {
  constexpr double round_off = 1e-9;  // share of an edge
  constexpr double most_depth = 0.5;  // of h: enforcement leaves far less, what comes in at the side is soon deeper
  if (!(wall.size[0] > 0)) return false;
  const double a = dot(wall.along, x - wall.point), more_a = round_off * wall.size[0];
  if (a < -more_a || a > wall.size[0] + more_a || depth > most_depth * size) return true;
  if (wall.shape == WallShape::cylinder) return false;
  const double b = dot(wall.across, x - wall.point), more_b = round_off * wall.size[1];
  return b < -more_b || b > wall.size[1] + more_b;
}

}  // namespace percuss
