#pragma once
// The step bound of random shells over the step of their exact largest eigenvalue.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test {

inline constexpr int freedoms = 24;
using ShellMatrix = std::array<std::array<double, freedoms>, freedoms>;

inline double& component(Vec& a, std::size_t k) { return k == 0 ? a.x : k == 1 ? a.y : a.z; }

/// Stiffness of an unstressed element, scaled by its masses: column by column, by motions so small that nothing turns.
inline ShellMatrix find_scaled_stiffness(const TestShell<ElasticLayer>& shell, const ShellCorners& x) {
  const double node_mass = shell.state.mass / 4, inertia = node_mass * shell.state.gyration_square;
  const double dt = 1e-10;
  ShellMatrix k{};
  for (std::size_t j = 0; j < freedoms; ++j) {
    ShellCorners v{}, w{};
    component(j < 12 ? v[j / 3] : w[j / 3 - 4], j % 3) = 1;
    TestShell<ElasticLayer> moved = shell;
    moved.advance(move(x, v, dt), v, w, dt);
    for (std::size_t i = 0; i < freedoms; ++i) {
      Vec row = i < 12 ? moved.force[i / 3] : moved.moment[i / 3 - 4];
      k[i][j] = component(row, i % 3) / dt / std::sqrt((i < 12 ? node_mass : inertia) * (j < 12 ? node_mass : inertia));
    }
  }
  return k;
}

/// Scaled stiffness of a triangle, whose nodes have a third of the mass each. The rows and columns of the repeated
/// corner are left empty.
inline ShellMatrix find_scaled_triangle_stiffness(const TestShell<ElasticLayer>& shell, const ShellCorners& x) {
  const double node_mass = shell.state.mass / 3, inertia = node_mass * shell.state.gyration_square;
  const double dt = 1e-10;
  ShellMatrix k{};
  for (std::size_t j = 0; j < freedoms; ++j) {
    if (j % 12 / 3 == 3) continue;
    ShellCorners v{}, w{};
    component(j < 12 ? v[j / 3] : w[j / 3 - 4], j % 3) = 1;
    v[3] = v[2];
    w[3] = w[2];
    TestShell<ElasticLayer> moved = shell;
    moved.advance(move(x, v, dt), v, w, dt);
    moved.force[2] = moved.force[2] + moved.force[3];
    moved.moment[2] = moved.moment[2] + moved.moment[3];
    for (std::size_t i = 0; i < freedoms; ++i) {
      if (i % 12 / 3 == 3) continue;
      Vec row = i < 12 ? moved.force[i / 3] : moved.moment[i / 3 - 4];
      k[i][j] = component(row, i % 3) / dt / std::sqrt((i < 12 ? node_mass : inertia) * (j < 12 ? node_mass : inertia));
    }
  }
  return k;
}

/// The matrix times itself, scaled to a norm of 1.
inline ShellMatrix square(const ShellMatrix& k) {
  ShellMatrix product{};
  double sum = 0;
  for (std::size_t i = 0; i < freedoms; ++i) {
    for (std::size_t j = 0; j < freedoms; ++j) {
      for (std::size_t l = 0; l < freedoms; ++l) product[i][l] += k[i][j] * k[j][l];
    }
    for (const double value : product[i]) sum += value * value;
  }
  for (auto& row : product) {
    for (double& value : row) value /= std::sqrt(sum);
  }
  return product;
}

/// Largest eigenvalue: Rayleigh quotient of the largest column of the 256th power.
inline double find_largest_eigenvalue(const ShellMatrix& k) {
  ShellMatrix power = square(k);
  for (int squaring = 0; squaring < 7; ++squaring) power = square(power);
  std::size_t largest = 0;
  for (std::size_t j = 1; j < freedoms; ++j) {
    if (power[j][j] > power[largest][largest]) largest = j;
  }
  const auto& u = power[largest];  // of a symmetric matrix
  double quotient = 0, size = 0;
  for (std::size_t i = 0; i < freedoms; ++i) {
    size += u[i] * u[i];
    for (std::size_t j = 0; j < freedoms; ++j) quotient += u[i] * k[i][j] * u[j];
  }
  return quotient / size;
}

/// Bounds over exact steps.
struct StepShare {
  double largest = 0, least = 1e300;
  std::vector<double> all;
  int concave = 0;

  void take(double share) {
    largest = std::max(largest, share);
    least = std::min(least, share);
    all.push_back(share);
  }
};

/// distortion, warp: of the elements at most, as a share of their edges. Every other element is flat.
struct RandomShapes {
  double distortion = 0.2, warp = 0.2, longest = 5;
  double thinnest = 1e-3, thickest = 0.3;  // in edges
  bool are_membranes = false;
};

/// offset: of the middle of the section from the mesh, in units of half the thickness.
inline StepShare compare_steps(Random& random, int trials, double stretch, double offset = 0,
                               const RandomShapes& shapes = {}) {
  StepShare share;
  for (int trial = 0; trial < trials; ++trial) {
    const double aspect = 1 + (shapes.longest - 1) * (0.5 + 0.5 * random()), poisson = -0.2 + 0.69 * random();
    const double thickness = shapes.thinnest * std::pow(shapes.thickest / shapes.thinnest, 0.5 + 0.5 * random());
    const ShellCorners start = make_quad(random, aspect, 1, shapes.distortion, trial % 2 == 0 ? 0 : shapes.warp);
    const auto geometry = find_shell_geometry(find_differences(start));
    if (geometry.area < 1e-2 * aspect) continue;  // a sliver: differences have no small step
    TestShell<ElasticLayer> shell({find_plane_elasticity(1, poisson)}, 2, start, thickness, 1);
    shell.par.offset = offset * thickness / 2;
    shell.par.is_membrane = shapes.are_membranes;
    shell.state.gyration_square += shell.par.offset * shell.par.offset;
    ShellCorners x = start;
    for (Vec& corner : x) corner = stretch * corner;
    shell.state.thickness /= stretch * stretch;
    const double bound = shell.advance(x, {}, {}, 0).stable_step;
    share.take(bound / (2 / std::sqrt(find_largest_eigenvalue(find_scaled_stiffness(shell, x)))));
    if (geometry.least_cosine < 0) ++share.concave;
  }
  return share;
}

/// Random triangles with angles down to some 5 degrees.
inline StepShare compare_triangle_steps(Random& random, int trials, double stretch, double offset = 0,
                                        bool are_membranes = false) {
  StepShare share;
  for (int trial = 0; trial < trials; ++trial) {
    const double poisson = -0.2 + 0.69 * random(), thickness = std::pow(10.0, -1.5 + 1.5 * random());
    ShellCorners x = make_triangle({0, 0, 0}, {1, 0, 0}, {0.5 + random(), 0.65 + 0.55 * random(), 0});
    TestShell<ElasticLayer> shell({find_plane_elasticity(1, poisson)}, 2, x, thickness, 1);
    shell.par.offset = offset * thickness / 2;
    shell.par.is_membrane = are_membranes;
    shell.state.gyration_square += shell.par.offset * shell.par.offset;
    for (Vec& corner : x) corner = stretch * corner;
    shell.state.thickness /= stretch * stretch;
    const double bound = shell.advance(x, {}, {}, 0).stable_step;
    const double exact = 2 / std::sqrt(find_largest_eigenvalue(find_scaled_triangle_stiffness(shell, x)));
    share.take(bound / exact);
  }
  return share;
}

}  // namespace percuss::test
