#pragma once
// Random but reproducible quadrilaterals and motions for the shell tests.

#include <array>
#include <cmath>
#include <vector>

#include "kernels/shell/membrane.hpp"
#include "kernels/shell/shell4.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

using Vec = Vector3<double>;

/// Corner positions, velocities, angular velocities, forces or moments.
using ShellCorners = std::array<Vec, 4>;

inline Vec random_vector(Random& random, double size) { return {size * random(), size * random(), size * random()}; }

/// A rectangle of edges a, b whose corners are moved by up to `distortion` of the edges, out of the plane too.
inline ShellCorners make_quad(Random& random, double a, double b, double distortion, double warp) {
  ShellCorners c{Vec{-a / 2, -b / 2, 0}, Vec{a / 2, -b / 2, 0}, Vec{a / 2, b / 2, 0}, Vec{-a / 2, b / 2, 0}};
  for (Vec& x : c) x = x + Vec{a * distortion * random(), b * distortion * random(), warp * random()};
  return c;
}

inline ShellCorners random_field(Random& random, double size) {
  ShellCorners c;
  for (Vec& u : c) u = random_vector(random, size);
  return c;
}

inline ShellDifferences<double> find_differences(const ShellCorners& u) {
  const Vec corners[4] = {u[0], u[1], u[2], u[3]};
  return percuss::find_differences(corners);
}

/// A triangle is given with its last corner once more.
inline MixedShapes<bool> find_shapes(const ShellCorners& x) {
  return {x[2].x == x[3].x && x[2].y == x[3].y && x[2].z == x[3].z};
}

inline ShellCorners make_triangle(const Vec& a, const Vec& b, const Vec& c) { return {a, b, c, c}; }

/// Rotation by an angle about a unit axis (Rodrigues).
inline Vec rotate(const Vec& axis, double angle, const Vec& a) {
  return std::cos(angle) * a + std::sin(angle) * cross(axis, a) + ((1 - std::cos(angle)) * dot(axis, a)) * axis;
}

/// One element with its points.
template <class Material>
struct TestShell {
  ShellParameters<Material> par;
  ShellState<double> state{};
  std::vector<double> layers;
  ShellCorners force, moment;

  TestShell(const Material& material, int points, const ShellCorners& x, double thickness, double density)
      : par{material, find_thickness_points(points)},
        layers(static_cast<std::size_t>(points * (3 + Material::most_history))) {
    const double area = find_shell_geometry(find_differences(x), find_shapes(x)).area;
    state.mass = density * area * thickness;
    state.gyration_square = thickness * thickness / 12 + area / 8;
    state.thickness = thickness;
  }

  /// To the positions x, which the corners reached with the velocities v and w.
  ShellResult<double> advance(const ShellCorners& x, const ShellCorners& v, const ShellCorners& w, double dt) {
    Vec f[4], m[4];
    const Vec spins[4] = {w[0], w[1], w[2], w[3]};
    const CornerMotion<double> motion{find_differences(x), find_differences(v), spins, dt};
    const auto result = [&] {
      const StoredShell<double> stored{state, layers.data()};
      if constexpr (is_fabric<Material>) {
        return advance_membrane(par, motion, stored, {f, m}, WholeLayers{}, find_shapes(x));
      } else {
        if (par.is_membrane) return advance_membrane(par, motion, stored, {f, m}, WholeLayers{}, find_shapes(x));
        return advance_shell4(par, motion, stored, {f, m}, WholeLayers{}, find_shapes(x));
      }
    }();
    for (std::size_t i = 0; i < 4; ++i) {
      force[i] = f[i];
      moment[i] = m[i];
    }
    return result;
  }
};

inline ShellCorners move(const ShellCorners& x, const ShellCorners& v, double dt) {
  ShellCorners end;
  for (std::size_t i = 0; i < 4; ++i) end[i] = x[i] + dt * v[i];
  return end;
}

/// sum_I f_I . v_I + m_I . w_I.
inline double find_power(const ShellCorners& f, const ShellCorners& m, const ShellCorners& v, const ShellCorners& w) {
  double power = 0;
  for (std::size_t i = 0; i < 4; ++i) power += dot(f[i], v[i]) + dot(m[i], w[i]);
  return power;
}

inline double largest_norm(const ShellCorners& u) {
  double largest = 0;
  for (const Vec& a : u) largest = std::max(largest, norm(a));
  return largest;
}

}  // namespace percuss::test
