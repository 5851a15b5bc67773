#pragma once
// Bound of a quadrilateral's stiffness in transverse shear: the largest eigenvalue of its four modes, against its
// masses.
//
// Shear is sampled on four edges; that of an edge k is the motion of its ends along the mean q_k of their directors and
// the turning of these directors. Of two edges the products over masses are, but for 4 / m, q_k . q_l c_kl of
// velocities and at most x_k . x_l times as much over the inertia of rotations, x the edges' lengths. The modes are the
// shear of the point and what changes beyond it, as find_shell_rates() takes them.

#include "kernels/shell/shell_geometry.hpp"

namespace percuss {

/// Bound of the largest eigenvalue of two groups of modes from those of each, a and b, and the square of what couples
/// them.
template <class T>
PERCUSS_FORCE_INLINE T join_modes(const T& a, const T& b, const T& coupling_square) {
  const T half_sum = T(0.5) * (a + b), half_difference = T(0.5) * (a - b);
  return half_sum + square_root(half_difference * half_difference + coupling_square);
}

/// Directors of the edges: their mean m over the element, and by d how those along xi (1-2, 4-3) and along eta (1-4,
/// 2-3) differ from it, as products.
template <class T>
struct EdgeDirectors {
  T mean_square;            // m . m
  T square_xi, square_eta;  // m . m + d . d
  T across;                 // d_xi . d_eta
  T with_xi, with_eta;      // m . d
  T leaning;                // largest square of the part of an edge's director in the plane
};

template <class T>
PERCUSS_FORCE_INLINE EdgeDirectors<T> find_edge_directors(const ShellGeometry<T>& g) {
  const auto join = [&](int s1, int s2, int s3) {
    const T quarter = T(0.25), first = T(s1), second = T(s2), third = T(s3);
    const auto sum = [&](const T(&p)[4]) { return quarter * (p[0] + first * p[1] + second * p[2] + third * p[3]); };
    return Vector3<T>{sum(g.px), sum(g.py), sum(g.pz)};
  };
  const Vector3<T> m = join(1, 1, 1), xi = join(1, -1, -1), eta = join(-1, -1, 1);
  const auto in_plane = [](const Vector3<T>& a, const Vector3<T>& b) { return a.x * b.x + a.y * b.y; };
  const T flat_m = in_plane(m, m), flat_xi = in_plane(m, xi), flat_eta = in_plane(m, eta);
  const T lean_xi = in_plane(xi, xi) + T(2) * larger(flat_xi, -flat_xi),
          lean_eta = in_plane(eta, eta) + T(2) * larger(flat_eta, -flat_eta);
  const T mean_square = dot(m, m);
  return {mean_square,  mean_square + dot(xi, xi),         mean_square + dot(eta, eta), dot(xi, eta), -dot(m, xi),
          -dot(m, eta), flat_m + larger(lean_xi, lean_eta)};
}

/// Products over masses of the shear along xi and eta, their means (x, e) and how they change across (1, 2).
template <class T>
struct ShearProducts {
  T xx, ee, xe, x1, e2;  // 1 1 is x x, 2 2 is e e, x 2 is half of x 1, e 1 half of e 2
};

template <class T>
PERCUSS_FORCE_INLINE ShearProducts<T> find_shear_products(const ShellGeometry<T>& g, const EdgeDirectors<T>& directors,
                                                          const T& over_inertia) {
  // Half the sums of the edges along xi and along eta.
  const T half_area = T(0.5) * g.area;
  const T x[2] = {half_area * g.eta_y, -half_area * g.eta_x}, e[2] = {-half_area * g.xi_y, half_area * g.xi_x};
  const auto product = [](const T(&a)[2], const T(&b)[2]) { return a[0] * b[0] + a[1] * b[1]; };
  const T h[2] = {g.hx, g.hy}, quarter = T(0.25), share = T(1.0 / 16.0) * over_inertia;
  const T shape = share * quarter * product(h, h), height = quarter * over_inertia * g.z * g.z;
  return {quarter * directors.square_xi + share * product(x, x) + shape + height,
          quarter * directors.square_eta + share * product(e, e) + shape + height,
          quarter * directors.across + share * product(x, e), T(0.5) * directors.with_xi + share * product(x, h),
          T(0.5) * directors.with_eta + share * product(e, h)};
}

/// Largest eigenvalue of the four modes.
template <class T>
PERCUSS_FORCE_INLINE T bound_shear_modes(const ShellGeometry<T>& g, const EdgeDirectors<T>& directors,
                                         const T& over_inertia) {
  const ShearProducts<T> p = find_shear_products(g, directors, over_inertia);
  const T xi_xi = g.xi_x * g.xi_x + g.xi_y * g.xi_y, eta_eta = g.eta_x * g.eta_x + g.eta_y * g.eta_y,
          xi_eta = g.xi_x * g.eta_x + g.xi_y * g.eta_y, quarter = T(0.25), third = T(1.0 / 3.0);
  // The point's shear: gradients times means.
  const T half_trace = T(0.5) * (xi_xi * p.xx + eta_eta * p.ee) + xi_eta * p.xe;
  const T of_gradients = g.xi_x * g.eta_y - g.xi_y * g.eta_x;
  const T determinant = of_gradients * of_gradients * (p.xx * p.ee - p.xe * p.xe);
  const T of_point = half_trace + square_root(larger(half_trace * half_trace - determinant, T(0)));
  // What changes, less what a uniform shear changes by itself: a along xi and b along eta.
  const T a = quarter * (g.hx * g.xi_x + g.hy * g.xi_y), b = quarter * (g.hx * g.eta_x + g.hy * g.eta_y);
  const T half = T(0.5), x = p.x1 - a * p.xx - b * p.xe, e = half * p.e2 - a * p.xe - b * p.ee;  // of 1 with the means
  const T x_2 = x - half * p.x1, e_2 = e + half * p.e2;                                          // of 2
  const T one = p.xx - a * (p.x1 + x) - b * (half * p.e2 + e), two = p.ee - a * (half * p.x1 + x_2) - b * (p.e2 + e_2);
  const T first = third * xi_xi, second = third * eta_eta;  // of the stiffness
  const auto couple = [&](const T& along_xi, const T& along_eta) {
    return xi_xi * along_xi * along_xi + T(2) * xi_eta * along_xi * along_eta + eta_eta * along_eta * along_eta;
  };
  return join_modes(of_point, first * one + second * two, first * couple(x, e) + second * couple(x_2, e_2));
}

}  // namespace percuss
