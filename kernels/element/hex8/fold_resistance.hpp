#pragma once
// Resistance of the hexahedron to folding: forces from the Jacobians of its corners, which one point does not see.
//
// Subzonal pressures (Caramana and Shashkov, J. Comp. Phys. 142, 1998) resist every change of a corner's share of the
// volume. Here a corner resists below a threshold r0 of that share only, with an energy of the geometry alone:
//   W = k V sum_I psi(r_I),   psi = (r0 - r)^3 / (3 r0) below r0, else 0,   r_I = J_I / V,
// J_I = e1 . (e2 x e3) the triple product of the three edges at corner I, V the exact volume. r does not change in a
// linear map, so that compression, shear and rotation meet no resistance. No history is kept. The stiffness sets in
// from zero: a step that meets a jump of it makes an error of its energy.

#include "kernels/element/hex8/hex8.hpp"

namespace percuss {

/// Share of the longitudinal modulus that k is.
inline constexpr double fold_stiffness = 0.25;

/// The largest threshold r0; a chunk whose elements have sharper corners at the start has a smaller one.
inline constexpr double largest_fold_threshold = 0.2;

/// Share of the sharpest corner at the start that the threshold does not exceed.
inline constexpr double fold_threshold_share = 0.8;

/// How far above the threshold a corner already counts for the next step.
inline constexpr double fold_margin = 0.03;

/// Below this obliqueness no corner of an element has r < 0.23, the largest threshold and the margin (the minimum over
/// all shapes is 1.0515), unless the hourglass modes outweigh its axes altogether.
inline constexpr double unfolded_obliqueness = 1.05;

/// A corner and its edges along xi, eta, zeta: bit k of `corner` is set where the k-th coordinate is +1. An edge along
/// k lies at the signs of the other two, l = k + 1 and m = k + 2 (cyclic), and is the edge 2 m + l of four.
PERCUSS_FORCE_INLINE constexpr int find_edge(int corner, int k) {
  return ((corner >> ((k + 1) % 3)) & 1) + 2 * ((corner >> ((k + 2) % 3)) & 1);
}

/// Three vectors of a corner: its edges, or forces on them.
template <class T>
struct EdgeField {
  Vector3<T> along[3][4];
};

/// The twelve edges in the order of find_edge().
template <class T>
PERCUSS_FORCE_INLINE EdgeField<T> find_edges(const VectorModes<T>& a) {
  const T quarter = number<T>(0.25);
  EdgeField<T> edges;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const Vector3<T> low = a[1 + k] - a[4 + l], high = a[1 + k] + a[4 + l];
    const Vector3<T> low_change = a[4 + m] - a[7], high_change = a[4 + m] + a[7];
    edges.along[k][0] = quarter * (low - low_change);
    edges.along[k][1] = quarter * (low + low_change);
    edges.along[k][2] = quarter * (high - high_change);
    edges.along[k][3] = quarter * (high + high_change);
  }
  return edges;
}

/// The transpose of find_edges(): forces by mode from forces on edges.
template <class T>
PERCUSS_FORCE_INLINE VectorModes<T> gather_edge_forces(const EdgeField<T>& g) {
  const T quarter = number<T>(0.25);
  VectorModes<T> f;
  for (int m = 1; m <= 7; ++m) f[m] = {T(0), T(0), T(0)};
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const Vector3<T> low = g.along[k][0] + g.along[k][1], high = g.along[k][2] + g.along[k][3];
    const Vector3<T> low_change = g.along[k][1] - g.along[k][0], high_change = g.along[k][3] - g.along[k][2];
    f[1 + k] = quarter * (low + high);
    f[4 + l] = f[4 + l] + quarter * (high - low);
    f[4 + m] = f[4 + m] + quarter * (low_change + high_change);
    f[7] = f[7] + quarter * (high_change - low_change);
  }
  return f;
}

template <class T>
struct CornerShares {
  T share[8];  // r, by corner in the order of find_edge()
};

template <class T>
PERCUSS_FORCE_INLINE CornerShares<T> find_corner_shares(const EdgeField<T>& edges, const T& volume) {
  const T inverse = T(1) / volume;
  CornerShares<T> out;
  for (int i = 0; i < 8; ++i) {
    const Vector3<T>&e1 = edges.along[0][find_edge(i, 0)], &e2 = edges.along[1][find_edge(i, 1)],
          &e3 = edges.along[2][find_edge(i, 2)];
    out.share[i] = inverse * dot(e1, cross(e2, e3));
  }
  return out;
}

template <class T>
PERCUSS_FORCE_INLINE T find_smallest_share(const CornerShares<T>& shares) {
  T least = shares.share[0];
  for (int i = 1; i < 8; ++i) least = smaller(least, shares.share[i]);
  return least;
}

/// Size of the resistance of an element.
template <class T>
struct FoldRule {
  T modulus;    // k
  T threshold;  // r0
};

template <class T>
struct FoldForces {
  VectorModes<T> mode;  // dW/da
  T energy;
};

/// dW = k sum_I [psi' (dJ - r dV) + psi dV]; zero where no corner is below the threshold.
template <class T>
PERCUSS_FORCE_INLINE FoldForces<T> find_fold_forces(const FoldRule<T>& rule, const EdgeField<T>& edges,
                                                    const CornerShares<T>& shares, const VolumeGradient<T>& b) {
  const T third = number<T>(1.0 / 3.0), stiffness = rule.modulus * (T(1) / rule.threshold);
  EdgeField<T> g;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 4; ++i) g.along[k][i] = {T(0), T(0), T(0)};
  }
  T energy(0), pressure(0);
  for (int i = 0; i < 8; ++i) {
    const T depth = larger(rule.threshold - shares.share[i], T(0));
    const T weight = stiffness * depth * depth;
    energy = energy + third * weight * depth;
    pressure = pressure + weight * (third * depth + shares.share[i]);
    const int p = find_edge(i, 0), q = find_edge(i, 1), s = find_edge(i, 2);
    const Vector3<T>&e1 = edges.along[0][p], &e2 = edges.along[1][q], &e3 = edges.along[2][s];
    g.along[0][p] = g.along[0][p] - weight * cross(e2, e3);
    g.along[1][q] = g.along[1][q] - weight * cross(e3, e1);
    g.along[2][s] = g.along[2][s] - weight * cross(e1, e2);
  }
  FoldForces<T> out{gather_edge_forces(g), b.volume * energy};
  const T scale = number<T>(1.0 / 64.0) * pressure;
  for (int m = 1; m <= 6; ++m) out.mode[m] = out.mode[m] + scale * b[m];
  return out;
}

/// Upper bound of the largest eigenvalue of the Hessian of W over the corners' positions, where no corner goes deeper
/// than `depth` (of r0 - r, by corner; 0: it stays above the threshold):
///   k sum_I [ psi'' (|dJ| + |r| |dV|)^2 / V + |psi'| (|ddJ| + max(r0, 2 depth / 3) |ddV|) ]
/// with psi'' = 2 depth / r0 and |psi'| = depth^2 / r0, which grow with the depth,
/// |dJ|^2 = sum |A_k|^2 + |sum A_k|^2, A_k the products of two edges, |ddJ| <= 4 sum |e_k| (three edges that share
/// a node, whose graph has the eigenvalue 4) and |ddV| <= |a| / 3 (the bilinear form of the modes, row by row).
template <class T>
PERCUSS_FORCE_INLINE T bound_fold_stiffness(const FoldRule<T>& rule, const EdgeField<T>& edges,
                                            const CornerShares<T>& shares, const CornerShares<T>& depth,
                                            const VolumeGradient<T>& b, const VectorModes<T>& a) {
  T modes(0), gradient(0);
  for (int m = 1; m <= 7; ++m) modes = modes + dot(a[m], a[m]);
  for (int m = 1; m <= 6; ++m) gradient = gradient + dot(b[m], b[m]);
  const T second = number<T>(1.0 / 3.0) * square_root(modes);      // |ddV|
  const T first = square_root(number<T>(1.0 / 512.0) * gradient);  // |dV|
  const T inverse = T(1) / b.volume;
  T sum(0);
  for (int i = 0; i < 8; ++i) {
    const Vector3<T>&e1 = edges.along[0][find_edge(i, 0)], &e2 = edges.along[1][find_edge(i, 1)],
          &e3 = edges.along[2][find_edge(i, 2)];
    const Vector3<T> a1 = cross(e2, e3), a2 = cross(e3, e1), a3 = cross(e1, e2);
    const Vector3<T> first_two =
        (i & 1) == ((i >> 1) & 1) ? a1 + a2 : a1 - a2;  // edges lead away from the corner or to it
    const Vector3<T> all = (i & 1) == ((i >> 2) & 1) ? first_two + a3 : first_two - a3;
    const T of_jacobian = square_root(dot(a1, a1) + dot(a2, a2) + dot(a3, a3) + dot(all, all));
    const T length = square_root(dot(e1, e1)) + square_root(dot(e2, e2)) + square_root(dot(e3, e3));
    const T size = larger(shares.share[i], -shares.share[i]);
    const T slope = of_jacobian + larger(size, rule.threshold) * first;
    const T pull = larger(rule.threshold, number<T>(2.0 / 3.0) * depth.share[i]);
    sum = sum + depth.share[i] * (T(2) * slope * slope * inverse + depth.share[i] * (T(4) * length + pull * second));
  }
  return rule.modulus * (T(1) / rule.threshold) * sum;
}

/// Whether a corner of an element of the pack is near the threshold or below it.
template <class T>
PERCUSS_FORCE_INLINE bool is_near_folding(const T& threshold, const VectorModes<T>& a, const T& volume) {
  return any(find_smallest_share(find_corner_shares(find_edges(a), volume)) < threshold + number<T>(fold_margin));
}

/// What the resistance of an element is over a step.
template <class T>
struct FoldStep {
  VectorModes<T> force;  // by mode, at n+1; they resist the motion
  T work;                // put in over the step, by the trapezoid
  T stiffness;           // bound for the next step
  T depth;               // r0 - r of the sharpest corner at n+1; positive: it resists
};

/// The motion of an element over a step.
template <class T>
struct FoldMotion {
  const VectorModes<T>& end;   // modes of x(n+1)
  const VectorModes<T>& rate;  // of v(n+1/2)
  T dt;
};

/// The next step is taken to bring the corners as far as this one has.
template <class T>
PERCUSS_FORCE_INLINE FoldStep<T> resist_folding(const FoldRule<T>& rule, const FoldMotion<T>& motion) {
  const VectorModes<T>&a = motion.end, &v = motion.rate;
  const T& dt = motion.dt;
  VectorModes<T> start;
  for (int m = 1; m <= 7; ++m) start[m] = a[m] - dt * v[m];
  const VolumeGradient<T> start_b = find_volume_gradient(start);
  const EdgeField<T> start_edges = find_edges(start);
  const CornerShares<T> before = find_corner_shares(start_edges, start_b.volume);
  const FoldForces<T> old = find_fold_forces(rule, start_edges, before, start_b);

  const VolumeGradient<T> b = find_volume_gradient(a);
  const EdgeField<T> edges = find_edges(a);
  const CornerShares<T> now = find_corner_shares(edges, b.volume);
  const FoldForces<T> force = find_fold_forces(rule, edges, now, b);

  const T least = find_smallest_share(now), near = rule.threshold + number<T>(fold_margin);
  CornerShares<T> depth;
  for (int i = 0; i < 8; ++i) {
    const T closing = larger(before.share[i] - now.share[i], T(0));
    depth.share[i] = select(least < near, larger(rule.threshold - now.share[i] + closing, T(0)), T(0));
  }
  T power(0);
  for (int m = 1; m <= 7; ++m) power = power + dot(old.mode[m] + force.mode[m], v[m]);
  return {force.mode, number<T>(0.5) * dt * power, bound_fold_stiffness(rule, edges, now, depth, b, a),
          rule.threshold - least};
}

/// The step bound with the resistance: `step` is that of the element without it, which counts as all damping, the
/// safer of what it may be.
template <class T>
PERCUSS_FORCE_INLINE T join_fold_step(const T& step, const T& stiffness, const T& mass) {
  return find_stable_step(T(8) * stiffness * (T(1) / mass), T(2) / step);
}

/// What the resistance changes of the result of a step (HexResult).
template <class T>
struct FoldResult {
  T work, stable_step;
  bool acted;    // whether it was looked at at all
  bool resists;  // whether an element of the pack resists at n+1
};

/// Adds the resistance to the forces f of advance_hex8, x, y, z. stable_step: that of the element without it. Elements
/// of the pack that do not resist keep every bit.
template <class T>
PERCUSS_FORCE_INLINE FoldResult<T> add_fold_resistance(const FoldRule<T>& rule, const FoldMotion<T>& motion,
                                                       const T& mass, const T& stable_step, T (&f)[3][8]) {
  const FoldStep<T> step = resist_folding(rule, motion);
  const auto acts = step.depth > T(0);
  T g[3][8];
  for (int k = 0; k < 3; ++k) g[k][0] = T(0);
  for (int m = 1; m <= 7; ++m) {
    g[0][m] = step.force[m].x;
    g[1][m] = step.force[m].y;
    g[2][m] = step.force[m].z;
  }
  finish_forces<T>({g[0], g[1], g[2]});
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 8; ++i) f[k][i] = select(acts, f[k][i] + g[k][i], f[k][i]);
  }
  return {step.work, select(step.stiffness > T(0), join_fold_step(stable_step, step.stiffness, mass), stable_step),
          true, any(acts)};
}

}  // namespace percuss
