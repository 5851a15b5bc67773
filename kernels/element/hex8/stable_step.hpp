#pragma once
// A guaranteed bound of the element's largest frequency in the current configuration, and the step it allows.
//
// With G_ij = sum_I B_iI B_jI and lumped corner masses m/8, Rayleigh's quotient of the one-point element is at most
// omega^2 = 8 (lambda tr G + 2 mu g_max) / (m V): the volumetric part is exact (rank one), and the deviatoric one
// follows from |sym L| <= |L|. This tightens the bound of Flanagan and Belytschko (1984). Largest assembled frequency
// <= largest element frequency.

#include "kernels/element/hex8/modes.hpp"
#include "kernels/material/polar.hpp"

namespace percuss {

template <class T>
struct GradientSize {
  Symmetric3<T> square;  // G
  T trace;               // tr G = B:B
  T largest;             // upper bound of the largest eigenvalue of G, exact if the other two are equal
};

/// Adds the dyad v v.
template <class T>
PERCUSS_FORCE_INLINE void add_square(Symmetric3<T>& g, const Vector3<T>& v) {
  g = g + Symmetric3<T>{v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.y * v.z, v.z * v.x};
}

template <class T>
PERCUSS_FORCE_INLINE GradientSize<T> find_gradient_size(const VolumeGradient<T>& b) {
  Symmetric3<T> g{T(0), T(0), T(0), T(0), T(0), T(0)};
  for (int m = 1; m <= 6; ++m) add_square(g, b[m]);
  g = number<T>(1.0 / 512.0) * g;
  return {g, trace(g), bound_largest_eigenvalue(g)};
}

/// Thickness of the element across its thinnest direction: V / sqrt(2 g_max), the edge of a cube.
template <class T>
PERCUSS_FORCE_INLINE T find_thickness(const GradientSize<T>& g, const T& volume) {
  return volume / square_root(T(2) * g.largest);
}

/// How oblique the element's gradient B is to its coordinates X: an upper bound p >= 1 of the square of the norm of the
/// projector B X / V, 1 for a parallelepiped.
///
/// With Y = X X, the projector's square has the eigenvalues of G Y / V^2, of which none is below 1, so that the largest
/// is at most their sum less 2. The hourglass vectors gamma_h = phi_h - B (X phi_h) / V are the images of phi_h under
/// the complementary projector, which has the same norm: |sum c_h gamma_h|^2 <= 8 p |c|^2. And the angle between the
/// spaces of B and of gamma has cos^2 <= 1 - 1/p.
template <class T>
PERCUSS_FORCE_INLINE T find_obliqueness(const VectorModes<T>& a, const GradientSize<T>& g, const T& volume) {
  Symmetric3<T> y{T(0), T(0), T(0), T(0), T(0), T(0)};
  for (int m = 1; m <= 7; ++m) add_square(y, a[m]);
  const T inverse_volume = T(1) / volume;
  return larger(number<T>(0.125) * contract(y, g.square) * (inverse_volume * inverse_volume) - T(2), T(1));
}

/// Bound of omega^2 of the elastic element without hourglass control. lambda, mu: for all lanes, or by lane.
template <class T, class S>
PERCUSS_FORCE_INLINE T find_frequency_square(const GradientSize<T>& g, const T& volume, const T& mass, const S& lambda,
                                             const S& mu) {
  return (number<T>(8 * lambda) * g.trace + number<T>(16 * mu) * g.largest) * ((T(1) / mass) * (T(1) / volume));
}

/// Adds hourglass control to omega^2: `stiffness` bounds the largest eigenvalue of Q over u. The sum of two forms that
/// each see one of two spaces has at most (a + b) / 2 + sqrt((a - b)^2 / 4 + a b cos^2), the larger of the two
/// for a parallelepiped.
template <class T>
PERCUSS_FORCE_INLINE T join_hourglass_frequency(const T& frequency_square, const T& stiffness, const T& mass,
                                                const T& obliqueness) {
  const T half = number<T>(0.5);
  const T aligned = T(64) * stiffness * (T(1) / mass);
  const T hourglass = aligned * obliqueness;
  const T difference = half * (frequency_square - hourglass);
  return half * (frequency_square + hourglass) +
         square_root(difference * difference + frequency_square * aligned * (obliqueness - T(1)));
}

/// Bound of the damping rate (largest eigenvalue of M^-1 C) that a viscous pressure with tangent dq/d(tr D) brings.
template <class T>
PERCUSS_FORCE_INLINE T find_damping_rate(const GradientSize<T>& g, const T& volume, const T& mass, const T& tangent) {
  return T(8) * tangent * g.trace * ((T(1) / mass) * (T(1) / volume));
}

/// Bound of the increase of a step bound by single-precision round-off, with margin: that of positions about a node of
/// the chunk is some 1e-7 of the chunk's extent, which is some hundreds of the thinnest edge at most.
inline constexpr double short_step_margin = 1e-4;

/// Largest dt with omega^2 dt^2 / 4 + rate dt / 2 <= 1: central differences with velocities that lag half a step.
template <class T>
PERCUSS_FORCE_INLINE T find_stable_step(const T& frequency_square, const T& damping_rate) {
  const T half = number<T>(0.5) * damping_rate;
  const T most = number<T>(is_short<T> ? 2 * (1 - short_step_margin) : 2);
  return most / (half + square_root(frequency_square + half * half));
}

}  // namespace percuss
