// Rolled sheet in plane stress against the closed forms of Hill (1948), and of Barlat and Lian (1989).

#include "kernels/shell/metal_ply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "kernels/shell/layer_of_law.hpp"

namespace percuss::test::metal_ply_test {
namespace {

constexpr double yield = 200, slope = 100;
constexpr double steel_ratios[3] = {1.8, 1.2, 2.3}, aluminium_ratios[3] = {0.7, 0.5, 0.9};

AnisotropicPlasticityConstants make_constants(const double (&r)[3], double exponent) {
  AnisotropicPlasticityConstants c;
  c.youngs_modulus = 70e3;
  c.poissons_ratio = 0.33;
  c.hardening = {2, {0, 1}, {yield, yield + slope}};
  for (int k = 0; k < 3; ++k) c.r_values[k] = r[k];
  c.exponent = exponent;
  return c;
}

MetalPly make_metal(const AnisotropicPlasticityConstants& c) {
  return make_ply(AnisotropicPlasticity::make(c), 1).anisotropic_metal;
}

/// A point whose axis 1 has an angle to that of the element.
struct MetalPoint {
  MetalPly ply;
  PlaneDirection<double> axes;
  double stress[3] = {}, history[PlyHistory::count] = {};
  double strain[3] = {}, across = 0;

  explicit MetalPoint(const AnisotropicPlasticityConstants& c, double degrees = 0)
      : ply(make_metal(c)),
        axes{std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180)} {}

  LayerResponse<double> advance(const double (&de)[3]) {
    const LayerResponse<double> response = ply.update(axes, stress, history, de, 1e-3);
    across += response.across;
    for (int k = 0; k < 3; ++k) strain[k] += de[k];
    return response;
  }

  /// Strain along x with the stress (s, share s, 0): the other strains by Newton's method with difference quotients.
  void pull(double by, double share = 0) {
    double de[3] = {by, 0, 0};
    for (int iteration = 0; iteration < 30; ++iteration) {
      const auto left = [&](double yy, double xy, double(&rest)[2]) {
        MetalPoint trial = *this;
        trial.advance({by, yy, xy});
        rest[0] = trial.stress[1] - share * trial.stress[0];
        rest[1] = trial.stress[2];
      };
      constexpr double d = 1e-8;
      double at[2], by_yy[2], by_xy[2];
      left(de[1], de[2], at);
      if (std::abs(at[0]) + std::abs(at[1]) < 1e-10 * yield) break;
      left(de[1] + d, de[2], by_yy);
      left(de[1], de[2] + d, by_xy);
      const double a = (by_yy[0] - at[0]) / d, b = (by_xy[0] - at[0]) / d;
      const double c = (by_yy[1] - at[1]) / d, e = (by_xy[1] - at[1]) / d, over = 1 / (a * e - b * c);
      de[1] -= over * (e * at[0] - b * at[1]);
      de[2] -= over * (a * at[1] - c * at[0]);
    }
    advance(de);
  }

  double plastic(int k) const {
    const double nu = ply.elasticity.poissons_ratio, e = ply.elasticity.youngs_modulus;
    return strain[k] - (stress[k] - nu * stress[1 - k]) / e;
  }
};

/// Uniaxial yield stress over that along axis 1, and the plastic strain of the width over that of the thickness.
struct Tension {
  double stress, ratio;
};

Tension find_hill(const double (&r)[3], double degrees) {
  const HillCoefficients q = HillCoefficients::of_strain_ratios(r);
  const double angle = degrees * std::numbers::pi / 180, cc = std::pow(std::cos(angle), 2), ss = 1 - cc;
  const double mixed = (2 * q.n - q.f - q.g - 4 * q.h) * cc * ss;
  return {1 / std::sqrt(q.f * ss + q.g * cc + q.h + mixed), (q.h + mixed) / (q.f * ss + q.g * cc)};
}

/// By derivatives of the formula of Barlat and Lian, by differences.
double find_barlat(const BarlatSurface& of, double s1, double s2, double s12) {
  const double k = (s1 + of.h * s2) / 2, q = std::hypot((s1 - of.h * s2) / 2, of.p * s12), a = 2 - of.c,
               m = of.exponent;
  return std::pow((a * std::pow(std::abs(k + q), m) + a * std::pow(std::abs(k - q), m) + of.c * std::pow(2 * q, m)) / 2,
                  1 / m);
}

Tension find_barlat(const BarlatSurface& of, double degrees) {
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle), d = 1e-6;
  const auto f = [&](double x, double y, double z) { return find_barlat(of, c * c + x, s * s + y, c * s + z); };
  const double e1 = (f(d, 0, 0) - f(-d, 0, 0)) / (2 * d), e2 = (f(0, d, 0) - f(0, -d, 0)) / (2 * d);
  const double shear = (f(0, 0, d) - f(0, 0, -d)) / (2 * d);
  const double width = s * s * e1 + c * c * e2 - c * s * shear;
  return {1 / f(0, 0, 0), -width / (e1 + e2)};
}

void expect_tension(const AnisotropicPlasticityConstants& c, double degrees, const Tension& exact) {
  MetalPoint point(c, -degrees);  // axis 1 is turned against the pull
  for (int i = 0; i < 20; ++i) point.pull(1e-3);
  const double p = point.history[0];
  EXPECT_NEAR(point.stress[0], exact.stress * (yield + slope * p), 1e-8 * yield) << degrees;
  EXPECT_NEAR(point.plastic(1) / -(point.plastic(0) + point.plastic(1)), exact.ratio, 1e-6 * exact.ratio) << degrees;
}

}  // namespace

TEST(MetalPly, IsMisesPlasticityWhereAllRatiosAreOne) {
  const double one[3] = {1, 1, 1};
  for (const double exponent : {2.0, 2.0 + 1e-13}) {  // Hill's form, and Barlat's
    MetalPoint point(make_constants(one, exponent), 17);
    const J2Layer isotropic{point.ply.elasticity, yield, slope};
    double stress[3] = {}, p[1] = {};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-3e-3, 3e-3);
    for (int i = 0; i < 500; ++i) {
      const double de[3] = {any(random), any(random), any(random)};
      const LayerResponse<double> a = point.advance(de), b = isotropic.update(stress, p, de, 1e-3);
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(point.stress[k], stress[k], 1e-11 * yield);
      ASSERT_NEAR(a.across, b.across, 1e-13);
      ASSERT_NEAR(a.share, b.share, 1e-11);
      ASSERT_NEAR(a.secant, i == 0 ? 1 : a.secant, 1e-11);
    }
    EXPECT_NEAR(point.history[0], p[0], 1e-12);
    EXPECT_GT(p[0], 0.3);
  }
}

TEST(MetalPly, HillsSheetHasItsYieldStressAndStrainRatioInEachDirection) {
  for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0}) {
    expect_tension(make_constants(steel_ratios, 2), degrees, find_hill(steel_ratios, degrees));
  }
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(find_hill(steel_ratios, 45 * k).ratio, steel_ratios[k], 1e-12);
}

TEST(MetalPly, BarlatsSheetHasItsYieldStressAndStrainRatioInEachDirection) {
  for (const double exponent : {6.0, 8.0}) {
    const BarlatSurface surface = BarlatSurface::of_strain_ratios(aluminium_ratios, exponent);
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0})
      expect_tension(make_constants(aluminium_ratios, exponent), degrees, find_barlat(surface, degrees));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(find_barlat(surface, 45 * k).ratio, aluminium_ratios[k], 1e-6);
  }
}

TEST(MetalPly, YieldsInEquibiaxialTension) {
  const HillCoefficients hill = HillCoefficients::of_strain_ratios(steel_ratios);
  const BarlatSurface barlat = BarlatSurface::of_strain_ratios(aluminium_ratios, 8);
  const auto expect = [](const AnisotropicPlasticityConstants& c, double stress) {
    MetalPoint point(c, 30);
    for (int i = 0; i < 20; ++i) point.pull(5e-4, 1);
    EXPECT_NEAR(point.stress[0], stress * (yield + slope * point.history[0]), 1e-8 * yield);
  };
  expect(make_constants(steel_ratios, 2), 1 / std::sqrt(hill.f + hill.g));
  expect(make_constants(aluminium_ratios, 8), 1 / find_barlat(barlat, 1, 1, 0));
}

TEST(MetalPly, WithoutStrainNothingMoves) {
  for (const double exponent : {2.0, 8.0}) {
    MetalPoint point(make_constants(steel_ratios, exponent), 30);
    const LayerResponse<double> response = point.advance({0, 0, 0});
    EXPECT_EQ(response.across, 0);
    EXPECT_EQ(response.share, 1);
    EXPECT_EQ(response.secant, 1);
    for (const double stress : point.stress) EXPECT_EQ(stress, 0);
  }
}

TEST(MetalPly, TheSameSurfaceByRatiosOfStrainAndOfStress) {
  const HillCoefficients a = HillCoefficients::of_strain_ratios(steel_ratios);
  const double normal[3] = {1, 1 / std::sqrt(a.f + a.h), 1 / std::sqrt(a.f + a.g)};
  const double shear[3] = {std::sqrt(1.5 / a.n), 1, 1};
  const HillCoefficients b = HillCoefficients::of_stress_ratios(normal, shear);
  const BarlatSurface quadratic = BarlatSurface::of_strain_ratios(steel_ratios, 2);
  const HillCoefficients c = HillCoefficients::of_plane({quadratic.c, quadratic.h, quadratic.p});
  for (const HillCoefficients& other : {b, c}) {
    EXPECT_NEAR(other.f, a.f, 1e-12);
    EXPECT_NEAR(other.g, a.g, 1e-12);
    EXPECT_NEAR(other.h, a.h, 1e-12);
    EXPECT_NEAR(other.n, a.n, 1e-12);
  }
}

TEST(MetalPly, TheReturnSolvesItsEquationsToRoundOff) {
  // Stress on the surface, elastic strain and normal plastic strain; steps up to a hundred times that of yield.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double exponent : {2.0, 6.0, 8.0, 20.0}) {
    for (int i = 0; i < 400; ++i) {
      MetalPoint point(make_constants(i % 2 == 0 ? steel_ratios : aluminium_ratios, exponent));
      const double size = std::pow(10, 2 * std::abs(any(random))) * yield / 70e3;
      point.advance({size * any(random), size * any(random), size * any(random)});
      const double p = point.history[0];
      if (!(p > 0)) continue;
      const PlaneElasticity& e = point.ply.elasticity;
      const double(&s)[3] = point.stress;
      const bool is_steel = i % 2 == 0;
      const BarlatSurface surface =
          BarlatSurface::of_strain_ratios(is_steel ? steel_ratios : aluminium_ratios, exponent);
      EXPECT_NEAR(find_barlat(surface, s[0], s[1], s[2]), yield + slope * std::min(p, 1.0), 1e-11 * yield);
      double normal[3];
      surface.find_strain(surface(surface.find_numbers(s)).gradient, normal);
      double elastic[3] = {};
      const double rest[3] = {point.strain[0] - p * normal[0], point.strain[1] - p * normal[1],
                              point.strain[2] - p * normal[2]};
      e.add_stress(elastic, rest);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(elastic[k], s[k], 1e-11 * 70e3 * size) << exponent;
      const double in_plane = point.strain[0] + point.strain[1];
      EXPECT_NEAR(point.across + in_plane, (1 - 2 * e.poissons_ratio) / e.youngs_modulus * (s[0] + s[1]), 1e-12 * size);
    }
  }
}

}  // namespace percuss::test::metal_ply_test
