// The traction-separation law of glue: its curves, its energies, and forces that keep momentum.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/contact/geometry/cohesive_law.hpp"
#include "kernels/contact/geometry/glue_geometry.hpp"

namespace percuss::test::cohesive_law_test {
namespace {

CohesiveLaw make_law(double plateau = 0) {
  CohesiveLaw law;
  law.normal_stiffness = 2e14;
  law.shear_stiffness = 1e14;
  law.normal_strength = 30e6;
  law.shear_strength = 50e6;
  law.normal_energy = 300;
  law.shear_energy = 900;
  law.plateau = plateau;
  law.exponent = 1.6;
  return law;
}

/// Work by area until failure at a fixed direction of separation.
double pull_apart(const CohesiveLaw& law, double normal, double shear, double* largest = nullptr) {
  constexpr int steps = 200000;
  double work = 0, damage = 0;
  CohesivePoint before;
  for (int i = 1; i <= steps; ++i) {
    const double s = 1e-4 * i / steps;
    const CohesivePoint now = separate(law, s * normal, s * shear, damage);
    work += 0.5 * 1e-4 / steps * ((before.normal + now.normal) * normal + (before.shear + now.shear) * shear);
    if (largest != nullptr) *largest = std::max(*largest, std::hypot(now.normal, now.shear));
    before = now;
    damage = now.damage;
  }
  EXPECT_EQ(damage, 1);
  return work;
}

}  // namespace

TEST(CohesiveLaw, BilinearHasItsClosedForm) {
  const CohesiveLaw law = make_law();
  const double onset = 30e6 / 2e14, end = 2 * 300 / 30e6;
  for (const double opening : {0.3 * onset, onset, 2 * onset, 0.5 * end, 0.99 * end}) {
    const double exact = opening <= onset ? 2e14 * opening : 30e6 * (end - opening) / (end - onset);
    EXPECT_NEAR(separate(law, opening, 0, 0).normal, exact, 1e-9 * 30e6) << opening;
  }
  EXPECT_EQ(separate(law, end * 1.000001, 0, 0).damage, 1);
  EXPECT_EQ(separate(law, -1e-8, 0, 0.7).normal, -2e6);  // pressure does not see damage
}

TEST(CohesiveLaw, TrapezoidHoldsItsTraction) {
  const CohesiveLaw law = make_law(0.5);
  const double onset = 50e6 / 1e14, end_of_plateau = onset + 0.5 * 900 / 50e6,
               end = 2 * 900 / 50e6 + onset - end_of_plateau;
  for (const double slide : {onset, 0.5 * (onset + end_of_plateau), end_of_plateau})
    EXPECT_NEAR(separate(law, 0, slide, 0).shear, 50e6, 1e-6 * 50e6);
  EXPECT_NEAR(separate(law, 0, 0.5 * (end_of_plateau + end), 0).shear, 25e6, 1e-6 * 50e6);
}

TEST(CohesiveLaw, UnloadsToTheOriginAndDoesNotHeal) {
  const CohesiveLaw law = make_law();
  const CohesivePoint far = separate(law, 5e-6, 3e-6, 0), half = separate(law, 2.5e-6, 1.5e-6, far.damage);
  EXPECT_NEAR(half.normal, 0.5 * far.normal, 1e-12 * far.normal);
  EXPECT_NEAR(half.shear, 0.5 * far.shear, 1e-12 * far.shear);
  EXPECT_EQ(half.damage, far.damage);
}

// The energy of a mix is exactly that of Benzeggagh and Kenane, or of the power law, at its share of shear.
TEST(CohesiveLaw, SpendsTheEnergyOfTheMix) {
  for (const double plateau : {0.0, 0.4}) {
    for (const double angle : {0.0, 0.4, 0.9, 1.3, M_PI / 2}) {
      CohesiveLaw law = make_law(plateau);
      const double normal = std::cos(angle), shear = std::sin(angle);
      const double share = 1e14 * shear * shear / (2e14 * normal * normal + 1e14 * shear * shear);
      EXPECT_NEAR(pull_apart(law, normal, shear), 300 + 600 * std::pow(share, 1.6), 1e-4 * 300) << angle;
      law.mix = CohesiveLaw::Mix::power_law;
      law.exponent = 1;
      EXPECT_NEAR(pull_apart(law, normal, shear), 1 / ((1 - share) / 300 + share / 900), 1e-4 * 300) << angle;
    }
  }
}

// Exponential softening spends the energy of the mix too, and leaves exp(-(e - e_0) / (G - e_0)) of the stiffness.
TEST(CohesiveLaw, SoftensExponentially) {
  CohesiveLaw law = make_law();
  law.softening = CohesiveLaw::Softening::exponential;
  const double onset = law.normal_onset(), opening = 1e-6, stored = 0.5 * 2e14 * opening * opening;
  EXPECT_NEAR(separate(law, opening, 0, 0).normal, 2e14 * opening * std::exp(-(stored - onset) / (300 - onset)), 1);
  EXPECT_EQ(separate(law, 0.999 * 30e6 / 2e14, 0, 0).damage, 0);
  EXPECT_NEAR(pull_apart(law, 1, 0), 300, 2e-5 * 300);
  EXPECT_NEAR(pull_apart(law, 0, 1), 900, 2e-5 * 900);
}

// By the larger of both ratios a mix of equal ratios begins at sqrt(2) times the separation of the quadratic criterion.
TEST(CohesiveLaw, BeginsByTheLargerRatio) {
  CohesiveLaw law = make_law();
  law.onset = CohesiveLaw::Onset::maximum;
  const double opening = 30e6 / 2e14, slide = 50e6 / 1e14;
  EXPECT_EQ(separate(law, 0.999 * opening, 0.999 * slide, 0).damage, 0);
  EXPECT_GT(separate(law, 1.001 * opening, 0.5 * slide, 0).damage, 0);
  EXPECT_GT(separate(law, 0.5 * opening, 1.001 * slide, 0).damage, 0);
  const double share = 1 / (1 + law.normal_onset() / law.shear_onset());
  EXPECT_NEAR(pull_apart(law, opening / 1e-6, slide / 1e-6), 300 + 600 * std::pow(share, 1.6), 1e-4 * 300);
}

// Damage begins where the squares of both tractions over their strengths add up to 1.
TEST(CohesiveLaw, BeginsByTheQuadraticCriterion) {
  const CohesiveLaw law = make_law();
  for (const double angle : {0.2, 0.8, 1.4}) {
    const double tn = 2e14 * std::cos(angle), ts = 1e14 * std::sin(angle);
    const double s = 1 / std::sqrt(std::pow(tn / 30e6, 2) + std::pow(ts / 50e6, 2));
    EXPECT_EQ(separate(law, 0.9999 * s * std::cos(angle), 0.9999 * s * std::sin(angle), 0).damage, 0);
    EXPECT_GT(separate(law, 1.0001 * s * std::cos(angle), 1.0001 * s * std::sin(angle), 0).damage, 0);
  }
}

TEST(GlueGeometry, ForcesHaveNeitherSumNorMoment) {
  TieGeometry tie;
  const FacePoints start{{{0, 0, 0}, {1, 0, 0.05}, {1.1, 1, 0}, {0, 0.9, 0}}};
  tie.face = center_face(start);
  const double weight[4] = {0.28, 0.42, 0.18, 0.12};
  for (int i = 0; i < 4; ++i) tie.weight[i] = weight[i];
  tie.offset = {0.01, -0.02, 0.1};
  const FacePoints now{{{5.1, 3, 0}, {5.2, 4.1, 0.1}, {4.1, 4.0, 0.3}, {4, 3.1, 0.2}}};
  const Point3 node{4.9, 3.6, 0.4};
  const Separation of = find_separation(tie, 1, node, now);
  const GlueForces forces = spread_force(tie, of, {3, -2, 7});
  Point3 sum = forces.force[0], moment = cross(node, forces.force[0]);
  for (int i = 0; i < 4; ++i) {
    sum = sum + forces.force[i + 1];
    moment = moment + cross(now.corner[i], forces.force[i + 1]);
    EXPECT_LE(norm(forces.force[i + 1]), bound_shares(tie, of).share[i + 1] * norm(forces.force[0]) * (1 + 1e-12));
  }
  EXPECT_LT(norm(sum), 1e-14);
  EXPECT_LT(norm(moment), 1e-12);
}

// The power of the forces is that of the force along the rate of the separation.
TEST(GlueGeometry, ForcesDoTheWorkOfTheSeparation) {
  TieGeometry tie;
  const FacePoints start{{{0, 0, 0}, {1, 0, 0.05}, {1.1, 1, 0}, {0, 0.9, 0}}};
  tie.face = center_face(start);
  for (double& weight : tie.weight) weight = 0.25;
  tie.offset = {0, 0, 0.1};
  const Point3 velocity[5] = {{0.3, -0.2, 0.5}, {1, 0, 0.2}, {-0.4, 0.3, 0.1}, {0.2, 0.6, -0.3}, {0.1, -0.7, 0.4}};
  const auto at_time = [&](double t) {
    FacePoints face = start;
    for (int i = 0; i < 4; ++i) face.corner[i] = face.corner[i] + t * velocity[i + 1];
    return find_separation(tie, 1, Point3{0.6, 0.4, 0.3} + t * velocity[0], face);
  };
  const auto energy = [](const Separation& of) {
    return 0.5 * (3 * of.opening * of.opening + 2 * dot(of.slide, of.slide));
  };
  const Separation of = at_time(0);
  const GlueForces forces = spread_force(tie, of, -1.0 * (3 * of.opening * of.normal + 2.0 * of.slide));
  double power = 0;
  for (int i = 0; i < 5; ++i) power -= dot(forces.force[i], velocity[i]);
  EXPECT_NEAR(power, (energy(at_time(1e-5)) - energy(at_time(-1e-5))) / 2e-5, 1e-8);
}

}  // namespace percuss::test::cohesive_law_test
