#pragma once
// The wedge and the pyramid as shapes of a one-point element: corners, faces, shares of the mass, hourglass vectors.
//
// A shape with these numbers is all that geometry.hpp and one_point.hpp need of an element.

#include <utility>

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Six corners in the order of Exodus: a triangle, then the one across (src/mesh/topology/wedge6.hpp).
struct Wedge6 {
  static constexpr int corners = 6, faces = 5, modes = 2;
  /// Outward; a triangle has its last corner twice.
  static constexpr int face[faces][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1, 1}, {3, 4, 5, 5}};
  static constexpr double mass_share[corners] = {1.0 / 6, 1.0 / 6, 1.0 / 6, 1.0 / 6, 1.0 / 6, 1.0 / 6};
  /// What is left of zeta times the fields of the triangle: orthogonal unit vectors. 1 / sqrt(12).
  static constexpr double unit = 0.28867513459481288225;
  static constexpr double mode[modes][corners] = {{0.5, -0.5, 0, -0.5, 0.5, 0},
                                                  {unit, unit, -2 * unit, -unit, -unit, 2 * unit}};
};

/// Five corners: the base, then the apex (src/mesh/topology/pyramid5.hpp).
struct Pyramid5 {
  static constexpr int corners = 5, faces = 5, modes = 1;
  static constexpr int face[faces][4] = {{0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {0, 4, 3, 3}, {0, 3, 2, 1}};
  static constexpr double mass_share[corners] = {3.0 / 16, 3.0 / 16, 3.0 / 16, 3.0 / 16, 1.0 / 4};
  static constexpr double mode[modes][corners] = {{0.5, -0.5, 0.5, -0.5, 0}};
};

/// Calls f(std::integral_constant) for 0 to N - 1: indices stay constants, tables of shapes need no memory.
template <int N, class F>
PERCUSS_FORCE_INLINE void repeat(const F& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) { (f(std::integral_constant<int, I>()), ...); }
  (std::make_integer_sequence<int, N>());
}

}  // namespace percuss
