#pragma once
// Volume, mean gradient and hourglass vectors of a one-point solid, all exact for its bilinear and flat faces.
//
// The mean over the volume of the gradient of a corner's shape function is B_I / V with B_I = dV/dx_I, as of the
// hexahedron (Flanagan and Belytschko 1981). V is a sum over faces by the divergence theorem: a bilinear face counts as
// the mean of its two triangulations. The gradient at the centre of a distorted wedge misses the patch test by 3 %.

#include "kernels/one_point/shapes.hpp"
#include "kernels/tet/geometry.hpp"

namespace percuss {

/// Places, velocities or forces of the corners.
template <class T, class Shape>
struct CornerField {
  Vector3<T> at[Shape::corners];
  PERCUSS_FORCE_INLINE const Vector3<T>& operator[](int i) const { return at[i]; }
  PERCUSS_FORCE_INLINE Vector3<T>& operator[](int i) { return at[i]; }
};

/// B_I = dV/dx_I, which sum to zero. The mean gradient of a field u is sum_I u_I (x) B_I / V, that of a linear one
/// its own.
template <class T, class Shape>
struct CornerGradient {
  Vector3<T> b[Shape::corners];
  T volume;
};

/// A vector for each hourglass mode.
template <class T, class Shape>
struct ModeVectors {
  Vector3<T> at[Shape::modes];
};

/// u_I - u_0 for each corner.
template <class T, class Shape>
PERCUSS_FORCE_INLINE CornerField<T, Shape> subtract_first(const CornerField<T, Shape>& u) {
  CornerField<T, Shape> r;
  repeat<Shape::corners>([&](auto i) { r[i] = u[i] - u[0]; });
  return r;
}

/// Adds 12 dV/dx of a face to its corners, with r = x - x_0: of the triangle a b c 12 V = 2 a . (b x c), of the
/// bilinear face a b c d a . (b x c) + a . (c x d) + a . (b x d) + b . (c x d).
template <int F, class T, class Shape>
PERCUSS_FORCE_INLINE void add_face(const CornerField<T, Shape>& r, CornerGradient<T, Shape>& g) {
  constexpr int ia = Shape::face[F][0], ib = Shape::face[F][1], ic = Shape::face[F][2], id = Shape::face[F][3];
  const Vector3<T>&a = r[ia], &b = r[ib], &c = r[ic], &d = r[id];
  const Vector3<T> ab = cross(a, b), bc = cross(b, c);
  if constexpr (ic == id) {
    const T two(2);
    g.b[ia] = g.b[ia] + two * bc;
    g.b[ib] = g.b[ib] + two * cross(c, a);
    g.b[ic] = g.b[ic] + two * ab;
  } else {
    const Vector3<T> cd = cross(c, d), da = cross(d, a), ac = cross(a, c), bd = cross(b, d);
    g.b[ia] = g.b[ia] + (bc + cd + bd);
    g.b[ib] = g.b[ib] + (cd + da - ac);
    g.b[ic] = g.b[ic] + (da + ab - bd);
    g.b[id] = g.b[id] + (ab + bc + ac);
  }
}

/// x: places of the corners. 3 V = sum_I x_I . B_I, since V is of the third degree in them.
template <class T, class Shape>
PERCUSS_FORCE_INLINE CornerGradient<T, Shape> find_corner_gradient(const CornerField<T, Shape>& x) {
  const CornerField<T, Shape> r = subtract_first(x);
  const Vector3<T> zero{T(0), T(0), T(0)};
  CornerGradient<T, Shape> g;
  repeat<Shape::corners>([&](auto i) { g.b[i] = zero; });
  repeat<Shape::faces>([&](auto f) { add_face<f>(r, g); });
  const T twelfth(1.0 / 12.0);
  Vector3<T> sum = zero;
  T volume(0);
  repeat<Shape::corners - 1>([&](auto k) {
    constexpr int i = k + 1;
    g.b[i] = twelfth * g.b[i];
    sum = sum + g.b[i];
    volume = volume + dot(r[i], g.b[i]);
  });
  g.b[0] = T(-1) * sum;
  g.volume = T(1.0 / 3.0) * volume;
  return g;
}

/// V times the mean gradient, sum_I u_I (x) B_I; exactly zero for a uniform field.
template <class T, class Shape>
PERCUSS_FORCE_INLINE Matrix3<T> find_volume_times_gradient(const CornerField<T, Shape>& u,
                                                           const CornerGradient<T, Shape>& g) {
  const CornerField<T, Shape> r = subtract_first(u);
  const Vector3<T> zero{T(0), T(0), T(0)};
  Matrix3<T> l{{zero, zero, zero}};
  repeat<Shape::corners - 1>([&](auto k) {
    constexpr int i = k + 1;
    l = l + Matrix3<T>{{r[i].x * g.b[i], r[i].y * g.b[i], r[i].z * g.b[i]}};
  });
  return l;
}

/// The mean gradient of a field.
template <class T, class Shape>
PERCUSS_FORCE_INLINE Matrix3<T> find_mean_gradient(const CornerField<T, Shape>& u, const CornerGradient<T, Shape>& g) {
  return (T(1) / g.volume) * find_volume_times_gradient(u, g);
}

/// Corners half a step before x.
template <class T, class Shape>
PERCUSS_FORCE_INLINE CornerField<T, Shape> find_middle(const CornerField<T, Shape>& x, const CornerField<T, Shape>& v,
                                                       const T& dt) {
  const T half_dt = T(0.5) * dt;
  CornerField<T, Shape> middle;
  repeat<Shape::corners>([&](auto i) { middle[i] = x[i] - half_dt * v[i]; });
  return middle;
}

template <class T>
struct ShapeField<T, Wedge6> {
  using type = CornerField<T, Wedge6>;
};
template <class T>
struct ShapeField<T, Pyramid5> {
  using type = CornerField<T, Pyramid5>;
};
template <class T, class Shape>
PERCUSS_FORCE_INLINE CornerGradient<T, Shape> find_shape_geometry(const CornerField<T, Shape>& x) {
  return find_corner_gradient(x);
}

/// sum_I Gamma_h(I) u_I; exactly zero for a uniform field.
template <class T, class Shape>
PERCUSS_FORCE_INLINE ModeVectors<T, Shape> find_modes(const CornerField<T, Shape>& u) {
  const CornerField<T, Shape> r = subtract_first(u);
  ModeVectors<T, Shape> out;
  repeat<Shape::modes>([&](auto h) {
    Vector3<T> sum{T(0), T(0), T(0)};
    repeat<Shape::corners - 1>([&](auto k) {
      constexpr double weight = Shape::mode[h][k + 1];
      if constexpr (weight != 0) sum = sum + T(weight) * r[k + 1];
    });
    out.at[h] = sum;
  });
  return out;
}

/// gamma_h(I) = Gamma_h(I) - B_I . X_h / V with X_h = find_modes(x): what the mean gradient does not see of mode h,
/// zero for linear fields.
template <class T, class Shape>
struct HourglassVectors {
  T of[Shape::modes][Shape::corners];
};

template <class T, class Shape>
PERCUSS_FORCE_INLINE HourglassVectors<T, Shape> find_hourglass_vectors(const CornerField<T, Shape>& x,
                                                                       const CornerGradient<T, Shape>& g) {
  const ModeVectors<T, Shape> modes = find_modes(x);
  const T over_volume = T(1) / g.volume;
  HourglassVectors<T, Shape> gamma;
  repeat<Shape::modes>([&](auto h) {
    const Vector3<T> of_volume = over_volume * modes.at[h];
    repeat<Shape::corners>([&](auto i) {
      constexpr double weight = Shape::mode[h][i];
      gamma.of[h][i] = T(weight) - dot(g.b[i], of_volume);
    });
  });
  return gamma;
}

}  // namespace percuss
