#pragma once
// The tetrahedron of four corners: its volume, the derivative of that, and its velocity gradient, all exact.

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Places or velocities of the corners.
template <class T>
struct TetCorners {
  Vector3<T> at[4];
  PERCUSS_FORCE_INLINE const Vector3<T>& operator[](int i) const { return at[i]; }
  PERCUSS_FORCE_INLINE Vector3<T>& operator[](int i) { return at[i]; }
};

/// As a shape of the mixed form, beside wedges and pyramids (kernels/one_point/shapes.hpp).
struct Tet4 {
  static constexpr int corners = 4;
};

/// B_I = dV/dx_I. The gradient of a linear field u is sum_I u_I (x) B_I / V.
template <class T>
struct TetGeometry {
  Vector3<T> b[4];
  T volume;
};

/// With the edges a, b, c from corner 0: V = a . (b x c) / 6, B_1 = b x c / 6 and so on, and the four B sum to zero.
template <class T>
PERCUSS_FORCE_INLINE TetGeometry<T> find_tet_geometry(const TetCorners<T>& x) {
  const T sixth = T(1.0 / 6.0);
  const Vector3<T> a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  TetGeometry<T> g;
  g.b[1] = sixth * cross(b, c);
  g.b[2] = sixth * cross(c, a);
  g.b[3] = sixth * cross(a, b);
  g.b[0] = T(-1) * (g.b[1] + g.b[2] + g.b[3]);
  g.volume = dot(a, g.b[1]);
  return g;
}

/// V times the velocity gradient, sum_I v_I (x) B_I; exactly zero for a uniform velocity.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_volume_times_gradient(const TetCorners<T>& v, const TetGeometry<T>& g) {
  Matrix3<T> l{{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}}};
  for (int i = 1; i < 4; ++i) {
    const Vector3<T> u = v[i] - v[0];
    l = l + Matrix3<T>{{u.x * g.b[i], u.y * g.b[i], u.z * g.b[i]}};
  }
  return l;
}

/// Corners half a step before x.
template <class T>
PERCUSS_FORCE_INLINE TetCorners<T> find_middle(const TetCorners<T>& x, const TetCorners<T>& v, const T& dt) {
  const T half_dt = T(0.5) * dt;
  TetCorners<T> middle;
  for (int i = 0; i < 4; ++i) middle[i] = x[i] - half_dt * v[i];
  return middle;
}

/// Names of the same for all shapes of the mixed form.
template <class T, class Shape>
struct ShapeField;
template <class T>
struct ShapeField<T, Tet4> {
  using type = TetCorners<T>;
};
template <class T>
PERCUSS_FORCE_INLINE TetGeometry<T> find_shape_geometry(const TetCorners<T>& x) {
  return find_tet_geometry(x);
}

/// The square of the largest B_I: the least height of the element is V over its root.
template <class T>
PERCUSS_FORCE_INLINE T find_largest_square(const TetGeometry<T>& g) {
  T largest = dot(g.b[0], g.b[0]);
  for (int i = 1; i < 4; ++i) largest = larger(largest, dot(g.b[i], g.b[i]));
  return largest;
}

}  // namespace percuss
