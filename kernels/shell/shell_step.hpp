#pragma once
// Bound of the stable step of a shell element.

#include "kernels/shell/shell_geometry.hpp"

namespace percuss {

/// Share of the membrane's step that covers bending and hourglass modes too, with a rotary inertia of mass times
/// (t^2 / 12 + A / 8), and of the step of transverse shear, which is shorter where Poisson's ratio is small
/// (tests/kernels/shell compares the bound with the largest eigenvalue).
inline constexpr double shell_step_share = 0.9, shell_shear_step_share = 0.8;

/// Shear correction of a homogeneous section (Reissner 1945).
inline constexpr double shell_shear_correction = 5.0 / 6.0;

/// Largest step of central differences for an element of mass m. With lumped masses m / 4 a frequency is 2 c sqrt(l):
/// for the membrane l is the largest eigenvalue of the products of gradients in plane stress; for transverse shear, of
/// deflections and rotations together, kappa (1 - nu) / 2 (g + 2 / a), g the largest eigenvalue of those products and
/// a twice the smallest corner triangle (the area of a parallelogram).
/// Rotations move a director by its length, and shear is taken along it: with the corners' normals turned from that of
/// the element by angles of up to a, squares of frequencies grow by 1 / cos^2 a.
/// gyration_square: rotary inertia over mass [length^2]; where it is less than that of the current shape, as in an
/// element that was stretched, frequencies grow by at most the square root of the ratio.
/// Triangles: the membrane's largest eigenvalue is exact, they have no other modes in their plane. In shear, with the
/// share of find_shear_share(), rotations count with those of a uniform field and with what turns around the element,
/// over the square of the gyration; bending, which moves the same rotations, adds to it.
template <class T, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE T find_shell_step(const ShellGeometry<T>& g, const T& thickness, const T& mass,
                                       const T& gyration_square, double youngs_modulus, double poissons_ratio,
                                       const Shapes& shapes = {}) {
  const auto [xx, yy, xy] = find_gradient_products(g, shapes);
  const double stiffness = 1 - poissons_ratio * poissons_ratio;
  const T half_trace = T(0.5) * (xx + yy), determinant = xx * yy - xy * xy;
  const auto find_eigenvalue = [&](double share) {
    return half_trace + square_root(larger(half_trace * half_trace - T(share) * determinant, T(0)));
  };
  const double shear_share = shell_shear_correction * (1 - poissons_ratio) / 2;
  const T of_membrane = find_eigenvalue(stiffness);
  T membrane = T(1 / (shell_step_share * shell_step_share)) * of_membrane;
  const T ideal = T(1.0 / 12.0) * thickness * thickness + T(0.125) * g.area;
  T rotations = T(2) / g.least_corner;
  if constexpr (Shapes::has_triangles) {
    membrane = select(shapes.is_triangle, of_membrane, membrane);
    const T around = g.area * (xx + yy);
    rotations = select(shapes.is_triangle, (T(0.25) + T(1.0 / 16.0) * around * around) * (T(1) / ideal), rotations);
  }
  T shear = T(shear_share / (shell_shear_step_share * shell_shear_step_share)) * (find_eigenvalue(1) + rotations);
  if constexpr (Shapes::has_triangles) {
    const T bending = T(1.0 / 12.0) * thickness * thickness * (T(1) / ideal) * membrane;
    shear = select(shapes.is_triangle, find_shear_share(g, thickness, shapes) * shear + bending, shear);
  }
  const T speed_square = T(youngs_modulus / stiffness) * thickness * g.area * (T(1) / mass);
  const T deficit = smaller(gyration_square * (T(1) / ideal), T(1));
  return square_root(deficit * (T(1) / (speed_square * (T(1) + g.steepest) * larger(membrane, shear))));
}

/// What an offset d of the middle of the section leaves of that step. The masses at the corners, m and m g^2, bound
/// those of the motion of the middle, v + d b: m (v + d b)^2 + m j b^2 is at most 1 + d / g times m v^2 + m g^2 b^2 if
/// g^2 is j + d^2, j that of the shape without the offset; of less, in proportion.
template <class T>
PERCUSS_FORCE_INLINE T find_offset_share(const ShellGeometry<T>& g, const T& thickness, const T& gyration_square,
                                         double offset) {
  const T plain = T(1.0 / 12.0) * thickness * thickness + T(0.125) * g.area;
  const T whole = plain + T(offset * offset);
  const T coupling = T(1) + T(offset < 0 ? -offset : offset) * (T(1) / square_root(whole));
  // find_shell_step() has counted what the inertia lacks of j alone.
  const T counted = smaller(gyration_square * (T(1) / plain), T(1)),
          real = smaller(gyration_square * (T(1) / whole), T(1));
  return square_root(real * (T(1) / (counted * coupling)));
}

}  // namespace percuss
