// Orthotropic elasticity of solids against its compliance, in its own axes and in turned ones.

#include "kernels/material/laws/orthotropic.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/kernels/material/samples.hpp"

namespace percuss::test::orthotropic_test {
namespace {

[[maybe_unused]] const bool has_samples = provide_sample<Orthotropic>(
    with_oblique_axes(OrthotropicConstants{{30e9, 12e9, 15e9}, {0.25, 0.3, 0.2}, {4e9, 5e9, 6e9}}));

OrthotropicConstants make_constants() { return {{140e3, 10e3, 12e3}, {0.3, 0.4, 0.25}, {5e3, 3.5e3, 4e3}}; }

/// C times a strain in space axes; shear strains xy, yz, zx as in the tensor.
std::array<double, 6> multiply(const Orthotropic& law, const std::array<double, 6>& e) {
  std::array<double, 6> s{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) s[i] += law.stiffness[i][j] * (j < 3 ? 1 : 2) * e[j];
  return s;
}

}  // namespace

TEST(Orthotropic, ItsStiffnessIsTheInverseOfTheCompliance) {
  const OrthotropicConstants c = make_constants();
  const Orthotropic law = Orthotropic::make(c);
  const double e1 = 140e3, e2 = 10e3, e3 = 12e3;
  const double strains[6][6] = {{1 / e1, -0.3 / e1, -0.25 / e1, 0, 0, 0},
                                {-0.3 / e1, 1 / e2, -0.4 / e2, 0, 0, 0},
                                {-0.25 / e1, -0.4 / e2, 1 / e3, 0, 0, 0},
                                {0, 0, 0, 0.5 / 5e3, 0, 0},
                                {0, 0, 0, 0, 0.5 / 3.5e3, 0},
                                {0, 0, 0, 0, 0, 0.5 / 4e3}};
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<double, 6> e{};
    for (std::size_t i = 0; i < 6; ++i) e[i] = strains[k][i];
    const std::array<double, 6> s = multiply(law, e);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(s[i], i == k ? 1 : 0, 1e-12) << k << " " << i;
  }
}

TEST(Orthotropic, TurnsWithItsAxes) {
  // Along a direction at an angle in the plane of 1 and 2 the modulus is that of Jones, section 2.8.
  OrthotropicConstants c = make_constants();
  const double angle = std::numbers::pi / 6;
  const double first[3] = {std::cos(angle), std::sin(angle), 0}, second[3] = {-1, 1, 0};
  for (int k = 0; k < 3; ++k) {
    c.first_axis[k] = first[k];
    c.second_axis[k] = second[k];
  }
  const Orthotropic law = Orthotropic::make(c);
  const double co = std::cos(angle), si = std::sin(angle);
  const double over =
      std::pow(co, 4) / 140e3 + (1 / 5e3 - 2 * 0.3 / 140e3) * co * co * si * si + std::pow(si, 4) / 10e3;
  // Strain of a stress xx = 1: by the inverse of the stiffness, one column of which is solved for.
  double a[6][7] = {};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) a[i][j] = law.stiffness[i][j];
    a[i][6] = i == 0 ? 1 : 0;
  }
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 6; ++i) {
      if (i == k) continue;
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j < 7; ++j) a[i][j] -= factor * a[k][j];
    }
  EXPECT_NEAR(a[0][6] / a[0][0], over, 1e-12 * over);
}

TEST(Orthotropic, RefusesRatiosThatNoMaterialHas) {
  OrthotropicConstants c = make_constants();
  EXPECT_STREQ(c.find_fault(), "");
  c.poissons_ratios[0] = 3.8;
  EXPECT_STRNE(c.find_fault(), "");
  c = make_constants();
  c.second_axis[0] = 2;
  c.second_axis[1] = 0;
  EXPECT_STRNE(c.find_fault(), "");
}

TEST(Orthotropic, NoStrainMeetsMoreStiffnessThanItsBound) {
  const Orthotropic law = Orthotropic::make(make_constants());
  for (int sample = 0; sample < 500; ++sample) {
    std::array<double, 6> e{};
    double square = 0, energy = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      e[i] = std::sin(12.9898 * sample + 78.233 * static_cast<double>(i));
      square += (i < 3 ? 1 : 2) * e[i] * e[i];
    }
    const std::array<double, 6> s = multiply(law, e);
    for (std::size_t i = 0; i < 6; ++i) energy += (i < 3 ? 1 : 2) * s[i] * e[i];
    ASSERT_LE(energy, 2 * law.moduli().mu * square);
    ASSERT_GT(energy, 0);
  }
}

}  // namespace percuss::test::orthotropic_test
