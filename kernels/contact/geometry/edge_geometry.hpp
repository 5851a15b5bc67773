#pragma once
// Two straight edges in space: where their lines come closest, and which way the wedges behind them push each other.

#include "kernels/contact/geometry/point3.hpp"

namespace percuss {

/// Edge A from a[0] to a[1] and edge B from b[0] to b[1], relative to an origin near them.
struct EdgePair {
  Point3 a[2]{}, b[2]{};
};

/// Where the lines through two edges come closest.
struct Crossing {
  bool crosses = false;  // false: nearly parallel
  double s = 0, t = 0;   // place on A and on B, 0 to 1 on the edge
  Point3 normal{};       // unit vector along a x b
  double gap = 0;        // (point of A - point of B) . normal
};

/// least_sine: edges at a lesser angle count as parallel.
KOKKOS_INLINE_FUNCTION Crossing find_crossing(const EdgePair& e, double least_sine) {
  const Point3 u = e.a[1] - e.a[0], v = e.b[1] - e.b[0], w = e.b[0] - e.a[0];
  const Point3 c = cross(u, v);
  const double square = dot(c, c);
  Crossing found;
  if (!(square > least_sine * least_sine * dot(u, u) * dot(v, v))) return found;
  found.crosses = true;
  found.s = dot(cross(w, v), c) / square;
  found.t = dot(cross(w, u), c) / square;
  found.normal = (1 / std::sqrt(square)) * c;
  found.gap = -dot(w, found.normal);
  return found;
}

/// Whether the lines come closest on both edges, each shortened at both ends by a share `band` of its length.
KOKKOS_INLINE_FUNCTION bool is_inside(const Crossing& c, double band) {
  return c.s >= band && c.s <= 1 - band && c.t >= band && c.t <= 1 - band;
}

/// Whether the lines come closest on both edges, each shortened by a band of its own.
KOKKOS_INLINE_FUNCTION bool is_inside(const Crossing& c, double band_a, double band_b) {
  return c.s >= band_a && c.s <= 1 - band_a && c.t >= band_b && c.t <= 1 - band_b;
}

/// The directions from an edge into its two faces.
struct Wedge {
  Point3 inward[2]{};
};

/// How far the plane with this normal through both edges is from parting the wedges: A's faces before it, B's behind
/// it. At most 0 if it does, the sine of the angle by which a face reaches through it if not.
KOKKOS_INLINE_FUNCTION double find_reach_through(const Wedge& a, const Wedge& b, const Point3& normal) {
  double most = -1;
  for (int i = 0; i < 2; ++i) {
    const double before = -dot(a.inward[i], normal), behind = dot(b.inward[i], normal);
    most = before > most ? before : most;
    most = behind > most ? behind : most;
  }
  return most;
}

/// The unit vector from the edge (p0, p1) into the face (p0, p1, q1, q0), square to the edge.
KOKKOS_INLINE_FUNCTION Point3 find_inward(const Point3& p0, const Point3& p1, const Point3& q0, const Point3& q1) {
  const Point3 along = p1 - p0, across = (q0 - p0) + (q1 - p1);
  const double square = dot(along, along);
  return normalize(square > 0 ? across - (dot(across, along) / square) * along : across);
}

}  // namespace percuss
