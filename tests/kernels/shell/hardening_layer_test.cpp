// Layers of the solids' hardening laws, against those laws themselves and against exact answers.

#include "kernels/shell/hardening_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::hardening_layer_test {
namespace {

constexpr double young = 70e9, poisson = 0.33, density = 2700;

PowerLawPlasticity make_power_law() { return {young, poisson, 200e6, 400e6, 0.3}; }

PowerLawPlasticity make_fast_power_law() { return {young, poisson, 200e6, 400e6, 0.3, 6500, 4}; }

VocePlasticity make_voce() { return {young, poisson, 250e6, 150e6, 20, 1e8, 40, 5}; }

TabulatedPlasticity make_table() {
  TabulatedPlasticity law{young, poisson, {}};
  law.hardening.rows = 4;
  const double rows[4][2] = {{0, 200e6}, {0.01, 260e6}, {0.05, 300e6}, {0.3, 330e6}};
  for (int i = 0; i < 4; ++i) {
    law.hardening.x[i] = rows[i][0];
    law.hardening.y[i] = rows[i][1];
  }
  return law;
}

RateTablePlasticity make_rate_table() {
  using Rows = std::vector<std::array<double, 2>>;
  RateTablePlasticity law{young, poisson, {}, true};
  law.hardening.add_curve(0.1, Rows{{0, 200e6}, {0.01, 260e6}, {0.05, 300e6}});
  law.hardening.add_curve(100, Rows{{0, 250e6}, {0.2, 380e6}});
  law.hardening.add_curve(1e4, Rows{{0, 450e6}, {0.2, 400e6}});
  return law;
}

CombinedHardening make_combined() { return {young, poisson, 220e6, 4e9, 0.6}; }

CombinedHardening make_fast_combined() { return {young, poisson, 220e6, 4e9, 0.3, 40, 5}; }

Chaboche make_chaboche() { return {young, poisson, 150e6, {3, {0, 50, 400}, {0.5e9, 4e9, 40e9}}, 60e6, 15, 1e9}; }

Chaboche make_softening_chaboche() {
  return {young, poisson, 250e6, {2, {30, 500}, {3e9, 30e9}}, -90e6, 40, 0, 100, 4};
}

JohnsonCook make_johnson_cook() {
  JohnsonCook law;
  law.youngs_modulus = young;
  law.poissons_ratio = poisson;
  law.a = 324e6, law.b = 114e6, law.n = 0.42, law.c = 0.02, law.m = 1.34;
  law.melt_temperature = 925;
  law.specific_heat = 885;
  return law;
}

template <class Law>
HardeningLayer make_layer(const Law& law) {
  return HardeningLayer::make(law, find_plane_elasticity(young, poisson), density);
}

template <class F>
void for_each_law(const F& f) {
  f(make_power_law(), "power law");
  f(make_fast_power_law(), "power law with rate");
  f(make_voce(), "Voce with rate");
  f(make_table(), "table");
  f(make_rate_table(), "table of rates");
  f(make_combined(), "combined");
  f(make_fast_combined(), "combined with rate");
  f(make_chaboche(), "Chaboche");
  f(make_softening_chaboche(), "Chaboche, softening, with rate");
  f(make_johnson_cook(), "Johnson-Cook");
}

/// The solid's own law, by a strain across the layer that leaves no stress there.
template <class Law>
struct SolidLayer {
  Law law;
  static constexpr int most = std::max(Law::history_count, HardeningLayer::most_history);
  Symmetric3<double> stress{};
  double history[most] = {};

  explicit SolidLayer(const Law& of) : law(of) {
    if constexpr (requires { law.start(history); }) law.start(history);
  }

  /// The point after a strain increment with `across`.
  PointStep<double> follow(const double (&de)[3], double across, double dt, double* own) const {
    std::copy_n(history, most, own);
    PointStep<double> step;
    step.motion.de = {de[0], de[1], across, 0.5 * de[2], 0, 0};
    step.motion.dt = dt;
    step.motion.volume_ratio = 1;
    step.stress = stress;
    step.history = own;
    step.density = density;
    law.update(step);
    return step;
  }

  /// Advances the state; returns the strain across.
  double update(const double (&de)[3], double dt) {
    double low = -0.3, high = 0.3, own[most];
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (follow(de, middle, dt, own).stress.zz > 0 ? high : low) = middle;
    }
    stress = follow(de, high, dt, own).stress;
    std::copy_n(own, most, history);
    return high;
  }

  /// Scalar k of what a layer remembers.
  double remembered(int k) const {
    if constexpr (requires { law.kinematic_modulus(); }) {  // p, a by xx, yy, zz, xy, ...: b = a - a_zz I
      if (k > 0) return k == 3 ? history[4] : history[k] - history[3];
    }
    if constexpr (requires { law.back_stresses; }) {  // such rows of each term
      const double* const a = history + 1 + 6 * ((k - 1) / 3);
      if (k > 0) return k % 3 == 0 ? a[3] : a[(k - 1) % 3] - a[2];
    }
    return history[k];
  }
};

// Backward Euler without stress across is the projected return.
TEST(HardeningLayer, IsTheSolidsLawWithoutStressAcross) {
  for_each_law([](const auto& law, const char* name) {
    Random random(5);
    const HardeningLayer layer = make_layer(law);
    SolidLayer solid(law);
    double stress[3] = {0, 0, 0}, history[HardeningLayer::most_history] = {};
    layer.start(history);
    for (int i = 0; i < 60; ++i) {
      const double size = i % 3 == 0 ? 0.02 : 0.002, dt = i % 2 == 0 ? 1e-6 : 1e-3;
      const double de[3] = {size * random(), size * random(), size * random()};
      const double across = layer.update(stress, history, de, dt).across;
      EXPECT_NEAR(across, solid.update(de, dt), 1e-11) << name << ", step " << i;
      const double expected[3] = {solid.stress.xx, solid.stress.yy, solid.stress.xy};
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], expected[k], 1.0) << name << ", step " << i;  // of 3e8
      EXPECT_NEAR(history[0], solid.history[0], 1e-10) << name;
      for (int k = 1; k < layer.count_history(); ++k)  // a temperature, or stresses
        EXPECT_NEAR(history[k], solid.remembered(k), layer.count_history() > 2 ? 1.0 : 1e-6) << name;
    }
    EXPECT_GT(history[0], 0.1) << name;
  });
}

TEST(HardeningLayer, UniaxialTensionOfAPowerLawIsExact) {
  const PowerLawPlasticity law = make_power_law();
  const HardeningLayer layer = make_layer(law);
  for (const double p : {1e-5, 1e-3, 0.1}) {
    const double exact = 200e6 + 400e6 * std::pow(p, 0.3), elastic = exact / young;
    const double lateral = -poisson * elastic - p / 2;
    double stress[3] = {0, 0, 0}, history[HardeningLayer::most_history] = {};
    const double de[3] = {elastic + p, lateral, 0};
    const LayerResponse<double> response = layer.update(stress, history, de, 1.0);
    EXPECT_NEAR(stress[0] / exact, 1, 1e-11) << p;
    EXPECT_NEAR(stress[1] / exact, 0, 1e-11) << p;
    EXPECT_NEAR(history[0] / p, 1, 1e-10) << p;
    EXPECT_NEAR(response.across / lateral, 1, 1e-10) << p;
  }
}

// There and back: in uniaxial stress the surface has the middle k H e_p and the radius sigma_y + (1 - k) H p.
TEST(HardeningLayer, OfCombinedHardeningYieldsEarlierOnTheWayBack) {
  const CombinedHardening law = make_combined();
  const HardeningLayer layer = make_layer(law);
  const double k = law.kinematic_share * law.hardening_modulus, i = law.hardening_modulus - k;
  const double there = 0.03, back = 0.05;
  const double pulled = law.yield_stress + (k + i) * there;
  const double pushed = k * (there - back) - (law.yield_stress + i * (there + back));
  double stress[3] = {0, 0, 0}, history[HardeningLayer::most_history] = {};
  const auto follow = [&](double change, double plastic) {
    const double elastic = change / young, lateral = -poisson * elastic - 0.5 * plastic;
    const double de[3] = {elastic + plastic, lateral, 0};
    EXPECT_NEAR(layer.update(stress, history, de, 1.0).across / lateral, 1, 1e-10);
  };
  follow(pulled, there);
  EXPECT_NEAR(stress[0] / pulled, 1, 1e-11);
  EXPECT_NEAR(history[1] / (k * there), 1, 1e-10);
  EXPECT_NEAR(history[0], there, 1e-12);
  follow(pushed - pulled, -back);
  EXPECT_NEAR(stress[0] / pushed, 1, 1e-11);
  EXPECT_NEAR(stress[1] / pushed, 0, 1e-11);
  EXPECT_NEAR(history[0], there + back, 1e-12);
  EXPECT_NEAR(history[1] / (k * (there - back)), 1, 1e-9);
}

// rho cp dT = beta times the work, of which the elastic part is nothing beside p = 0.2.
TEST(HardeningLayer, OfJohnsonAndCookIsHeatedByItsPlasticWork) {
  const HardeningLayer layer = make_layer(make_johnson_cook());
  double stress[3] = {0, 0, 0}, history[2];
  layer.start(history);
  EXPECT_EQ(history[1], 293.15);
  double work = 0;
  const double de[3] = {0, 0, 1e-4};
  for (int i = 0; i < 4000; ++i) {
    const double before = stress[2], p = history[0];
    layer.update(stress, history, de, 1e-6);
    if (history[0] > p) work += 0.5 * (before + stress[2]) * std::sqrt(3) * (history[0] - p);
  }
  EXPECT_GT(history[0], 0.2);
  EXPECT_NEAR(history[1] - 293.15, 0.9 * work / (density * 885), 1e-9 * work / density);
}

TEST(HardeningLayer, ThatHasMoltenHasNoStress) {
  JohnsonCook law = make_johnson_cook();
  law.start_temperature = 1000;
  const HardeningLayer layer = make_layer(law);
  double stress[3] = {0, 0, 0}, history[2];
  layer.start(history);
  const double de[3] = {0.01, -0.002, 0.02};
  layer.update(stress, history, de, 1e-6);
  for (const double s : stress) EXPECT_LT(std::abs(s), 1e-2);
  EXPECT_GT(history[0], 0.01);
  EXPECT_NEAR(history[1], 1000, 1e-9);
}

TEST(HardeningLayer, PackGivesTheBitsOfTheScalarInEveryLane) {
  constexpr int width = pack_size<double>;
  for_each_law([](const auto& law, const char* name) {
    Random random(3);
    const HardeningLayer layer = make_layer(law);
    constexpr int most = HardeningLayer::most_history;
    alignas(64) double de[3][width], stress[3][width], remembered[most][width];
    Pack<double> pack_stress[3] = {Pack<double>(0), Pack<double>(0), Pack<double>(0)}, pack_de[3], pack_history[most];
    double start[most] = {};
    layer.start(start);
    for (int k = 0; k < most; ++k) pack_history[k] = Pack<double>(start[k]);
    for (int lane = 0; lane < width; ++lane) {
      const double size = lane % 2 == 0 ? 0.05 : 0.001;
      for (auto& row : de) row[lane] = size * random();
    }
    for (int k = 0; k < 3; ++k) pack_de[k] = load_pack(de[k]);
    layer.update(pack_stress, pack_history, pack_de, Pack<double>(1e-5));
    for (int k = 0; k < 3; ++k) store_pack(stress[k], pack_stress[k]);
    for (int k = 0; k < most; ++k) store_pack(remembered[k], pack_history[k]);
    for (int lane = 0; lane < width; ++lane) {
      double s[3] = {0, 0, 0}, history[most];
      std::copy_n(start, most, history);
      const double e[3] = {de[0][lane], de[1][lane], de[2][lane]};
      layer.update(s, history, e, 1e-5);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(stress[k][lane], s[k]) << name;
      for (int k = 0; k < layer.count_history(); ++k) EXPECT_EQ(remembered[k][lane], history[k]) << name;
    }
  });
}

}  // namespace
}  // namespace percuss::test::hardening_layer_test
