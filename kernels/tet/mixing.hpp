#pragma once
// The twice-averaged volume rate of tetrahedra: what an element takes from the averages at its nodes, and gives to
// them.
//
// A tetrahedron that keeps its own volume rate locks: four corners share too few degrees of freedom with their
// neighbours. Averaged from elements to nodes and back, the volume rate leaves them free (Bonet and Burton, Comm. Num.
// Meth. Eng. 14, 1998, averages once). A share of the deviator is averaged likewise, which takes the stiffness off
// bending (in the way of the alpha-FEM of Nguyen-Thoi et al. 2010). What the stresses give to the nodes is averaged by
// the transpose, so that the power of the forces is that of the stresses. docs/theory_tetrahedra.md has it all.

#include "kernels/material/point_step.hpp"
#include "kernels/material/polar.hpp"
#include "kernels/tet/geometry.hpp"

namespace percuss {

/// Share of the averaged deviator. Its average follows from no energy of the deformation: under stresses as large as
/// the moduli it would feed vibrations. So laws of rubber and foam (is_stretched_far()) have none.
inline constexpr double tet_deviator_share = 0.3;

/// e^x, relative to 1e-14 for |x| <= 2, 1e-12 to 4 and 1e-9 to 8: the series at x / 32 and five squarings, without a
/// call by lane.
template <class T>
PERCUSS_FORCE_INLINE T find_power_of_e(const T& x) {
  const T r = T(1.0 / 32) * x;
  T sum = T(1);
  for (int k = 8; k > 0; --k) sum = T(1) + T(1.0 / k) * r * sum;
  for (int k = 0; k < 5; ++k) sum = sum * sum;
  return sum;
}

/// Volume that the material has seen, which is averaged, over that of the element, at n and n+1.
template <class T>
struct MaterialVolume {
  T before, now;
};

/// gap: integral of the element's volume rate less the averaged one, at n+1; change: of it in the step. Stresses act in
/// this volume: the power of the forces is then that of an energy of the deformation (docs/theory_tetrahedra.md).
template <class T>
PERCUSS_FORCE_INLINE MaterialVolume<T> find_material_volume(const T& gap, const T& change) {
  const T one(1), now = find_power_of_e(T(0) - gap);
  return {now * (one + change * (one + T(0.5) * change * (one + T(1.0 / 3.0) * change))), now};
}

/// Averages are blind to a single element that collapses while its neighbours grow. Beyond the difference of
/// logarithmic volume `start` a pressure of its own resists, with the share `stiffness` of the bulk modulus.
struct TetGuard {
  static constexpr double stiffness = 0.2, start = 0.5;
};

template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> add_to_diagonal(const Symmetric3<T>& a, const T& p) {
  return {a.xx + p, a.yy + p, a.zz + p, a.xy, a.yz, a.zx};
}

/// (1 - share) dev own + share dev mean + tr mean / 3 I.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> blend(const Symmetric3<T>& own, const Symmetric3<T>& mean, const T& share) {
  const T rest = T(1) - share, third = T(1.0 / 3.0);
  return add_to_diagonal(rest * own + share * mean, third * rest * (trace(mean) - trace(own)));
}

/// Pressure of the guard, positive in tension as stresses are. gap: integral of the element's volume rate less the
/// averaged one.
template <class T>
PERCUSS_FORCE_INLINE T find_guard(const T& gap, double bulk_modulus) {
  return T(TetGuard::stiffness * bulk_modulus) * smaller(gap + T(TetGuard::start), T(0));
}

/// What an element and its material differ by in volume, and the guard against too much of it. change: of the gap in
/// the step; guard_work: out.
template <class T, class Parameters, class State>
PERCUSS_FORCE_INLINE MaterialVolume<T> advance_gap(const Parameters& par, const T& change, const T& half_volume,
                                                   State& state, T& guard_work) {
  state.gap = state.gap + change;
  const T guard = find_guard(state.gap, par.lambda + 2.0 / 3.0 * par.mu);
  guard_work = half_volume * (state.guard + guard) * change;
  state.guard = guard;
  return find_material_volume(state.gap, change);
}

/// Numbers that elements give to a node, in groups of four of which the last of a row is unused.
/// Rates: V D / 4 with V / 4 after xx, yy and zz: one cache line. Stresses: V (sigma - g I) / 4 with V K / 4 after xx,
/// yy and zz, V mu / 4 after xy, yz and zx; then V / 4, m / 4, |B_I|^2 / V. Averages lie as their sums do.
struct TetSums {
  static constexpr int rate_groups = 2, stress_groups = 3;
  static constexpr int rate_row = 4 * rate_groups, stress_row = 4 * stress_groups;
  static constexpr int average_row = 8;
  static constexpr int volume_of_rates = 3;
  static constexpr int volume = 8, mass = 9, square = 10;  // of stresses
};

/// Change of volume in the step, for laws whose Kirchhoff stress grows: that of the material. before, after: V of the
/// element at n and n+1.
template <class T>
PERCUSS_FORCE_INLINE VolumeChange<T> find_volume_change(const MaterialVolume<T>& ratio, const Symmetric3<T>& before,
                                                        const Symmetric3<T>& after) {
  const T j = ratio.now * determinant(full(after));
  return {j - ratio.before * determinant(full(before)), T(1) / j};
}

/// What an element takes from the averages of the rates at its nodes.
template <class T>
struct MeanRate {
  Symmetric3<T> rate;
  T deviator_share;
};

/// Averages of stress and moduli at a node.
template <class T>
struct TetMeans {
  Symmetric3<T> stress;
  T bulk, shear;
};

/// Bound of the square of the largest frequency of the elements together, and of the damping rate.
///
/// The averages are convex, so that sum_e V_e K (tr mean D)^2 <= sum_e V_e K_mean (tr D_e)^2 with K_mean averaged twice
/// as rates are (Jensen's inequality): the averaged stiffness is at most that of plain elements with these moduli. And
/// a node's mass may be shared among its elements in any way, here by |B_I|^2 / V: of an element with corner masses
/// w_I, omega^2 <= (lambda tr G + 2 mu g_max(G)) / V with G = sum_I B_I B_I^T / w_I.
template <class T>
struct TetStiffness {
  T bulk, shear;  // bounds of the moduli that the element feels
  T tangent;      // of bulk viscosity
};

template <class T>
struct TetFrequency {
  T square, damping_rate;
};

/// weights: 1 / w_I by corner.
template <class T>
PERCUSS_FORCE_INLINE TetFrequency<T> bound_tet_frequency(const TetGeometry<T>& g, const T (&weights)[4],
                                                         const TetStiffness<T>& of) {
  Symmetric3<T> square{T(0), T(0), T(0), T(0), T(0), T(0)};
  for (int i = 0; i < 4; ++i) {
    const Vector3<T>& b = g.b[i];
    square = square + weights[i] * Symmetric3<T>{b.x * b.x, b.y * b.y, b.z * b.z, b.x * b.y, b.y * b.z, b.z * b.x};
  }
  const T over_volume = T(1) / g.volume, size = trace(square);
  const T lambda = larger(of.bulk - T(2.0 / 3.0) * of.shear, T(0));
  return {over_volume * (lambda * size + T(2) * of.shear * bound_largest_eigenvalue(square)),
          over_volume * of.tangent * size};
}

}  // namespace percuss
