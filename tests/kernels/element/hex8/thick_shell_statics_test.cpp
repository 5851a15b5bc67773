// Shells of one layer of thick shells at rest under loads, by their own linear stiffness, against theory and published
// values.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "kernels/element/hex8/thick_shell.hpp"
#include "kernels/material/elastic.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::thick_shell_statics_test {

namespace {

constexpr HexKind kind = HexKind::thick3;
using Place = std::array<double, 3>;

/// A layer of a by b elements; map(s, t, side) gives the place of a node, with s, t from 0 to 1 and side 0 or 1.
class Layer {
 public:
  Layer(int a, int b, const std::function<Place(double, double, int)>& map) : a_(a), b_(b) {
    for (int side = 0; side < 2; ++side)
      for (int j = 0; j <= b; ++j)
        for (int i = 0; i <= a; ++i) nodes.push_back(map(double(i) / a, double(j) / b, side));
    fixed.assign(3 * nodes.size(), false);
    load.assign(3 * nodes.size(), 0);
  }

  std::size_t find(int i, int j, int side) const {
    return static_cast<std::size_t>(i + (a_ + 1) * (j + (b_ + 1) * side));
  }

  /// Displacements under the load.
  std::vector<double> solve(double young, double poisson) const {
    std::vector<std::vector<double>> k = assemble(young, poisson);
    std::vector<double> u = load;
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!fixed[i]) continue;
      for (std::size_t j = 0; j < u.size(); ++j) k[i][j] = k[j][i] = i == j ? 1 : 0;
      u[i] = 0;
    }
    eliminate(k, u);
    return u;
  }

  std::vector<Place> nodes;
  std::vector<bool> fixed;   // [3 x nodes]
  std::vector<double> load;  // [3 x nodes]

 private:
  std::vector<std::vector<double>> assemble(double young, double poisson) const {
    const LameConstants m = find_lame_constants(young, poisson);
    const SolidParameters<Elastic> par{{m.lambda, m.mu}, m.lambda, m.mu, 0, {0, 0}};
    std::vector<std::vector<double>> k(load.size(), std::vector<double>(load.size(), 0.0));
    for (int j = 0; j < b_; ++j) {
      for (int i = 0; i < a_; ++i) {
        std::array<std::size_t, 8> e{};
        for (int c = 0; c < 8; ++c)
          e[static_cast<std::size_t>(c)] =
              find(i + (corner_xi[c] + 1) / 2, j + (corner_eta[c] + 1) / 2, (corner_zeta[c] + 1) / 2);
        add_element(par, e, k);
      }
    }
    return k;
  }

  void add_element(const SolidParameters<Elastic>& par, const std::array<std::size_t, 8>& e,
                   std::vector<std::vector<double>>& k) const {
    Corners x{};
    for (std::size_t c = 0; c < 8; ++c) x.x[c] = nodes[e[c]][0], x.y[c] = nodes[e[c]][1], x.z[c] = nodes[e[c]][2];
    const double dt = 1e-9;
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t d = 0; d < 3; ++d) {
        Corners v{}, f{};
        (d == 0 ? v.x : d == 1 ? v.y : v.z)[c] = 1;
        auto state = make_state<Elastic, kind>(1.0);
        advance_hex8(par, find_modes(x), find_modes(v), dt, state, {f.x, f.y, f.z});
        for (std::size_t i = 0; i < 8; ++i) {
          k[3 * e[i]][3 * e[c] + d] += f.x[i] / dt;
          k[3 * e[i] + 1][3 * e[c] + d] += f.y[i] / dt;
          k[3 * e[i] + 2][3 * e[c] + d] += f.z[i] / dt;
        }
      }
    }
  }

  static void eliminate(std::vector<std::vector<double>>& k, std::vector<double>& u) {
    const std::size_t n = u.size();
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t i = p + 1; i < n; ++i) {
        const double share = k[i][p] / k[p][p];
        if (share == 0) continue;
        for (std::size_t j = p; j < n; ++j) k[i][j] -= share * k[p][j];
        u[i] -= share * u[p];
      }
    }
    for (std::size_t p = n; p-- > 0;) {
      for (std::size_t j = p + 1; j < n; ++j) u[p] -= k[p][j] * u[j];
      u[p] /= k[p][p];
    }
  }

  int a_, b_;
};

/// Deflection of a strip of ten elements with a load at its tip over that of a plate in cylindrical bending. ratio:
/// length of an element over the thickness, which is 1.
double bend_strip(double ratio, double poisson) {
  const double length = 10 * ratio;
  Layer strip(10, 1, [&](double s, double t, int side) { return Place{length * s, ratio * t, side - 0.5}; });
  for (int side = 0; side < 2; ++side) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i <= 10; ++i) strip.fixed[3 * strip.find(i, j, side) + 1] = true;
      strip.fixed[3 * strip.find(0, j, side)] = true;
      strip.fixed[3 * strip.find(0, j, side) + 2] = side == 0;
      strip.load[3 * strip.find(10, j, side) + 2] = 0.25;
    }
  }
  const double rigidity = 1 / (12 * (1 - poisson * poisson));
  return strip.solve(1, poisson)[3 * strip.find(10, 0, 0) + 2] / (std::pow(length, 3) / (3 * rigidity * ratio));
}

}  // namespace

TEST(ThickShellStatics, CantileverBendsAsAPlateHoweverThin) {
  // Ten elements of constant transverse shear lack 1 / (4 n^2) of the deflection.
  for (const double ratio : {10.0, 30.0, 100.0})
    for (const double poisson : {0.0, 0.3, 0.49}) EXPECT_NEAR(bend_strip(ratio, poisson), 1 - 1.0 / 400, 5e-4);
}

TEST(ThickShellStatics, PinchedHemisphereHasThePublishedDeflection) {
  // A quarter of a hemisphere with a hole of 18 degrees, of radius 10 and thickness 0.04: 0.094 under forces of 2
  // (MacNeal and Harder, Finite Elements in Analysis and Design 1, 1985), 0.093 in later works. Here with 0.1.
  constexpr int n = 8;
  Layer shell(n, n, [](double s, double t, int side) {
    const double radius = 10 + 0.04 * (side - 0.5), around = std::numbers::pi / 2 * s, up = 0.4 * std::numbers::pi * t;
    return Place{radius * std::cos(up) * std::cos(around), radius * std::cos(up) * std::sin(around),
                 radius * std::sin(up)};
  });
  for (int side = 0; side < 2; ++side) {
    for (int j = 0; j <= n; ++j) {
      shell.fixed[3 * shell.find(0, j, side) + 1] = true;
      shell.fixed[3 * shell.find(n, j, side)] = true;
    }
    shell.load[3 * shell.find(0, 0, side)] = 0.05;
    shell.load[3 * shell.find(n, 0, side) + 1] = -0.05;
  }
  shell.fixed[3 * shell.find(0, n, 0) + 2] = true;
  const std::vector<double> u = shell.solve(6.825e7, 0.3);
  EXPECT_NEAR(u[3 * shell.find(0, 0, 0)] / 0.0094, 0.996, 0.005);
  EXPECT_NEAR(u[3 * shell.find(n, 0, 0) + 1] / -0.0094, 0.996, 0.005);
}

TEST(ThickShellStatics, SimplySupportedSquareHasTheDeflectionOfAThinPlate) {
  // 0.0040624 q a^4 / D under a uniform load, on 8 x 8 elements, also distorted ones.
  constexpr int n = 8;
  constexpr double side_length = 10, thickness = 0.1, poisson = 0.3;
  for (const double distortion : {0.0, 0.5}) {
    Layer plate(n, n, [&](double s, double t, int side) {
      return Place{side_length * (s + distortion * s * (1 - s) * (t - 0.3)),
                   side_length * (t + 1.3 * distortion * t * (1 - t) * (s - 0.6)), thickness * (side - 0.5)};
    });
    for (int side = 0; side < 2; ++side) {
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          const std::size_t at = 3 * plate.find(i, j, side);
          const bool at_x = i == 0 || i == n, at_y = j == 0 || j == n;
          plate.fixed[at + 2] = at_x || at_y;
          plate.fixed[at + 1] = at_x;
          plate.fixed[at] = at_y;
        }
      }
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Place &a = plate.nodes[plate.find(i, j, 0)], &b = plate.nodes[plate.find(i + 1, j, 0)],
                    &c = plate.nodes[plate.find(i + 1, j + 1, 0)], &d = plate.nodes[plate.find(i, j + 1, 0)];
        const double area = 0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
        for (int k = 0; k < 8; ++k)
          plate.load[3 * plate.find(i + (corner_xi[k] + 1) / 2, j + (corner_eta[k] + 1) / 2, (corner_zeta[k] + 1) / 2) +
                     2] += area / 8;
      }
    }
    const double rigidity = std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
    const double u = plate.solve(1, poisson)[3 * plate.find(n / 2, n / 2, 0) + 2];
    EXPECT_NEAR(u / (0.0040624 * std::pow(side_length, 4) / rigidity), distortion > 0 ? 0.991 : 0.9953, 0.003);
  }
}

}  // namespace percuss::test::thick_shell_statics_test
