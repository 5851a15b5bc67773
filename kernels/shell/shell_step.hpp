#pragma once
// Bound of the stable step of a shell element.
//
// With nodal masses m / 4 the largest frequency is 2 c sqrt(l), c^2 = E t A / (m (1 - nu^2)): what follows bounds l. Of
// a quadrilateral every part is an upper bound of its own (docs/theory_shells.md, "Mass and step"), whatever its shape.

#include "kernels/shell/plane_stress.hpp"
#include "kernels/shell/shear_modes.hpp"
#include "kernels/shell/shell_hourglass.hpp"

namespace percuss {

/// Share of a triangle's step of transverse shear that covers what is neglected there (tests/kernels/shell).
inline constexpr double triangle_shear_step_share = 0.8;

/// What the step depends on besides the shape. gyration_square: rotary inertia over mass [length^2]; offset: as in
/// ShellParameters.
template <class T>
struct ShellSection {
  T thickness, mass, gyration_square;
  double offset = 0;
};

/// t^2 / 12 + A / 8: the rotary inertia over mass that the current shape would be given.
template <class T>
PERCUSS_FORCE_INLINE T find_gyration_square(const ShellGeometry<T>& g, const T& thickness) {
  return T(1.0 / 12.0) * thickness * thickness + T(0.125) * g.area;
}

/// Largest eigenvalue of the products of gradients, in plane stress with share = 1 - nu^2.
template <class T>
PERCUSS_FORCE_INLINE T find_largest_product(const GradientProducts<T>& b, double share) {
  const T half_trace = T(0.5) * (b.xx + b.yy), determinant = b.xx * b.yy - b.xy * b.xy;
  return half_trace + square_root(larger(half_trace * half_trace - T(share) * determinant, T(0)));
}

/// Bound of a quadrilateral. Membrane (with its hourglass modes) and rotations (shear and bending) each have a bound;
/// on a warped element they share velocities: shear takes those in the plane along directors that lean, hourglass modes
/// take deflections by the warp, and the spin turns directors that differ.
template <class T>
PERCUSS_FORCE_INLINE T bound_quadrilateral(const ShellGeometry<T>& g, const T& thickness, const T& gyration_square,
                                           double poissons_ratio) {
  const double nu = poissons_ratio, stiffness = 1 - nu * nu, a = (1 - nu) / 2, shear = shell_shear_correction * a;
  const T over_inertia = T(1) / smaller(gyration_square, find_gyration_square(g, thickness));
  const EdgeDirectors<T> directors = find_edge_directors(g);
  const GradientProducts<T> b = find_gradient_products(g, Quadrilaterals{});
  const T trace = b.xx + b.yy, uniform = find_largest_product(b, stiffness);
  const T deflection = smaller(uniform, trace);  // not below the largest product of a scalar field

  // Hourglass modes: those of bending, which are the stiffer ones, serve for the membrane too.
  const T skew = g.hx * g.hx * b.xx + T(2) * g.hx * g.hy * b.xy + g.hy * g.hy * b.yy;
  const T hourglass = T(1.0 / 12.0) * (T(a) * trace + T(1 - a) * deflection);
  const T plane = join_modes(uniform, hourglass * (T(4) + skew), uniform * hourglass * skew);

  const T by_warp = T(4 * stiffness / 3) * deflection * deflection * find_membrane_fade(g, thickness) * g.z * g.z;
  const T of_membrane = plane + by_warp;
  const T drilling = T(shell_drilling * (1 - nu) / 8);
  const T in_plane = join_modes(of_membrane, drilling * (over_inertia + trace), of_membrane * drilling * trace);
  const T of_shear = T(shear) * bound_shear_modes(g, directors, over_inertia);
  const T of_bending = T(1.0 / 12.0) * thickness * thickness * plane;
  const T by_spin = T(4) * deflection * (T(1) - directors.mean_square);
  const T by_leaning = T(2 * shear) * directors.leaning * (deflection + T(1.0 / 3.0) * trace * (T(1) + T(0.25) * skew));
  return join_modes(in_plane, of_shear + of_bending * (over_inertia + by_spin),
                    of_membrane * (by_leaning + of_bending * by_spin) + by_warp * of_shear);
}

/// Bound of a triangle. The membrane's largest eigenvalue is exact, it has no other modes in its plane. In shear, with
/// the share of find_shear_share(), rotations count with those of a uniform field and with what turns around the
/// element, over the square of the gyration; bending, which moves the same rotations, adds to it.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE T bound_triangle(const ShellGeometry<T>& g, const T& thickness, const T& gyration_square,
                                      double poissons_ratio, const Shapes& shapes) {
  const GradientProducts<T> b = find_gradient_products(g, shapes);
  const T membrane = find_largest_product(b, 1 - poissons_ratio * poissons_ratio);
  const T ideal = find_gyration_square(g, thickness), over_ideal = T(1) / ideal;
  const T around = g.area * (b.xx + b.yy);
  const T rotations = (T(0.25) + T(1.0 / 16.0) * around * around) * over_ideal;
  constexpr double covered = 1 / (triangle_shear_step_share * triangle_shear_step_share);
  const T shear =
      T(covered * shell_shear_correction * (1 - poissons_ratio) / 2) * (find_largest_product(b, 1) + rotations);
  const T bending = T(1.0 / 12.0) * thickness * thickness * over_ideal * membrane;
  // Where there is less inertia than that of the shape, as in one that was stretched, all is less in proportion.
  const T over_deficit = T(1) / smaller(gyration_square * over_ideal, T(1));
  return over_deficit * larger(membrane, find_shear_share(g, thickness, shapes) * shear + bending);
}

/// What an offset d of the middle of the section leaves of the step that the shape's own inertia, j, would allow. The
/// masses at the corners, m and m g^2, bound those of the motion of the middle, v + d b: m (v + d b)^2 + m j b^2 is at
/// most 1 + d / g times m v^2 + m g^2 b^2 if g^2 is j + d^2; of less, in proportion.
template <class T>
PERCUSS_FORCE_INLINE T find_offset_share(const ShellGeometry<T>& g, const T& thickness, const T& gyration_square,
                                         double offset) {
  const T whole = find_gyration_square(g, thickness) + T(offset * offset);
  const T coupling = T(1) + T(offset < 0 ? -offset : offset) * (T(1) / square_root(whole));
  const T real = smaller(gyration_square * (T(1) / whole), T(1));
  return square_root(real * (T(1) / coupling));
}

/// Largest step of central differences.
template <class T, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE T find_shell_step(const ShellGeometry<T>& g, const ShellSection<T>& section,
                                       const PlaneElasticity& elastic, [[maybe_unused]] const Shapes& shapes = {}) {
  const double nu = elastic.poissons_ratio;
  T gyration_square = section.gyration_square, share(1);
  if (section.offset != 0) {
    share = find_offset_share(g, section.thickness, gyration_square, section.offset);
    gyration_square = find_gyration_square(g, section.thickness);
  }
  T bound = bound_quadrilateral(g, section.thickness, gyration_square, nu);
  if constexpr (Shapes::has_triangles) {
    bound = select(shapes.is_triangle, bound_triangle(g, section.thickness, gyration_square, nu, shapes), bound);
  }
  const T modulus = T(elastic.youngs_modulus / (1 - nu * nu));
  return share * square_root(section.mass * (T(1) / (modulus * section.thickness * g.area * bound)));
}

}  // namespace percuss
