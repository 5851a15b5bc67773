#include "kernels/shell/plane_stress.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "kernels/shell/thickness_points.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::plane_stress_test {

namespace {

constexpr double young = 70e9, poisson = 0.33, yield_stress = 300e6;

J2Layer make_material(double hardening) { return {find_plane_elasticity(young, poisson), yield_stress, hardening}; }

double find_equivalent(const double (&s)[3]) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * s[2] * s[2]);
}

/// Stress and plastic strain after a straight strain path, by fourth-order Runge-Kutta steps of the rate equations
/// (Prandtl and Reuss) from the moment of yield: no return map.
struct Reference {
  double s[3] = {0, 0, 0}, p = 0;
};

std::array<double, 4> find_rates(const double (&s)[3], const double (&de)[3], double hardening) {
  const double c = young / (1 - poisson * poisson), g = young / (2 * (1 + poisson)), eq = find_equivalent(s);
  const double n[3] = {(s[0] - 0.5 * s[1]) / eq, (s[1] - 0.5 * s[0]) / eq, 3 * s[2] / eq};
  const auto stress_of = [&](const double(&e)[3]) {
    return std::array<double, 3>{c * (e[0] + poisson * e[1]), c * (e[1] + poisson * e[0]), g * e[2]};
  };
  const auto trial = stress_of(de), back = stress_of(n);
  double loading = 0, stiffness = hardening;
  for (std::size_t k = 0; k < 3; ++k) {
    loading += n[k] * trial[k];
    stiffness += n[k] * back[k];
  }
  const double dp = loading / stiffness;
  return {trial[0] - dp * back[0], trial[1] - dp * back[1], trial[2] - dp * back[2], dp};
}

Reference integrate(const double (&strain)[3], double hardening, int steps) {
  Reference r;
  make_material(hardening).elasticity.add_stress(r.s, strain);
  const double first = yield_stress / find_equivalent(r.s);  // share of the path that is elastic
  for (double& s : r.s) s *= first;
  double de[3];
  for (std::size_t k = 0; k < 3; ++k) de[k] = (1 - first) * strain[k] / steps;
  for (int i = 0; i < steps; ++i) {
    std::array<double, 4> k[4];
    for (std::size_t stage = 0; stage < 4; ++stage) {
      const double share = stage == 0 ? 0 : stage == 3 ? 1 : 0.5;
      double at[3];
      for (std::size_t j = 0; j < 3; ++j) at[j] = r.s[j] + (stage == 0 ? 0 : share * k[stage - 1][j]);
      k[stage] = find_rates(at, de, hardening);
    }
    for (std::size_t j = 0; j < 3; ++j) r.s[j] += (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]) / 6;
    r.p += (k[0][3] + 2 * k[1][3] + 2 * k[2][3] + k[3][3]) / 6;
  }
  return r;
}

}  // namespace

TEST(PlaneStress, ReturnLiesOnTheYieldSurfaceForAnyStep) {
  Random random(1);
  for (const double hardening : {0.0, 1e9, 70e9}) {
    const J2Layer material = make_material(hardening);
    for (int trial = 0; trial < 500; ++trial) {
      double stress[3] = {0, 0, 0}, p = 0;
      const double size = std::pow(10.0, 2 * random() - 2);  // from 1e-4 to 1
      const double de[3] = {size * random(), size * random(), size * random()};
      material.update(stress, &p, de, 1.0);
      const double yield = yield_stress + hardening * p;
      if (p > 0) {
        EXPECT_NEAR(find_equivalent(stress) / yield, 1, 1e-13);
      } else {
        EXPECT_LE(find_equivalent(stress), yield_stress * (1 + 1e-15));
      }
    }
  }
}

TEST(PlaneStress, ConvergesToTheRateEquations) {
  const double strain[3] = {0.02, -0.004, 0.015};
  for (const double hardening : {0.0, 2e9}) {
    const J2Layer material = make_material(hardening);
    const Reference exact = integrate(strain, hardening, 2000);
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const int steps = level == 0 ? 500 : 1000;
      const double de[3] = {strain[0] / steps, strain[1] / steps, strain[2] / steps};
      double stress[3] = {0, 0, 0}, p = 0;
      for (int i = 0; i < steps; ++i) material.update(stress, &p, de, 1.0);
      error[level] = std::abs(p - exact.p) / exact.p;
      for (int k = 0; k < 3; ++k)
        error[level] = std::max(error[level], std::abs(stress[k] - exact.s[k]) / yield_stress);
    }
    EXPECT_LT(error[1], 2e-3);
    EXPECT_NEAR(error[0] / error[1], 2, 0.3);  // backward Euler: first order
  }
}

TEST(PlaneStress, UniaxialTensionIsExact) {
  const double hardening = 2e9, total = 0.01;
  const J2Layer material = make_material(hardening);
  // Lateral strain such that sigma_yy stays zero: elastic nu, plastic 1/2.
  const double stress_exact = (yield_stress + hardening * total) / (1 + hardening / young);
  const double plastic = total - stress_exact / young;
  double stress[3] = {0, 0, 0}, p = 0;
  const double de[3] = {total, -poisson * stress_exact / young - plastic / 2, 0};
  const double across = material.update(stress, &p, de, 1.0).across;
  EXPECT_NEAR(stress[0] / stress_exact, 1, 1e-12);
  EXPECT_NEAR(stress[1] / stress_exact, 0, 1e-12);
  EXPECT_NEAR(p, plastic, 1e-12 * total);
  EXPECT_NEAR(across, de[1], 1e-13);  // as the other lateral strain
}

TEST(PlaneStress, PackGivesTheBitsOfTheScalarInEveryLane) {
  constexpr int width = pack_size<double>;
  Random random(3);
  const J2Layer material = make_material(1e9);
  alignas(64) double de[3][width], stress[3][width], p[width];
  for (int lane = 0; lane < width; ++lane) {
    const double size = lane % 2 == 0 ? 0.05 : 0.001;
    for (auto& row : de) row[lane] = size * random();
  }
  Pack<double> pack_de[3], pack_stress[3] = {Pack<double>(0), Pack<double>(0), Pack<double>(0)}, pack_p(0);
  for (int k = 0; k < 3; ++k) pack_de[k] = load_pack(de[k]);
  material.update(pack_stress, &pack_p, pack_de, Pack<double>(1));
  for (int k = 0; k < 3; ++k) store_pack(stress[k], pack_stress[k]);
  store_pack(p, pack_p);
  for (int lane = 0; lane < width; ++lane) {
    double s[3] = {0, 0, 0}, history = 0;
    const double e[3] = {de[0][lane], de[1][lane], de[2][lane]};
    material.update(s, &history, e, 1.0);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(stress[k][lane], s[k]);
    EXPECT_EQ(p[lane], history);
  }
}

TEST(ThicknessPoints, IntegratePolynomialsExactly) {
  for (int count = 1; count <= most_thickness_points; ++count) {
    const ThicknessPoints points = find_thickness_points(count);
    for (int degree = 0; degree < 2 * count; ++degree) {
      double sum = 0;
      for (int p = 0; p < count; ++p) sum += points.weight[p] * std::pow(points.place[p], degree);
      EXPECT_NEAR(sum, degree % 2 == 0 ? 1.0 / (degree + 1) : 0.0, 1e-14) << count << " points, degree " << degree;
    }
  }
}

}  // namespace percuss::test::plane_stress_test
