#pragma once
// The bound of the frequency of a thick shell, from the gradients at its points.

#include "kernels/element/hex8/thick_layers.hpp"
#include "kernels/material/elastic.hpp"

namespace percuss {

/// How large the gradient of the element is: sums over columns and extremes over points.
///
/// A velocity w3 along zeta strains as sym(w3 x grad zeta), which meets at most lambda + 2 mu. The assumed strain is a
/// mean of those of the corners, with the length of their edges. Each has two nodes of its own, so that the largest sum
/// of a corner bounds the square of the frequency. Where edges across lean against the layers, or layers are oblique,
/// assumed strains exceed it; the factors hold for random shapes (tests/kernels/element/hex8/thick_shell_test.cpp).
/// Strain within layers comes on top.
template <class T>
struct ThickSize {
  T across[4], along;
  T lean;     // largest tan^2 of the angle between an edge across and the normal of its layer
  T oblique;  // largest 1 / sin^2 of the angle between xi and eta

  PERCUSS_FORCE_INLINE ThickSize() : across{T(0), T(0), T(0), T(0)}, along(0), lean(0), oblique(1) {}

  /// weight: of the rule times 512 det J.
  PERCUSS_FORCE_INLINE void take(int column, const LayerGeometry<T>& at, const Vector3<T>& d3, const T& weight) {
    const T normal = dot(at.g[2], at.g[2]);
    across[column] = across[column] + weight * normal * normal;
    along = along + weight * (dot(at.g[0], at.g[0]) + dot(at.g[1], at.g[1]));
    lean = larger(lean, normal * dot(d3, d3) - T(1));
    const T area = at.volume * at.volume * normal;
    oblique = larger(oblique, dot(at.d[0], at.d[0]) * dot(at.d[1], at.d[1]) / area);
  }

  /// Bound of omega^2 of an element with the corners a and these moduli.
  PERCUSS_FORCE_INLINE T bound(const VectorModes<T>& a, const Moduli<T>& moduli, const T& mass) const {
    constexpr double near = 0.5 * (1 + 0.57735026918962576451), far = 1 - near;
    const T nn = number<T>(near * near), nf = number<T>(near * far), ff = number<T>(far * far);
    T largest(0);
    for (int c = 0; c < 4; ++c) {
      const Vector3<T> low = c < 2 ? a[3] - a[4] : a[3] + a[4], turn = c < 2 ? a[5] - a[7] : a[5] + a[7];
      const Vector3<T> edge = c == 1 || c == 2 ? low + turn : low - turn;
      largest = larger(largest, dot(edge, edge) * (nn * across[c] + nf * (across[(c + 1) % 4] + across[(c + 3) % 4]) +
                                                   ff * across[(c + 2) % 4]));
    }
    const T modulus = moduli.lambda + number<T>(2.0) * moduli.mu;
    const T leaning = T(1) + number<T>(lean_factor) * lean;
    const T own = larger(modulus, number<T>(oblique_factor) * moduli.mu * oblique) * leaning;
    // 8 / m times 64 / 512 of the sums of |g|^2, of which a half is of a node
    return (number<T>(0.5) * own * largest + number<T>(0.125) * modulus * oblique * along) / mass;
  }
  static constexpr double lean_factor = 4, oblique_factor = 2.2;
};

}  // namespace percuss
