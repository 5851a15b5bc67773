#pragma once
// Axes 1, 2, 3 of a material in space at the start, from two directions of a deck.

#include "kernels/core/tensor.hpp"

namespace percuss {

inline Vector3<double> make_direction(const double (&a)[3]) { return {a[0], a[1], a[2]}; }

inline bool are_parallel(const Vector3<double>& a, const Vector3<double>& b) {
  return !(norm(cross(a, b)) > 1e-6 * norm(a) * norm(b));
}

/// Where the deck gives none, which is zeros: y, or z if axis 1 is along y.
inline Vector3<double> find_second_direction(const double (&first)[3], const double (&second)[3]) {
  const Vector3<double> given = make_direction(second), y{0, 1, 0}, z{0, 0, 1};
  if (norm(given) > 0) return given;
  return are_parallel(make_direction(first), y) ? z : y;
}

/// Whether they are directions of axes. second: as given.
inline bool are_axes(const double (&first)[3], const double (&second)[3]) {
  return !are_parallel(make_direction(first), find_second_direction(first, second));
}

/// Rows: the axes 1, 2, 3.
inline Matrix3<double> find_material_axes(const double (&first)[3], const double (&second)[3]) {
  const Vector3<double> one = make_direction(first), normal = cross(one, find_second_direction(first, second));
  const Vector3<double> unit = (1 / norm(one)) * one, three = (1 / norm(normal)) * normal;
  return {{unit, cross(three, unit), three}};
}

}  // namespace percuss
