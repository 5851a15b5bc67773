#pragma once
// A guaranteed bound of the element's largest frequency in the current configuration, and the step it allows.
//
// With G_ij = sum_I B_iI B_jI and lumped corner masses m/8, Rayleigh's quotient of the one-point element is at most
// omega^2 = 8 (lambda tr G + 2 mu g_max) / (m V): the volumetric part is exact (rank one), and the deviatoric one
// follows from |sym L| <= |L|. This tightens the bound of Flanagan and Belytschko (1984). Largest assembled frequency
// <= largest element frequency.

#include "kernels/element/modes.hpp"

namespace percuss {

template <class T>
struct GradientSize {
  T trace;    // tr G = B:B
  T largest;  // upper bound of the largest eigenvalue of G, exact if the other two are equal
};

/// tr G and g_max <= tr G / 3 + sqrt(2/3) |dev G|.
template <class T>
KOKKOS_INLINE_FUNCTION GradientSize<T> find_gradient_size(const VolumeGradient<T>& b) {
  Symmetric3<T> g{b[1].x * b[1].x, b[1].y * b[1].y, b[1].z * b[1].z, b[1].x * b[1].y, b[1].y * b[1].z, b[1].z * b[1].x};
  for (int m = 2; m <= 6; ++m) {
    g.xx = g.xx + b[m].x * b[m].x;
    g.yy = g.yy + b[m].y * b[m].y;
    g.zz = g.zz + b[m].z * b[m].z;
    g.xy = g.xy + b[m].x * b[m].y;
    g.yz = g.yz + b[m].y * b[m].z;
    g.zx = g.zx + b[m].z * b[m].x;
  }
  const T scale = T(1.0 / 512.0);
  const T sum = trace(g);
  const T mean = T(1.0 / 3.0) * sum;
  const Symmetric3<T> deviator{g.xx - mean, g.yy - mean, g.zz - mean, g.xy, g.yz, g.zx};
  return {scale * sum, scale * (mean + square_root(T(2.0 / 3.0) * contract(deviator, deviator)))};
}

/// Thickness of the element across its thinnest direction: V / sqrt(2 g_max), the edge of a cube.
template <class T>
KOKKOS_INLINE_FUNCTION T find_thickness(const GradientSize<T>& g, const T& volume) {
  return volume / square_root(T(2) * g.largest);
}

/// Bound of omega^2 of the elastic element.
template <class T>
KOKKOS_INLINE_FUNCTION T find_frequency_square(const GradientSize<T>& g, const T& volume, const T& mass, double lambda,
                                               double mu) {
  return T(8) * (T(lambda) * g.trace + T(2 * mu) * g.largest) / (mass * volume);
}

/// Bound of the damping rate (largest eigenvalue of M^-1 C) that a viscous pressure with tangent dq/d(tr D) brings.
template <class T>
KOKKOS_INLINE_FUNCTION T find_damping_rate(const GradientSize<T>& g, const T& volume, const T& mass, const T& tangent) {
  return T(8) * tangent * g.trace / (mass * volume);
}

/// Largest dt with omega^2 dt^2 / 4 + rate dt / 2 <= 1: central differences with velocities that lag half a step.
template <class T>
KOKKOS_INLINE_FUNCTION T find_stable_step(const T& frequency_square, const T& damping_rate) {
  const T half = T(0.5) * damping_rate;
  return T(2) / (half + square_root(frequency_square + half * half));
}

}  // namespace percuss
