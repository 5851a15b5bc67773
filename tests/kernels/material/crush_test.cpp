// Materials that are crushed, along paths of compaction, release and shear, against their curves.

#include <gtest/gtest.h>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::crush_test {
namespace {

[[maybe_unused]] const bool has_samples =
    provide_sample<SoilAndFoam>({1e9, 5e9, 2e6, 0.6, -1e-9, 1e6, {3, {0, 0.02, 0.1}, {0, 40e6, 300e6}}}) &&
    provide_sample<LowDensityFoam>({5e6, 0.2, 2, {4, {0, 0.05, 0.6, 0.8}, {0, 0.2e6, 0.3e6, 2e6}}});

template <class Law>
void compact(Point<Law>& point, double strain, int steps) {
  const double step = (-strain - point.log_volume) / (3 * steps);
  for (int i = 0; i < steps; ++i) point.advance({step, step, step, 0, 0, 0}, 1e-3);
}

double find_pressure(const Symmetric3<double>& stress) { return -trace(stress) / 3; }

SoilAndFoam make_soil() {
  SoilAndFoam law{};
  law.shear_modulus = 1e9;
  law.unloading_bulk_modulus = 5e9;
  law.a0 = 2e6, law.a1 = 0.6, law.a2 = -1e-9, law.tension_limit = 1e6;
  law.compaction = {3, {0, 0.02, 0.1}, {0, 40e6, 400e6}};
  return law;
}

LowDensityFoam make_foam() {
  LowDensityFoam law{};
  law.youngs_modulus = 5e6;
  law.compression = {4, {0, 0.05, 0.6, 0.8}, {0, 0.2e6, 0.3e6, 2e6}};
  return law;
}

Honeycomb make_honeycomb() {
  Honeycomb law{};
  law.youngs_modulus = 70e9, law.poissons_ratio = 0.33, law.yield_stress = 200e6, law.compacted_volume = 0.2;
  for (int k = 0; k < 3; ++k) law.crush_moduli[k] = (k + 1) * 1e9, law.shear_moduli[k] = (k + 1) * 0.3e9;
  law.crush_xx = law.crush_yy = {2, {0, 0.7}, {1e6, 2e6}};
  law.crush_zz = {1, {0}, {5e6}};
  law.crush_xy = law.crush_yz = law.crush_zx = {1, {0}, {0.8e6}};
  return law;
}

}  // namespace

TEST(SoilAndFoam, PressureFollowsCompactionReleaseAndReload) {
  Point<SoilAndFoam> point(make_soil(), 1800);
  compact(point, 0.01, 10);
  EXPECT_NEAR(find_pressure(point.stress), 20e6, 1);
  compact(point, 0.06, 37);
  EXPECT_NEAR(find_pressure(point.stress), 220e6, 10);
  compact(point, 0.03, 11);  // release: 220 - 5000 * 0.03
  EXPECT_NEAR(find_pressure(point.stress), 70e6, 10);
  compact(point, 0, 9);  // parted
  EXPECT_NEAR(find_pressure(point.stress), -1e6, 1);
  compact(point, 0.03, 10);
  EXPECT_NEAR(find_pressure(point.stress), 70e6, 10);
  compact(point, 0.08, 5);  // beyond what was reached before
  EXPECT_NEAR(find_pressure(point.stress), 310e6, 10);
  compact(point, 0.12, 5);  // past the table: on with the slope of unloading
  EXPECT_NEAR(find_pressure(point.stress), 500e6, 10);
}

TEST(SoilAndFoam, StrengthGrowsWithPressure) {
  const SoilAndFoam law = make_soil();
  for (const double strain : {0.0, 0.01, 0.05}) {
    Point<SoilAndFoam> point(law, 1800);
    compact(point, strain, 10);
    const double p = find_pressure(point.stress);
    point.follow({{0, 0, 0, 1, 0, 0}, 0.3, 30});
    const double strength = law.a0 + law.a1 * p + law.a2 * p * p;
    EXPECT_NEAR(von_mises(point.stress), strength, 1e-9 * strength + 1e-3);
    EXPECT_NEAR(find_pressure(point.stress), p, 1);  // no dilatation
    EXPECT_NEAR(point.p(), 0.6 / std::sqrt(3.0) - strength / (3 * law.shear_modulus), 1e-9);
  }
}

TEST(SoilAndFoam, HasNoStrengthWhereItsLineFallsBelowZero) {
  SoilAndFoam law = make_soil();
  law.a0 = 0;
  Point<SoilAndFoam> point(law, 1800);
  compact(point, -0.01, 10);  // tension
  point.follow({{0, 0, 0, 1, 0, 0}, 0.1, 10});
  EXPECT_EQ(von_mises(point.stress), 0);
}

TEST(Honeycomb, EachComponentHasItsOwnStrength) {
  Point<Honeycomb> point(make_honeycomb(), 80);
  point.follow({{-1, 0, 0, 0, 0, 0}, 5e-4, 1});  // elastic: its own modulus, a little stiffer as it crushes
  EXPECT_NEAR(point.stress.xx, -1e9 * 5e-4, 0.05 * 1e9 * 5e-4);
  EXPECT_EQ(point.stress.yy, 0);
  point.follow({{-1, 0, 0, 0, 0, 0}, -std::log(0.65) - 5e-4, 500});
  EXPECT_NEAR(point.stress.xx, -(1e6 + 0.35 / 0.7 * 1e6), 1);
  EXPECT_EQ(point.stress.yy, 0);
  point.follow({{0, 0, 0, 0.4, 0, 0}, 0.1, 50});
  EXPECT_NEAR(point.stress.xy, 0.8e6, 1e-3);
  EXPECT_NEAR(point.stress.xx, -(1e6 + 0.35 / 0.7 * 1e6), 1);
  EXPECT_EQ(point.p(), 0);
}

TEST(Honeycomb, CompactedItIsTheSolid) {
  const Honeycomb law = make_honeycomb();
  Point<Honeycomb> point(law, 80);
  point.follow({{-1, 0, 0, 0, 0, 0}, -std::log(0.15), 2000});
  EXPECT_NEAR(von_mises(point.stress), 200e6, 1);
  const LameConstants solid = find_lame_constants(70e9, 0.33);
  EXPECT_NEAR(point.modulus, solid.lambda + 2 * solid.mu, 1);
  const double before = find_pressure(point.stress);
  point.follow({{-1, 0, 0, 0, 0, 0}, 1e-3, 1});
  EXPECT_NEAR(find_pressure(point.stress) - before, 1e-3 * (solid.lambda + 2.0 / 3 * solid.mu), 1e-3 * 1e-3 * 70e9);
}

TEST(LowDensityFoam, UniaxialCrushFollowsItsCurveWithoutLateralStress) {
  const LowDensityFoam law = make_foam();
  Point<LowDensityFoam> point(law, 60);
  // the midpoint rule for the stretch: (1.2 / 400)^2 / 12 of strain against the largest modulus, 8.5e6
  const double tolerance = 10;
  for (const double strain : {0.03, 0.3, 0.7, 0.85, 0.3}) {
    const double target = std::log(1 - strain);
    point.follow({{target - point.log_volume, 0, 0, 0, 0, 0}, 1, 400});
    // of constant cross-section: Cauchy stress is the nominal one
    const double expected = strain > 0.8 ? 2e6 + 8.5e6 * (strain - 0.8) : law.compression(strain).y;
    EXPECT_NEAR(point.stress.xx, -expected, tolerance) << strain;
    EXPECT_NEAR(point.stress.yy, 0, tolerance);
  }
  point.follow({{std::log(1.1) - point.log_volume, 0, 0, 0, 0, 0}, 1, 400});
  EXPECT_NEAR(point.stress.xx, 0.5e6, tolerance);
}

/// Work on a point of unit volume and constant cross-section that is led to a stretch of its length.
double crush(Point<LowDensityFoam>& point, double stretch, int steps) {
  double work = 0;
  const double step = (std::log(stretch) - point.log_volume) / steps;
  for (int i = 0; i < steps; ++i) {
    const double before = point.stress.xx, from = std::exp(point.log_volume);
    point.advance({step, 0, 0, 0, 0, 0}, 1e-3);
    work += 0.5 * (before + point.stress.xx) * (std::exp(point.log_volume) - from);
  }
  return work;
}

TEST(LowDensityFoam, GivesBackTheShareOfItsWorkThatItsHysteresisLeaves) {
  for (const double shape : {0.5, 1.0, 4.0}) {
    LowDensityFoam law = make_foam();
    law.hysteretic_unloading = 0.2, law.unloading_shape = shape;
    Point<LowDensityFoam> point(law, 60);
    // below the curve up to 0.7: 5000 + 137500 + 0.1 (0.3e6 + 0.3e6 + 8.5e5) / 2, exact
    const double stored = 5000 + 0.55 * 0.25e6 + 0.1 * 0.5 * (0.3e6 + 0.3e6 + 0.85e6);
    EXPECT_NEAR(crush(point, 0.3, 2000), stored, 1e-4 * stored);
    EXPECT_NEAR(point.history[7], stored, 1e-4 * stored);
    // at half of the way back, g times the curve
    double back = crush(point, 0.65, 2000);
    const double energy = 5000 + 0.3 * (0.2e6 + 0.3 / 0.55 * 0.05e6);
    const double share = 1 - 0.8 * (1 - std::pow(energy / stored, shape));
    EXPECT_NEAR(point.stress.xx, -share * law.compression(0.35).y, 100) << shape;
    back += crush(point, 1, 4000);
    EXPECT_NEAR(-back, (0.2 + 0.8 / (shape + 1)) * stored, 1e-3 * stored) << shape;
    EXPECT_NEAR(point.stress.xx, 0, 0.1);
    // again the same way, and on along the curve
    EXPECT_NEAR(crush(point, 0.3, 4000), -back, 1e-3 * stored) << shape;
    crush(point, 0.2, 1000);
    EXPECT_NEAR(point.stress.xx, -2e6, 100);
  }
}

TEST(LowDensityFoam, TellsTheModulusOfItsRelease) {
  LowDensityFoam law = make_foam();
  law.hysteretic_unloading = 0.1, law.unloading_shape = 3;
  Point<LowDensityFoam> point(law, 60);
  crush(point, 0.4, 500);
  for (int i = 0; i < 200; ++i) {  // from the plateau to rest
    const double before = point.stress.xx, modulus = point.modulus;
    point.follow({{2e-3, 0, 0, 0, 0, 0}, 1e-3, 1});
    EXPECT_LE((point.stress.xx - before) / 2e-3, 1.02 * modulus) << i;
  }
}

TEST(LowDensityFoam, PullsAndPushesInDirectionsThatAreNotItsAxes) {
  const LowDensityFoam law = make_foam();
  // the same in axes that are turned by 30 degrees
  const double c = std::cos(0.5236), s = std::sin(0.5236);
  const Matrix3<double> q{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  Point<LowDensityFoam> straight(law, 60), turned(law, 60);
  const Symmetric3<double> rate{-0.5, 0.05, 0, 0, 0, 0};
  straight.follow({rate, 1, 100});
  turned.follow({push_forward(q, rate), 1, 100});
  EXPECT_LT(largest_difference(push_forward(q, straight.stress), turned.stress), 1e-9 * 2e6);
  const double x = std::exp(-0.5), y = std::exp(0.05);
  EXPECT_NEAR(straight.stress.xx, -law.compression(1 - x).y / y, 10);  // as above
  EXPECT_NEAR(straight.stress.yy, 5e6 * (y - 1) / x, 10);
}

}  // namespace percuss::test::crush_test
