// The mixed form over blocks of tetrahedra: patch test, power, guard and step.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/tet/tet_patch.hpp"

namespace percuss::test::mixed_form_test {
namespace {

TEST(MixedTets, HaveOneStressInALinearField) {
  Random random(11);
  TetPatch patch(random, 3, 0.2);
  const SolidParameters<Elastic> par = make_tet_parameters({2e9, 1e9});
  const Matrix3<double> g = random_matrix(random, 1);
  NodeField v;
  for (const auto& x : patch.x) v.push_back(g * x);
  const auto outcome = patch.advance(par, v, 1e-3);
  const Symmetric3<double> first = patch.states[0].stress;
  for (const ElasticTet& state : patch.states) {
    const Symmetric3<double> difference = state.stress + -1.0 * first;
    EXPECT_NEAR(std::sqrt(contract(difference, difference) / contract(first, first)), 0, 1e-12);
  }
  for (std::size_t n = 64; n < patch.x.size(); ++n)  // the middles of cells
    EXPECT_NEAR(norm(outcome.force[n]), 0, 1e-12 * std::sqrt(contract(first, first)));
}

TEST(MixedTets, HaveForcesWhosePowerIsThatOfTheirStresses) {
  Random random(12);
  TetPatch patch(random, 3, 0.2);
  const SolidParameters<Elastic> par = make_tet_parameters({2e9, 1e9}, {0.06, 1.2});
  const NodeField v = make_field(random, patch.x.size());
  for (std::size_t e = 0; e < patch.states.size(); e += 5) patch.states[e].gap = -0.6;
  // From the guard's own start: its work of the first step is that of the trapezoid from zero.
  const double dt = 1e-7;
  patch.advance(par, NodeField(v.size(), {0, 0, 0}), 0);
  const NodeField before = patch.advance(par, v, 0).force;
  for (std::size_t n = 0; n < v.size(); ++n) patch.x[n] = patch.x[n] + dt * v[n];
  const auto after = patch.advance(par, v, dt);
  const double given = 0.5 * dt * (find_power(before, v) + find_power(after.force, v));
  // The geometry of forces is that of the ends, of rates that of the middle: a share of dt |grad v| apart.
  EXPECT_NEAR(after.work / given, 1, 1e-5);
}

TEST(MixedTets, ConserveMomentumAndItsMoment) {
  Random random(13);
  TetPatch patch(random, 3, 0.2);
  const NodeField v = make_field(random, patch.x.size());
  const auto outcome = patch.advance(make_tet_parameters({2e9, 1e9}, {0.06, 1.2}), v, 1e-3);
  expect_balance(patch.x, outcome.force);
}

TEST(MixedTets, HaveAStepBelowTheTrueLargestFrequency) {
  Random random(14);
  double tightest = 0;
  for (int k = 0; k < 24; ++k) {
    TetPatch patch(random, 2, 0.3 * std::abs(random()));
    const SolidParameters<Elastic> par = make_tet_parameters(find_lame_constants(1e9, 0.2 + 0.299 * random()));
    for (auto& state : patch.states)
      if (k % 2 == 1 && random() < 0) state.gap = -0.6;  // the guard acts
    TetPatch evaluated = patch;
    const double step = evaluated.advance(par, NodeField(patch.x.size(), {0, 0, 0}), 0).step;
    const double used = step * std::sqrt(find_largest_square(patch, par, random)) / 2;
    ASSERT_LE(used, 1) << "block " << k;
    tightest = std::max(tightest, used);
  }
  EXPECT_GT(tightest, 0.4);  // the averages take much of the stiffness that the bound has
}

TEST(MixedTets, GuardAnElementWhoseVolumeFallsFarBelowItsMean) {
  EXPECT_EQ(find_guard(-0.5, 3.0), 0);
  EXPECT_EQ(find_guard(0.7, 3.0), 0);
  EXPECT_DOUBLE_EQ(find_guard(-1.5, 3.0), -0.6);
}

}  // namespace
}  // namespace percuss::test::mixed_form_test
