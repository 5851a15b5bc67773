// Honeycomb with six different strengths and moduli, each component driven by itself against the curves written here.

#include <gtest/gtest.h>

#include <array>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::honeycomb_test {
namespace {

[[maybe_unused]] const bool has_samples = provide_sample<Honeycomb>({7e9,
                                                                     0.33,
                                                                     20e6,
                                                                     0.2,
                                                                     {1e9, 2e9, 1.5e9},
                                                                     {0.3e9, 0.5e9, 0.4e9},
                                                                     {2, {0, 0.7}, {1e6, 2e6}},
                                                                     {2, {0, 0.7}, {3e6, 9e6}},
                                                                     {2, {0, 0.7}, {5e6, 6e6}},
                                                                     {2, {0, 0.7}, {0.8e6, 1.5e6}},
                                                                     {2, {0, 0.7}, {2.2e6, 0.4e6}},
                                                                     {2, {0, 0.7}, {0.3e6, 2.4e6}}});

/// xx, yy, zz, xy, yz, zx of make_sample(): strength at a crush c, straight from c = 0 to 0.7.
struct Component {
  double at_rest, at_the_end, modulus;  // modulus: of the component over its own strain, before crush
  double solid;                         // modulus of the solid
  double find_strength(double c) const { return at_rest + (at_the_end - at_rest) * std::clamp(c / 0.7, 0.0, 1.0); }
  double find_modulus(double c) const { return modulus + (solid - modulus) * std::clamp(c / 0.8, 0.0, 1.0); }
};

constexpr double solid_shear = 7e9 / (1 + 0.33);  // 2 G
constexpr Component components[6] = {{1e6, 2e6, 1e9, 7e9},
                                     {3e6, 9e6, 2e9, 7e9},
                                     {5e6, 6e6, 1.5e9, 7e9},
                                     {0.8e6, 1.5e6, 0.6e9, solid_shear},
                                     {2.2e6, 0.4e6, 1.0e9, solid_shear},
                                     {0.3e6, 2.4e6, 0.8e9, solid_shear}};

Strain make_strain(std::size_t k, double value) {
  Strain e{};
  double* const parts[6] = {&e.xx, &e.yy, &e.zz, &e.xy, &e.yz, &e.zx};
  *parts[k] = value;
  return e;
}

std::array<double, 6> list(const Symmetric3<double>& s) { return {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}; }

double find_crush(const Point<Honeycomb>& point) { return 1 - std::exp(point.log_volume); }

/// Component k has the value, and each other what it had.
void expect_alone(const Point<Honeycomb>& point, std::size_t k, double value, const std::array<double, 6>& before) {
  const std::array<double, 6> now = list(point.stress);
  for (std::size_t i = 0; i < 6; ++i) {
    if (i == k) continue;
    EXPECT_EQ(now[i], before[i]) << i << " while " << k << " is driven";
  }
  EXPECT_NEAR(now[k], value, 1e-9 * std::abs(value)) << k;
}

}  // namespace

TEST(Honeycomb, EachDirectionIsCrushedAlongItsOwnCurve) {
  for (std::size_t k = 0; k < 3; ++k) {
    Point<Honeycomb> point(sample<Honeycomb>(), 80);
    point.advance(make_strain(k, -1e-4), 1e-3);  // elastic
    expect_alone(point, k, -components[k].find_modulus(find_crush(point)) * 1e-4, {});
    for (const double crush : {0.1, 0.35, 0.6, 0.75}) {
      const double to_go = std::log(1 - crush) - point.log_volume;
      point.follow({make_strain(k, to_go), 1, 200});
      ASSERT_NEAR(find_crush(point), crush, 1e-12);
      expect_alone(point, k, -components[k].find_strength(crush), {});
    }
    // and pulled back: elastic, then at its strength
    const double strain = 1e-5, before = list(point.stress)[k];
    point.advance(make_strain(k, strain), 1e-3);
    expect_alone(point, k, before + components[k].find_modulus(find_crush(point)) * strain, {});
    point.follow({make_strain(k, 0.01), 1, 10});
    expect_alone(point, k, components[k].find_strength(find_crush(point)), {});
    EXPECT_EQ(point.p(), 0);
  }
}

TEST(Honeycomb, PulledBackItIsElasticUpToTheTensionCutoff) {
  Honeycomb law = sample<Honeycomb>();
  law.tension_cutoff = 0.4e6;
  for (std::size_t k = 0; k < 3; ++k) {
    Point<Honeycomb> point(law, 80);
    point.follow({make_strain(k, std::log(1 - 0.35)), 1, 200});
    expect_alone(point, k, -components[k].find_strength(0.35), {});
    const double strain = 1e-5, before = list(point.stress)[k];
    point.advance(make_strain(k, strain), 1e-3);
    expect_alone(point, k, before + components[k].find_modulus(find_crush(point)) * strain, {});
    point.follow({make_strain(k, 0.01), 1, 10});
    expect_alone(point, k, 0.4e6, {});
    point.follow({make_strain(k, -0.02), 1, 20});  // pressed anew
    expect_alone(point, k, -components[k].find_strength(find_crush(point)), {});
  }
}

TEST(Honeycomb, EachShearHasItsOwnModulusAndStrengthAtAnyCrush) {
  const double strain = 1e-5;
  for (std::size_t k = 3; k < 6; ++k) {
    for (const double crush : {0.0, 0.2, 0.5, 0.75}) {
      Point<Honeycomb> point(sample<Honeycomb>(), 80);
      point.follow({make_strain(0, std::log(1 - crush)), 1, 50});
      const std::array<double, 6> before = list(point.stress);
      const double strength = components[k].find_strength(crush), elastic = components[k].find_modulus(crush) * strain;
      point.advance(make_strain(k, strain), 1e-3);
      expect_alone(point, k, elastic, before);
      point.follow({make_strain(k, 0.1), 1, 20});
      expect_alone(point, k, strength, before);
      point.advance(make_strain(k, -strain), 1e-3);
      expect_alone(point, k, strength - elastic, before);
      point.follow({make_strain(k, -0.1), 1, 20});
      expect_alone(point, k, -strength, before);
      EXPECT_EQ(point.p(), 0);
    }
  }
}

}  // namespace percuss::test::honeycomb_test
