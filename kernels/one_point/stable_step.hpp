#pragma once
// A guaranteed bound of the largest frequency of a one-point solid, and of its damping rate.
//
// With corner masses M_I, G = sum_I B_I B_I^T / M_I and c_h = sum_I gamma_h(I) B_I / M_I, the stiffness of the material
// has at most a = (lambda tr G + 2 mu g_max(G)) / V (rank one, and |sym L| <= |L|), that of the hourglass control
// b = kappa w_max(W), W_hk = sum_I gamma_h(I) gamma_k(I) / M_I, exactly. Both together are F F^T with F = (A, H), whose
// largest eigenvalue is that of F^T F: at most (a + b) / 2 + sqrt((a - b)^2 / 4 + s) with
// s = kappa (lambda + 2 mu) / V sum_h |c_h|^2 >= |A^T H|^2, which is zero for a regular element.

#include "kernels/element/hex8/stable_step.hpp"
#include "kernels/one_point/geometry.hpp"

namespace percuss {

/// G and W with the masses as shares of that of the element.
template <class T>
struct GradientSizes {
  T trace, largest;       // of G: tr G; a bound of its largest eigenvalue
  T hourglass, coupling;  // w_max(W); sum_h |c_h|^2
};

/// Largest eigenvalue of W, of one row or of two.
template <class T, int Modes>
PERCUSS_FORCE_INLINE T find_largest_of_modes(const T (&w)[Modes][Modes]) {
  static_assert(Modes == 1 || Modes == 2);
  if constexpr (Modes == 1) {
    return w[0][0];
  } else {
    const T half(0.5), difference = half * (w[0][0] - w[1][1]);
    return half * (w[0][0] + w[1][1]) + square_root(difference * difference + w[0][1] * w[0][1]);
  }
}

template <class T, class Shape>
PERCUSS_FORCE_INLINE GradientSizes<T> find_gradient_sizes(const CornerGradient<T, Shape>& g,
                                                          const HourglassVectors<T, Shape>& gamma) {
  Symmetric3<T> square{T(0), T(0), T(0), T(0), T(0), T(0)};
  repeat<Shape::corners>([&](auto i) {
    constexpr double weight = 1 / Shape::mass_share[i];
    const Vector3<T>& b = g.b[i];
    square = square + T(weight) * Symmetric3<T>{b.x * b.x, b.y * b.y, b.z * b.z, b.x * b.y, b.y * b.z, b.z * b.x};
  });
  T w[Shape::modes][Shape::modes], coupling(0);
  repeat<Shape::modes>([&](auto h) {
    Vector3<T> c{T(0), T(0), T(0)};
    repeat<Shape::modes>([&](auto k) { w[h][k] = T(0); });
    repeat<Shape::corners>([&](auto i) {
      constexpr double weight = 1 / Shape::mass_share[i];
      const T weighted = T(weight) * gamma.of[h][i];
      c = c + weighted * g.b[i];
      repeat<Shape::modes>([&](auto k) { w[h][k] = w[h][k] + weighted * gamma.of[k][i]; });
    });
    coupling = coupling + dot(c, c);
  });
  return {trace(square), bound_largest_eigenvalue(square), find_largest_of_modes(w), coupling};
}

/// The way of a wave in the largest step of the free element, 2 V / sqrt(g_max): of a cube its edge.
template <class T>
PERCUSS_FORCE_INLINE T find_thickness(const GradientSizes<T>& size, const T& volume) {
  return T(2) * volume / square_root(size.largest);
}

/// Stiffness of an element against its motion.
template <class T>
struct OnePointStiffness {
  T lambda, mu;  // of the material; lambda >= 0
  T hourglass;   // kappa
  T tangent;     // of the viscous pressure
};

/// The step that it allows.
template <class T>
PERCUSS_FORCE_INLINE T find_one_point_step(const GradientSizes<T>& size, const T& volume, const T& mass,
                                           const OnePointStiffness<T>& of) {
  const T half(0.5), over_mass = T(1) / mass, over_volume = T(1) / volume, over_both = over_mass * over_volume;
  const T a = (of.lambda * size.trace + T(2) * of.mu * size.largest) * over_both;
  const T b = of.hourglass * size.hourglass * over_mass;
  const T s = of.hourglass * (of.lambda + T(2) * of.mu) * size.coupling * (over_mass * over_both);
  const T difference = half * (a - b);
  return find_stable_step(half * (a + b) + square_root(difference * difference + s),
                          of.tangent * size.trace * over_both);
}

}  // namespace percuss
