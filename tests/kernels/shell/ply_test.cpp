// A ply of a laminate against the closed forms of plane stress, of the criteria and of linear softening.

#include "kernels/shell/ply.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernels/shell/layer_of_law.hpp"

namespace percuss::test::ply_test {
namespace {

/// Carbon fibres in epoxy (MPa).
OrthotropicConstants make_constants() {
  OrthotropicConstants c;
  const double moduli[3] = {140e3, 10e3, 10e3}, ratios[3] = {0.3, 0.4, 0.3}, shears[3] = {5e3, 3.5e3, 5e3};
  for (int k = 0; k < 3; ++k) {
    c.moduli[k] = moduli[k];
    c.poissons_ratios[k] = ratios[k];
    c.shear_moduli[k] = shears[k];
  }
  c.fibre_tension = 2000;
  c.fibre_compression = 1200;
  c.matrix_tension = 60;
  c.matrix_compression = 200;
  c.shear = 80;
  return c;
}

/// A point of a ply whose axis 1 has an angle to that of the element.
struct PlyPoint {
  OrthotropicPly ply;
  PlaneDirection<double> axes;
  double stress[3] = {}, history[PlyHistory::count] = {};
  double across = 0, work = 0;

  explicit PlyPoint(const OrthotropicConstants& c, double angle = 0)
      : ply(OrthotropicPly::make(c)), axes{std::cos(angle), std::sin(angle)} {}

  void strain(double xx, double yy, double xy, double length = 1) {
    const double de[3] = {xx, yy, xy}, old[3] = {stress[0], stress[1], stress[2]};
    const auto response = ply.update(axes, stress, history, de,
                                     PlyStep<double>{1, {0.5 / length, -0.5 / length}, {0.5 / length, 0.5 / length}});
    across += response.layer.across;
    for (int k = 0; k < 3; ++k) work += 0.5 * (old[k] + stress[k]) * de[k];
  }

  /// Uniaxial stress along `axis` of the frame: strain in small steps, the others follow by Newton's method.
  void pull(int axis, double strain, int steps, double length) {
    for (int i = 0; i < steps; ++i) {
      double de[3] = {};
      de[axis] = strain / steps;
      for (int iteration = 0; iteration < 40; ++iteration) {
        PlyPoint trial = *this;
        trial.strain(de[0], de[1], de[2], length);
        const int other = 1 - axis;
        const double left = trial.stress[other];
        if (std::abs(left) < 1e-9) break;
        const double stiffness = other == 0 ? ply.e1 : ply.e2;
        de[other] -= left / stiffness;
      }
      this->strain(de[0], de[1], de[2], length);
    }
  }
};

}  // namespace

TEST(Ply, HasTheModuliOfItsAxes) {
  for (const int axis : {0, 1}) {
    PlyPoint point(make_constants());
    point.pull(axis, 1e-4, 1, 1);
    const double modulus = axis == 0 ? 140e3 : 10e3, ratio = axis == 0 ? 0.3 : 0.3 * 10 / 140;
    EXPECT_NEAR(point.stress[axis] / 1e-4, modulus, 1e-6 * modulus);
    EXPECT_NEAR(point.history[PlyHistory::strain + 1 - axis], -ratio * 1e-4, 1e-12);
    EXPECT_NEAR(point.across, axis == 0 ? -0.3e-4 : -0.4e-4, 1e-12);
  }
}

TEST(Ply, AtAnAngleItsStiffnessIsThatOfLaminateTheory) {
  // Jones, section 2.6: Q11 of the turned axes, and what couples stretch and shear.
  const double angle = std::numbers::pi / 6, c = std::cos(angle), s = std::sin(angle);
  const double over = 1 / (1 - 0.3 * 0.3 * 10 / 140), q11 = 140e3 * over, q22 = 10e3 * over, q12 = 0.3 * q22, q66 = 5e3;
  PlyPoint point(make_constants(), angle);
  point.strain(1e-5, 0, 0);
  EXPECT_NEAR(point.stress[0] / 1e-5, q11 * std::pow(c, 4) + 2 * (q12 + 2 * q66) * s * s * c * c + q22 * std::pow(s, 4),
              1e-6);
  EXPECT_NEAR(point.stress[1] / 1e-5, (q11 + q22 - 4 * q66) * s * s * c * c + q12 * (std::pow(s, 4) + std::pow(c, 4)),
              1e-6);
  EXPECT_NEAR(point.stress[2] / 1e-5,
              (q11 - q12 - 2 * q66) * s * std::pow(c, 3) + (q12 - q22 + 2 * q66) * std::pow(s, 3) * c, 1e-6);
}

TEST(Ply, SoftensByTheEnergyOfItsCrack) {
  // Along each axis in tension: the work until there is no stress is the energy per area over the length.
  OrthotropicConstants c = make_constants();
  c.fibre_tension_energy = 90;
  c.matrix_tension_energy = 0.3;
  const struct {
    int axis;
    double strength, energy, length, strain;
  } cases[] = {{0, 2000, 90, 1, 0.12}, {0, 2000, 90, 2.5, 0.05}, {1, 60, 0.3, 0.5, 0.03}, {1, 60, 0.3, 1, 0.015}};
  for (const auto& [axis, strength, energy, length, strain] : cases) {
    PlyPoint point(c);
    double most = 0;
    for (int i = 0; i < 400; ++i) {
      point.pull(axis, strain / 400, 5, length);
      most = std::max(most, point.stress[axis]);
    }
    EXPECT_NEAR(most, strength, 0.005 * strength);
    EXPECT_NEAR(point.stress[axis], 0, 1e-6);
    EXPECT_NEAR(point.work, energy / length, 0.003 * energy / length) << axis << " " << length;
  }
}

TEST(Ply, FailsWhereTheCriteriaSay) {
  // Proportional strain to the point at which the first damage is seen; stresses there meet the criterion.
  OrthotropicConstants c = make_constants();
  c.fibre_tension_energy = c.fibre_compression_energy = 90;
  c.matrix_tension_energy = c.matrix_compression_energy = 1;
  c.transverse_shear = 70;
  const double paths[][3] = {{1, -0.2, 0},    {-1, 0.2, 0}, {0, 1, 0.5}, {0, -1, 1},
                             {0.02, -1, 0.2}, {0, 0, 1},    {0, 0, -1}};
  for (const auto& path : paths) {
    PlyPoint point(c);
    while (point.history[PlyHistory::fibre_damage] == 0 && point.history[PlyHistory::matrix_damage] == 0)
      point.strain(1e-6 * path[0], 1e-6 * path[1], 1e-6 * path[2], 0.01);
    const auto& s = point.stress;
    const double shear = s[2] * s[2] / (80.0 * 80.0);
    const double fibre = s[0] > 0 ? s[0] / 2000 : -s[0] / 1200;
    const double across = 200.0 / 140;
    const double matrix = s[1] > 0 ? s[1] * s[1] / 3600 + shear
                                   : s[1] * s[1] / (140.0 * 140.0) + (across * across - 1) * s[1] / 200 + shear;
    EXPECT_NEAR(std::max(fibre, matrix), 1, 2e-3) << path[0] << " " << path[1] << " " << path[2];
  }
}

TEST(Ply, FailsWhereTsaiAndWuSay) {
  OrthotropicConstants c = make_constants();
  c.is_tsai_wu = true;
  c.matrix_tension_energy = c.matrix_compression_energy = 1;
  const double paths[][3] = {{0, 1, 0}, {0, -1, 0}, {0, 1, 0.5}, {0, -1, 1}, {0.02, -1, 0.2}, {0, 0, 1}};
  for (const auto& path : paths) {
    PlyPoint point(c);
    while (point.history[PlyHistory::matrix_damage] == 0)
      point.strain(1e-6 * path[0], 1e-6 * path[1], 1e-6 * path[2], 0.01);
    const auto& s = point.stress;
    const double load = s[1] * s[1] / (60 * 200) + (1.0 / 60 - 1.0 / 200) * s[1] + s[2] * s[2] / (80 * 80);
    EXPECT_NEAR(load, 1, 2e-3) << path[0] << " " << path[1] << " " << path[2];
  }
}

TEST(Ply, KeepsItsDamageAndClosesItsCracks) {
  OrthotropicConstants c = make_constants();
  c.matrix_tension_energy = 0.3;
  PlyPoint point(c);
  point.pull(1, 0.008, 400, 1);
  const double damage = point.history[PlyHistory::matrix_tension];
  ASSERT_GT(damage, 0.2);
  ASSERT_LT(damage, 0.99);
  const double stress = point.stress[1];
  point.pull(1, -0.004, 400, 1);
  EXPECT_NEAR(point.stress[1], 0.5 * stress, 1e-3 * stress);  // back to the origin
  point.pull(1, -0.005, 400, 1);
  EXPECT_NEAR(point.stress[1], -0.001 * 10e3, 1e-6);  // closed: whole
  EXPECT_EQ(point.history[PlyHistory::matrix_tension], damage);
}

TEST(Ply, GivesNoEnergyThatItHasNotTaken) {
  // Random paths that come back to the start: the work is what cracks have taken.
  OrthotropicConstants c = make_constants();
  c.fibre_tension_energy = c.fibre_compression_energy = 90;
  c.matrix_tension_energy = c.matrix_compression_energy = 0.5;
  for (int path = 0; path < 40; ++path) {
    PlyPoint point(c, 0.3);
    const auto random = [&](int k) { return std::sin(12.9898 * (path + 1) + 78.233 * k); };
    double last[3] = {}, least = 0;
    for (int leg = 0; leg < 12; ++leg) {
      double next[3] = {0.01 * random(3 * leg), 0.02 * random(3 * leg + 1), 0.03 * random(3 * leg + 2)};
      if (leg == 11) next[0] = next[1] = next[2] = 0;
      for (int i = 0; i < 4000; ++i)
        point.strain((next[0] - last[0]) / 4000, (next[1] - last[1]) / 4000, (next[2] - last[2]) / 4000);
      for (int k = 0; k < 3; ++k) last[k] = next[k];
      least = std::min(least, point.work);
    }
    EXPECT_GE(least, -1e-6) << path;
    EXPECT_GT(point.work, 0.5) << path;
  }
}

TEST(Ply, WithoutEnergyItIsBrittleOverSomeSteps) {
  PlyPoint point(make_constants());
  point.pull(0, 0.0145, 10, 1);
  int steps = 0;
  while (point.history[PlyHistory::fibre_tension] < 1 && steps < 200) {
    point.strain(1e-5, 0, 0);  // 2 % more strain, over which a softening of 1.02 has taken all
    ++steps;
  }
  EXPECT_NEAR(point.stress[0], 0, 1e-9);
  EXPECT_NEAR(steps, 50, 15);
}

}  // namespace percuss::test::ply_test
