// The mixed form over blocks of tetrahedra: patch test, power, guard and step.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/tet/tet_patch.hpp"

namespace percuss::test {
namespace {

Field make_field(Random& random, std::size_t count) {
  Field v;
  for (std::size_t i = 0; i < count; ++i) v.push_back({random(), random(), random()});
  return v;
}

double find_power(const Field& f, const Field& v) {
  double power = 0;
  for (std::size_t i = 0; i < v.size(); ++i) power += dot(f[i], v[i]);
  return power;
}

TEST(MixedTets, HaveOneStressInALinearField) {
  Random random(11);
  TetPatch patch(random, 3, 0.2);
  const HexParameters<Elastic> par = make_tet_parameters({2e9, 1e9});
  const Matrix3<double> g = random_matrix(random, 1);
  Field v;
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
  const HexParameters<Elastic> par = make_tet_parameters({2e9, 1e9}, {0.06, 1.2});
  const Field v = make_field(random, patch.x.size());
  for (std::size_t e = 0; e < patch.states.size(); e += 5) patch.states[e].gap = -0.6;
  // From the guard's own start: its work of the first step is that of the trapezoid from zero.
  const double dt = 1e-7;
  patch.advance(par, Field(v.size(), {0, 0, 0}), 0);
  const Field before = patch.advance(par, v, 0).force;
  for (std::size_t n = 0; n < v.size(); ++n) patch.x[n] = patch.x[n] + dt * v[n];
  const auto after = patch.advance(par, v, dt);
  const double given = 0.5 * dt * (find_power(before, v) + find_power(after.force, v));
  // The geometry of forces is that of the ends, of rates that of the middle: a share of dt |grad v| apart.
  EXPECT_NEAR(after.work / given, 1, 1e-5);
}

TEST(MixedTets, ConserveMomentumAndItsMoment) {
  Random random(13);
  TetPatch patch(random, 3, 0.2);
  const Field v = make_field(random, patch.x.size());
  const auto outcome = patch.advance(make_tet_parameters({2e9, 1e9}, {0.06, 1.2}), v, 1e-3);
  Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
  double size = 0;
  for (std::size_t n = 0; n < v.size(); ++n) {
    sum = sum + outcome.force[n];
    moment = moment + cross(patch.x[n], outcome.force[n]);
    size += norm(outcome.force[n]);
  }
  EXPECT_NEAR(norm(sum) / size, 0, 1e-14);
  EXPECT_NEAR(norm(moment) / size, 0, 1e-14);
}

/// Largest omega^2 of the block by power iteration on its own forces about the state that it has.
double find_largest_square(TetPatch patch, const HexParameters<Elastic>& par, Random& random) {
  const double dt = 1e-9;
  const std::vector<ElasticTet> start = patch.states;
  const Field at_rest = patch.advance(par, Field(patch.x.size(), {0, 0, 0}), 0).force;
  Field v = make_field(random, patch.x.size());
  double square = 0;
  for (int i = 0; i < 300; ++i) {
    patch.states = start;
    const Field f = patch.advance(par, v, dt).force;
    double product = 0, length = 0, size = 0;
    Field next;
    for (std::size_t n = 0; n < v.size(); ++n) {
      const Vector3<double> change = (1 / dt) * (f[n] - at_rest[n]);
      product += dot(change, v[n]);
      length += patch.mass[n] * dot(v[n], v[n]);
      next.push_back((1 / patch.mass[n]) * change);
      size = std::max(size, norm(next.back()));
    }
    square = product / length;
    for (std::size_t n = 0; n < v.size(); ++n) v[n] = (1 / size) * next[n];
  }
  return square;
}

TEST(MixedTets, HaveAStepBelowTheTrueLargestFrequency) {
  Random random(14);
  double tightest = 0;
  for (int k = 0; k < 24; ++k) {
    TetPatch patch(random, 2, 0.3 * std::abs(random()));
    const HexParameters<Elastic> par = make_tet_parameters(find_lame_constants(1e9, 0.2 + 0.299 * random()));
    for (auto& state : patch.states)
      if (k % 2 == 1 && random() < 0) state.gap = -0.6;  // the guard acts
    TetPatch evaluated = patch;
    const double step = evaluated.advance(par, Field(patch.x.size(), {0, 0, 0}), 0).step;
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
}  // namespace percuss::test
