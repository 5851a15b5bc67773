#pragma once
// Forces that move the weight and the inertia of an element from the mean of its corners, where lumped masses have
// them, to the centroid of the trilinear hexahedron, in modes.

#include "kernels/core/element_family.hpp"
#include "kernels/element/hex8/gauss_points.hpp"

namespace percuss {

/// Wedges and pyramids are hexahedra of which corners coincide: their faces, and so their centroids, are the same.
struct Collapsed {
  int corner[8];    // of the element
  double share[8];  // of its mass
  bool is_whole;    // every corner has an eighth
};

KOKKOS_INLINE_FUNCTION Collapsed find_collapsed(ElementFamily family) {
  constexpr double sixth = 1.0 / 6, twelfth = 1.0 / 12, base = 3.0 / 16, apex = 1.0 / 16, eighth = 1.0 / 8;
  if (family == ElementFamily::wedges)
    return {{0, 1, 2, 2, 3, 4, 5, 5}, {sixth, sixth, twelfth, twelfth, sixth, sixth, twelfth, twelfth}, false};
  if (family == ElementFamily::pyramids)
    return {{0, 1, 2, 3, 4, 4, 4, 4}, {base, base, base, base, apex, apex, apex, apex}, false};
  return {{0, 1, 2, 3, 4, 5, 6, 7}, {eighth, eighth, eighth, eighth, eighth, eighth, eighth, eighth}, true};
}

/// Largest difference of pressure across an element that counts as weight, as a share of its bulk modulus: larger ones
/// are waves, in which inertia at the corners is as good. Water at rest has some 1e-7, one of a hundredth of its
/// stiffness 1e-4.
inline constexpr double most_jump = 1e-3;

/// Share of the apparent weight g - a of a unit of mass that counts: all of it up to twice gravity, or up to most_jump.
/// a: modes of the places; mass: of the element, with what mass scaling added.
template <class T>
PERCUSS_FORCE_INLINE T find_weight_share(const VectorModes<T>& a, const T& mass, const Vector3<T>& weight,
                                         const Vector3<T>& gravity, const T& bulk_modulus) {
  const T tiny = number<T>(1e-150);
  const T x = dot(weight, a[1]), y = dot(weight, a[2]), z = dot(weight, a[3]);
  const T jump = number<T>(0.25) * square_root(x * x + y * y + z * z);  // an edge is a quarter of a mode
  const T volume = number<T>(1.0 / 64) * larger(dot(a[1], cross(a[2], a[3])), T(0));
  const T of_wave = number<T>(most_jump) * bulk_modulus * volume / larger(mass * jump, tiny);
  const T of_gravity = T(2) * norm(gravity) / larger(norm(weight), tiny);
  return smaller(T(1), larger(of_wave, of_gravity));
}

/// Corner forces f = -m d(w . (xc - mean of the corners))/dx, which the element's motion does work against, as those of
/// its stress. They add up to nothing. xc = int x dV / V of the trilinear hexahedron, exact with 2x2x2 points: a
/// pressure of the gradient m w / V without a mean, and the weight by the shape functions less that by the corners.
/// a: modes of the places; weight: w, of a unit of mass.
template <class T>
PERCUSS_NO_INLINE void find_centroid_forces(const VectorModes<T>& a, const T& mass, const Vector3<T>& weight,
                                            T (&f)[3][8]) {
  constexpr double r = 0.57735026918962576451;  // modes at the points: a factor for each of xi, eta, zeta
  constexpr double at_points[8] = {1, r, r, r, r * r, r * r, r * r, r * r * r};
  T s[8], j[8];  // -w . x and 512 det J by point
  s[0] = T(0);
  for (int m = 1; m < 8; ++m) s[m] = number<T>(-at_points[m] / 8) * dot(weight, a[m]);
  to_corners(s);
  PointGeometry<T> points[8];
  T volume(0), moment(0);
  for (int p = 0; p < 8; ++p) {
    points[p] = find_point_geometry(a, find_gauss_point(p));
    j[p] = points[p].volume;
    volume = volume + j[p];
    moment = moment + j[p] * s[p];
  }
  const T inverse = T(1) / volume, mean = moment * inverse;
  VectorModes<T> sums;
  for (int m = 1; m <= 7; ++m) sums[m] = {T(0), T(0), T(0)};
  for (int p = 0; p < 8; ++p) {
    const T pressure = s[p] - mean;
    add_point_force(Symmetric3<T>{pressure, pressure, pressure, T(0), T(0), T(0)}, points[p], find_gauss_point(p),
                    sums);
  }
  to_modes(j);
  const T scale = mass * inverse;  // volume and forces are 512 times too large
  for (int k = 0; k < 3; ++k) f[k][0] = T(0);
  for (int m = 1; m <= 7; ++m) {
    const Vector3<T> of_mode = scale * (sums[m] - (number<T>(at_points[m] / 8) * j[m]) * weight);
    f[0][m] = of_mode.x;
    f[1][m] = of_mode.y;
    f[2][m] = of_mode.z;
  }
  for (int k = 0; k < 3; ++k) to_corners(f[k]);
}

/// What these forces have to be more where the corners have other shares of the mass than an eighth: with the mean of
/// the mass in place of the mean of the corners.
template <class T>
PERCUSS_NO_INLINE void add_weight_of_shares(const Collapsed& shape, const T& mass, const Vector3<T>& weight,
                                            T (&f)[3][8]) {
  for (int corner = 0; corner < 8; ++corner) {
    const T more = number<T>(shape.share[corner] - 0.125) * mass;
    f[0][corner] = f[0][corner] + more * weight.x;
    f[1][corner] = f[1][corner] + more * weight.y;
    f[2][corner] = f[2][corner] + more * weight.z;
  }
}

}  // namespace percuss
