#pragma once
// Physical stabilisation of the one-point hexahedron: the stiffness that bending and twist of the material itself have,
// from assumed strains (after Belytschko and Bindeman, Comp. Meth. Appl. Mech. Eng. 105, 1993).
//
// The hourglass modes xi zeta and eta zeta strain the element like a plate in (xi, eta) that bends: linearly through
// zeta, without strain across it and without transverse shear. So do the two other pairs. With g_k the modes 1 to 3 of
// the positions (the axes of the element), u_h the hourglass rates, M_ij = g_i . g_j of the two axes of a plate,
//   E_11 = u_a . g_1,  E_22 = u_b . g_2,  2 E_12 = u_a . g_2 + u_b . g_1,
//   S = (V/3) E/(1 - nu^2) [nu M^-1 (M^-1 : E) + (1 - nu) M^-1 E M^-1]
// is the plane-stress response in these axes, and Q_a = S_11 g_1 + S_12 g_2, Q_b = S_12 g_1 + S_22 g_2 its forces.

#include "kernels/element/hex8/hourglass.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/polar.hpp"

namespace percuss {

/// Elastic constants as the plates need them.
struct PlateModuli {
  double young;    // E
  double plane;    // E / (1 - nu^2)
  double poisson;  // nu
  double largest;  // largest stiffness of a plate for a strain of size 1
};

PERCUSS_FORCE_INLINE PlateModuli find_plate_moduli(const LameConstants& c) {
  const double young = find_youngs_modulus(c);
  const double poisson = c.lambda / (2 * (c.lambda + c.mu));
  const double plane = young / (1 - poisson * poisson);
  const double equal_bending = plane * (1 + poisson);
  return {young, plane, poisson, equal_bending > 2 * c.mu ? equal_bending : 2 * c.mu};
}

/// The axes (0 to 2: xi, eta, zeta) and hourglass modes (0 to 2: eta zeta, zeta xi, xi eta) of a plate.
struct Plate {
  int first, second;            // axes in its plane
  int first_mode, second_mode;  // modes that strain it along the first and the second
};

PERCUSS_FORCE_INLINE constexpr Plate find_plate(int i) {
  return i == 0 ? Plate{0, 1, 1, 0} : i == 1 ? Plate{1, 2, 2, 1} : Plate{0, 2, 2, 0};
}

/// The element's axes at the mid-point and their metric.
template <class T>
struct ElementAxes {
  Vector3<T> g[3];
  T square[3];          // g_k . g_k
  T inverse_square[3];  // 1 / (g_k . g_k)
  T product[3];         // g_first . g_second, by plate
};

/// From the modes a of the mid-point.
template <class T>
PERCUSS_FORCE_INLINE ElementAxes<T> find_element_axes(const VectorModes<T>& a) {
  ElementAxes<T> axes;
  for (int k = 0; k < 3; ++k) {
    axes.g[k] = a[1 + k];
    axes.square[k] = dot(axes.g[k], axes.g[k]);
  }
  find_reciprocals(axes.square, axes.inverse_square);
  for (int i = 0; i < 3; ++i) {
    const Plate plate = find_plate(i);
    axes.product[i] = dot(axes.g[plate.first], axes.g[plate.second]);
  }
  return axes;
}

/// The axes for forces and rates of now, with the metric and the volume that the element had at the start.
template <class T>
struct StartShape {
  ElementAxes<T> axes;
  T volume;
  T gain;  // bound of the largest eigenvalue of V^-2: how much rates of now may strain the shape at the start
};

/// With F = V R the axes were F^-1 a_k at the start. A rate u of now is there F^-1 u, and its products with them are
/// u . h_k, h_k = V^-2 a_k. A force S F^-1 a_k there is S h_k now. V: at the mid-point, as the modes a and the volume.
template <class T>
PERCUSS_FORCE_INLINE StartShape<T> find_start_shape(const VectorModes<T>& a, const Symmetric3<T>& stretch,
                                                    const T& volume) {
  const Adjugate<T> adjugate = find_adjugate(stretch);
  const T over_j = T(1) / adjugate.determinant;
  const Symmetric3<T> cofactor = adjugate.matrix;
  const Symmetric3<T> square = (over_j * over_j) * symmetric_product(full(cofactor), full(cofactor));
  StartShape<T> out;
  for (int k = 0; k < 3; ++k) {
    out.axes.g[k] = square * a[1 + k];
    out.axes.square[k] = dot(a[1 + k], out.axes.g[k]);
  }
  find_reciprocals(out.axes.square, out.axes.inverse_square);
  for (int i = 0; i < 3; ++i) {
    const Plate plate = find_plate(i);
    out.axes.product[i] = dot(a[1 + plate.first], out.axes.g[plate.second]);
  }
  out.volume = over_j * volume;
  out.gain = bound_by_rows(square);
  return out;
}

/// Rates of the hourglass forces, and a bound of the largest eigenvalue of these over the rates.
template <class T>
struct HourglassResponse {
  HourglassModes<T> force;
  T stiffness;
};

/// Sums over the plates.
template <class T>
struct PlateSums {
  HourglassModes<T>& q;  // rates of the hourglass forces
  T (&bound)[3];         // by mode: of what bounds their stiffness
};

/// Adds the forces of plate I, whose 1 / det M is `scale`. A template, as in a loop over plates GCC would look up in
/// memory what lies in which.
template <int I, class T>
PERCUSS_FORCE_INLINE void add_plate(const PlateModuli& moduli, const ElementAxes<T>& axes, const T& scale,
                                    const T& third_volume, const HourglassModes<T>& u, const PlateSums<T>& sums) {
  constexpr Plate plate = find_plate(I);
  const Vector3<T>&g1 = axes.g[plate.first], &g2 = axes.g[plate.second];
  const Vector3<T>&u1 = u.mode[plate.first_mode], &u2 = u.mode[plate.second_mode];
  const T m11 = axes.square[plate.first], m22 = axes.square[plate.second];
  const T i11 = scale * m22, i22 = scale * m11, i12 = -(scale * axes.product[I]);
  const T e11 = dot(u1, g1), e22 = dot(u2, g2), e12 = number<T>(0.5) * (dot(u1, g2) + dot(u2, g1));
  // columns of M^-1 E
  const T w11 = i11 * e11 + i12 * e12, w12 = i11 * e12 + i12 * e22;
  const T w21 = i12 * e11 + i22 * e12, w22 = i12 * e12 + i22 * e22;
  const T spread = number<T>(moduli.poisson / (1 - moduli.poisson)) * (w11 + w22);
  const T size = number<T>(moduli.plane * (1 - moduli.poisson)) * third_volume;
  const T s11 = size * (spread * i11 + (w11 * i11 + w12 * i12));
  const T s22 = size * (spread * i22 + (w21 * i12 + w22 * i22));
  const T s12 = size * (spread * i12 + (w11 * i12 + w12 * i22));
  Vector3<T>&q1 = sums.q.mode[plate.first_mode], &q2 = sums.q.mode[plate.second_mode];
  q1 = q1 + s11 * g1 + s12 * g2;
  q2 = q2 + s12 * g1 + s22 * g2;
  const T largest = larger(i11, i22) + larger(i12, -i12);
  sums.bound[plate.first_mode] = sums.bound[plate.first_mode] + largest;
  sums.bound[plate.second_mode] = sums.bound[plate.second_mode] + largest;
}

/// Rates of the hourglass forces for the rates u. The fourth mode, xi eta zeta, is given
/// the stiffness of a rod along each axis: Q = (V/9) E sum_k (u . g_k) g_k / (g_k . g_k)^2.
template <class T>
PERCUSS_FORCE_INLINE HourglassResponse<T> find_assumed_strain_response(const PlateModuli& moduli,
                                                                       const ElementAxes<T>& axes, const T& volume,
                                                                       const HourglassModes<T>& u) {
  const Vector3<T> zero{T(0), T(0), T(0)};
  HourglassResponse<T> out{{{zero, zero, zero, zero}}, T(0)};
  T bound[3] = {T(0), T(0), T(0)};
  const T third_volume = number<T>(1.0 / 3.0) * volume;
  T determinant[3], scale[3];
  for (int i = 0; i < 3; ++i) {
    const Plate plate = find_plate(i);
    determinant[i] = axes.square[plate.first] * axes.square[plate.second] - axes.product[i] * axes.product[i];
  }
  if constexpr (is_short<T>) {  // their product would leave the range of floats
    for (int i = 0; i < 3; ++i) scale[i] = T(1) / determinant[i];
  } else {
    find_reciprocals(determinant, scale);
  }
  const PlateSums<T> sums{out.force, bound};
  add_plate<0>(moduli, axes, scale[0], third_volume, u, sums);
  add_plate<1>(moduli, axes, scale[1], third_volume, u, sums);
  add_plate<2>(moduli, axes, scale[2], third_volume, u, sums);
  const T rod = number<T>(moduli.young / 9) * volume;
  for (int k = 0; k < 3; ++k) {
    const T inverse = axes.inverse_square[k];
    out.force.mode[3] = out.force.mode[3] + (rod * dot(u.mode[3], axes.g[k]) * (inverse * inverse)) * axes.g[k];
  }
  // A plate's strain in orthonormal axes is at most |u|^2 times the largest eigenvalue of M^-1 (Gershgorin).
  const T plates = number<T>(moduli.largest) * third_volume * larger(larger(bound[0], bound[1]), bound[2]);
  const T rods = rod * (axes.inverse_square[0] + axes.inverse_square[1] + axes.inverse_square[2]);
  out.stiffness = larger(plates, rods);
  return out;
}

/// Square of the equivalent stress that the hourglass forces stand for at the surface of the element, plate by plate.
/// q and the modes a of the positions: at n+1. The metric is still that of the mid-point.
template <class T>
PERCUSS_FORCE_INLINE T find_surface_stress_square(const ElementAxes<T>& axes, const VectorModes<T>& a, const T& volume,
                                                  const HourglassModes<T>& q) {
  T sum(0);
  for (int i = 0; i < 3; ++i) {
    const Plate plate = find_plate(i);
    const Vector3<T>&g1 = a[1 + plate.first], &g2 = a[1 + plate.second];
    const Vector3<T>&q1 = q.mode[plate.first_mode], &q2 = q.mode[plate.second_mode];
    const T t11 = dot(q1, g1), t22 = dot(q2, g2), t12 = dot(q1, g2), t21 = dot(q2, g1);
    const T m1 = axes.square[plate.first], m2 = axes.square[plate.second];
    sum = sum + t11 * t11 + t22 * t22 - t11 * t22 +
          number<T>(1.5) *
              (t12 * t12 * m1 * axes.inverse_square[plate.second] + t21 * t21 * m2 * axes.inverse_square[plate.first]);
  }
  const T scale = T(192) * (T(1) / (T(64) * volume));
  return scale * scale * sum;
}

/// How near to inverted an element is, from 0 to 1: by how much the gradients of its hourglass modes outweigh those of
/// its axes. 0 for all but strongly distorted elements.
template <class T>
PERCUSS_FORCE_INLINE T find_guard(const VectorModes<T>& a, const VolumeGradient<T>& b) {
  T sum(0);
  for (int h = 4; h <= 7; ++h) {
    for (int k = 1; k <= 3; ++k) {
      const T part = dot(a[h], b[k]);
      sum = sum + part * part;
    }
  }
  const T scale = T(1) / (T(64) * b.volume);
  return larger(smaller(T(2) * scale * scale * sum - T(1), T(1)), T(0));
}

}  // namespace percuss
