#pragma once
// Volume and corner Jacobians of a trilinear hexahedron; area of a shell.

#include <array>
#include <cmath>
#include <cstddef>

#include "src/mesh/mesh.hpp"

namespace percuss {

using HexCorners = std::array<Vec3, 8>;

/// The three corners joined to a corner by an edge, right-handed (Exodus II order).
inline constexpr int hex_corner_neighbors[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                                   {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

inline Vec3 subtract(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double find_distance(const Vec3& a, const Vec3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double triple_product(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(a, cross(b, c)); }

inline Vec3 add(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Area vector of a shell, along its normal: half the cross product of its diagonals.
inline Vec3 find_shell_area(const HexCorners& x) {
  const Vec3 twice = cross(subtract(x[2], x[0]), subtract(x[3], x[1]));
  return {0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2]};
}

/// Its size [length^2].
inline double find_shell_area_size(const HexCorners& x) {
  const Vec3 area = find_shell_area(x);
  return std::sqrt(dot(area, area));
}

/// Exact volume of the trilinear hexahedron [length^3]; it equals the mean-quadrature volume of Flanagan and Belytschko
/// (1981, equation 14). By the divergence theorem: a bilinear face halves the tetrahedron of its four corners, so its
/// share is the mean of its two triangulations.
inline double find_hex_volume(const HexCorners& x) {
  double volume = 0;
  for (const auto& face : hex_faces) {
    const auto corner = [&](int i) { return subtract(x[static_cast<std::size_t>(face[i])], x[0]); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    volume += triple_product(a, b, add(c, d)) + triple_product(add(a, b), c, d);
  }
  return volume / 12;
}

/// Jacobian at a corner: the triple product of its three edges [length^3], and that of their lengths for comparison.
struct CornerJacobian {
  double value = 0;
  double edge_product = 0;
};
inline CornerJacobian find_corner_jacobian(const HexCorners& x, int corner) {
  const auto edge = [&](int i) {
    return subtract(x[static_cast<std::size_t>(hex_corner_neighbors[corner][i])], x[static_cast<std::size_t>(corner)]);
  };
  const Vec3 a = edge(0), b = edge(1), c = edge(2);
  return {triple_product(a, b, c), std::sqrt(dot(a, a)) * std::sqrt(dot(b, b)) * std::sqrt(dot(c, c))};
}

}  // namespace percuss
