#pragma once
// When does a moving node go through a moving face? The roots of a cubic on the step, so that nothing is tunnelled.
//
// Points move on straight lines over the step, tau from 0 to 1. The node is the origin of the coordinates: only the
// face moves. For a triangle (a, b, c) the node lies in its plane when the cubic
//   phi(tau) = -a . (b - a) x (c - a)
// is zero; phi > 0 in front. Going through from front to back is a root where phi falls.

#include <cstdint>

#include "kernels/contact/geometry/face_geometry.hpp"

namespace percuss {

struct Cubic {
  double c[4] = {0, 0, 0, 0};  // c0 + c1 tau + c2 tau^2 + c3 tau^3
};

KOKKOS_INLINE_FUNCTION double evaluate(const Cubic& f, double tau) {
  return ((f.c[3] * tau + f.c[2]) * tau + f.c[1]) * tau + f.c[0];
}

/// Takes lo and hi, between which f falls through zero, close to where Newton's steps from the secant's zero lead, if
/// the root is there: motions of a step are small, and a cubic nearly a line.
KOKKOS_INLINE_FUNCTION void narrow(const Cubic& f, double& lo, double& hi) {
  constexpr int newton_steps = 3;
  constexpr double reach = 1.0 / (std::int64_t{1} << 50);  // some times the round-off of a root near 1
  const double at_lo = evaluate(f, lo), at_hi = evaluate(f, hi);
  double root = lo + (hi - lo) * (at_lo / (at_lo - at_hi));
  for (int i = 0; i < newton_steps; ++i) root -= evaluate(f, root) / ((3 * f.c[3] * root + 2 * f.c[2]) * root + f.c[1]);
  const double low = root - reach, high = root + reach;
  if (!(low > lo && high < hi && evaluate(f, low) >= 0 && evaluate(f, high) < 0)) return;
  lo = low;
  hi = high;
}

/// The root between lo and hi, where f falls through zero once, to the last bit that bisection can tell.
KOKKOS_INLINE_FUNCTION double bisect(const Cubic& f, double lo, double hi) {
  narrow(f, lo, hi);
  constexpr int max_halvings = 60;  // an interval inside [0, 1] is then below the spacing of doubles near 1
  for (int i = 0; i < max_halvings; ++i) {
    const double middle = 0.5 * (lo + hi);
    if (middle <= lo || middle >= hi) break;
    (evaluate(f, middle) >= 0 ? lo : hi) = middle;
  }
  return hi;
}

/// Points of [0, 1] that split it into parts where f is monotone, 0 and 1 included; returns how many.
KOKKOS_INLINE_FUNCTION int split_monotone(const Cubic& f, double part[4]) {
  int n = 0;
  part[n++] = 0;
  const double a = 3 * f.c[3], b = 2 * f.c[2], c = f.c[1];
  double turn[2] = {-1, -1};
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0) {
    // The form without cancellation; an infinite or undefined turn is not in (0, 1) and drops out.
    const double q = -0.5 * (b + (b >= 0 ? std::sqrt(discriminant) : -std::sqrt(discriminant)));
    turn[0] = a != 0 ? q / a : -1;
    turn[1] = q != 0 ? c / q : -1;
    if (turn[0] > turn[1]) {
      const double swap = turn[0];
      turn[0] = turn[1];
      turn[1] = swap;
    }
  }
  for (const double tau : turn)
    if (tau > 0 && tau < 1) part[n++] = tau;
  part[n++] = 1;
  return n;
}

/// Whether the cubic keeps one sign on [0, 1] for certain: all its Bernstein coefficients do.
KOKKOS_INLINE_FUNCTION bool keeps_sign(const Cubic& f) {
  const double b0 = f.c[0], b1 = b0 + f.c[1] / 3, b2 = b0 + (2 * f.c[1] + f.c[2]) / 3;
  const double b3 = f.c[0] + f.c[1] + f.c[2] + f.c[3];
  return (b0 > 0 && b1 > 0 && b2 > 0 && b3 > 0) || (b0 < 0 && b1 < 0 && b2 < 0 && b3 < 0);
}

/// The tau in (0, 1] at which f falls below 0 after having been at least 0, at most two of them (a cubic has no
/// more), ascending; returns how many.
KOKKOS_INLINE_FUNCTION int find_falling_roots(const Cubic& f, double root[2]) {
  if (keeps_sign(f)) return 0;
  double part[4] = {0, 0, 0, 0};
  const int parts = split_monotone(f, part);
  int n = 0;
  for (int i = 0; i + 1 < parts && n < 2; ++i)
    if (evaluate(f, part[i]) >= 0 && evaluate(f, part[i + 1]) < 0) root[n++] = bisect(f, part[i], part[i + 1]);
  return n;
}

/// The cubic of a triangle: corners a, b, c at tau = 0 and their displacements over the step, relative to the node.
KOKKOS_INLINE_FUNCTION Cubic find_plane_cubic(const Point3& a, const Point3& b, const Point3& c, const Point3& da,
                                              const Point3& db, const Point3& dc) {
  const Point3 e = b - a, f = c - a, de = db - da, df = dc - da;
  const Point3 n0 = cross(e, f), n1 = cross(de, f) + cross(e, df), n2 = cross(de, df);
  return {{-dot(a, n0), -(dot(da, n0) + dot(a, n1)), -(dot(da, n1) + dot(a, n2)), -dot(da, n2)}};
}

/// Where a node goes through a face.
struct SweptHit {
  bool hit = false;
  double tau = 0;
  double weight[4] = {0, 0, 0, 0};
  int triangle = 0;  // of the fan
  double off = 0;    // distance from the face at that time
};

/// The first time at which the node (the origin) goes through the fan from front to back, at most `band` beside it.
/// face: corners at tau = 0; moves: their displacements over the step; both relative to the node.
PERCUSS_NO_INLINE inline SweptHit sweep_face(const FacePoints& face, const FacePoints& moves, double band) {
  const Point3 middle = find_middle(face), middle_move = find_middle(moves);
  SweptHit first;
  for (int k = 0; k < 4; ++k) {
    const int l = (k + 1) % 4;
    const Cubic plane =
        find_plane_cubic(middle, face.corner[k], face.corner[l], middle_move, moves.corner[k], moves.corner[l]);
    double root[2] = {0, 0};
    const int roots = find_falling_roots(plane, root);
    for (int r = 0; r < roots; ++r) {
      const Point3 a = middle + root[r] * middle_move;
      const Point3 b = face.corner[k] + root[r] * moves.corner[k];
      const Point3 c = face.corner[l] + root[r] * moves.corner[l];
      const Point3 bary = find_closest_on_triangle(a, b, c);
      const double off = norm(bary.x * a + (bary.y * b + bary.z * c));
      const bool earlier = !first.hit || root[r] < first.tau || (root[r] == first.tau && off < first.off);
      if (!(off <= band) || !earlier) continue;
      first.hit = true;
      first.tau = root[r];
      first.off = off;
      first.triangle = k;
      set_fan_weights(k, bary, first.weight);
    }
  }
  return first;
}

}  // namespace percuss
