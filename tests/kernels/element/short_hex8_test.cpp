// The element in float against the element in double: the same functions, which a build in single precision runs.
//
// Float's unit of rounding is u = 6e-8. What one evaluation loses is some tens of u of the largest stress or force in
// it; what many evaluations lose must not grow with their number, which the rests of long_sum.hpp see to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/element/element_chunks.hpp"
#include "kernels/material/laws/call_material.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::short_hex8_test {
namespace {

constexpr double young = 200e9, poisson = 0.3, density = 7800, unit = 6e-8;

SolidParameters<J2Plasticity> make_parameters(double yield) {
  const LameConstants c = find_lame_constants(young, poisson);
  return {{c.lambda, c.mu, yield, 1e9}, c.lambda, c.mu, 0.05, {0.06, 1.2}};
}

/// Modes of corners that are rounded to floats, as a chunk holds them.
VectorModes<float> find_short_modes(const Corners& c) {
  float u[3][8];
  for (int i = 0; i < 8; ++i) {
    u[0][i] = static_cast<float>(c.x[i]);
    u[1][i] = static_cast<float>(c.y[i]);
    u[2][i] = static_cast<float>(c.z[i]);
  }
  for (auto& row : u) to_modes(row);
  VectorModes<float> a{};
  for (int m = 1; m < 8; ++m) a[m] = {u[0][m], u[1][m], u[2][m]};
  return a;
}

Symmetric3<double> widen_all(const Symmetric3<float>& s) { return {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}; }

template <class T>
std::vector<Symmetric3<double>> list_wide_stresses(const T& stress) {
  if constexpr (std::is_array_v<T>) {
    std::vector<Symmetric3<double>> all;
    for (const auto& s : stress) all.push_back(widen_all(s));
    return all;
  } else {
    return {widen_all(stress)};
  }
}

double find_size(const Symmetric3<double>& s) { return std::sqrt(contract(s, s)); }

/// An element that both precisions go through.
template <HexKind Kind>
struct Twins {
  SolidParameters<J2Plasticity> par = make_parameters(100e6);
  Corners x;
  HexState<double, J2Plasticity, Kind> longer;
  HexState<float, J2Plasticity, Kind> shorter;
  HexResult<double> long_result{};
  HexResult<float> short_result{};
  double long_force[3][8];
  float short_force[3][8];

  explicit Twins(const Corners& start)
      : x(start), longer(make_state<J2Plasticity, Kind>(density * find_volume_gradient(find_modes(start)).volume)) {
    shorter = make_state<J2Plasticity, Kind>(static_cast<float>(longer.mass));
  }
  void advance(const Corners& v, double dt) {
    for (int i = 0; i < 8; ++i) x.x[i] += dt * v.x[i], x.y[i] += dt * v.y[i], x.z[i] += dt * v.z[i];
    long_result =
        advance_hex8(par, find_modes(x), find_modes(v), dt, longer, {long_force[0], long_force[1], long_force[2]});
    short_result = advance_hex8(par, find_short_modes(x), find_short_modes(v), static_cast<float>(dt), shorter,
                                {short_force[0], short_force[1], short_force[2]});
  }
};

template <class Kind>
class ShortHex8 : public testing::Test {};
using Kinds = testing::Types<KindOf<HexKind::assumed_strain>, KindOf<HexKind::stiffness>, KindOf<HexKind::viscous>,
                             KindOf<HexKind::full>, KindOf<HexKind::thick3>, KindOf<HexKind::thick5>>;
TYPED_TEST_SUITE(ShortHex8, Kinds);

Corners make_velocity(Random& random, double size) { return make_element(random, size, size, size, 0.4); }

}  // namespace

TYPED_TEST(ShortHex8, StepsAreThoseOfDoubleToItsOwnRoundOff) {
  Random random(31);
  // Thick shells carry a quotient of moments into the next step, which round-off changes more: 105 of these at most.
  constexpr double units = is_thick<TypeParam::value> ? 200 : 100;
  for (int k = 0; k < 20; ++k) {
    Twins<TypeParam::value> twins(make_element(random, 1, 0.7, 1.3, 0.15));
    for (int n = 0; n < 5; ++n) {
      twins.advance(make_velocity(random, 100), 2e-6);
      const auto expected = list_stresses(twins.longer);
      const auto stresses = list_wide_stresses(twins.shorter.stress);
      double largest = 0;
      for (const auto& s : expected) largest = std::max(largest, find_size(s));
      for (std::size_t p = 0; p < expected.size(); ++p) {
        EXPECT_LT(find_size(stresses[p] + (-1.0) * expected[p]), units * unit * largest);
      }
      float force[3][8];
      double size = 0;
      for (int d = 0; d < 3; ++d) {
        std::copy_n(twins.short_force[d], 8, force[d]);
        to_corners(force[d]);  // they are left by mode
        for (int i = 0; i < 8; ++i) size = std::max(size, std::abs(twins.long_force[d][i]));
      }
      for (int d = 0; d < 3; ++d) {
        for (int i = 0; i < 8; ++i) EXPECT_NEAR(force[d][i], twins.long_force[d][i], 300 * unit * size);
      }
      const double energy = std::abs(twins.long_result.work.internal) + std::abs(twins.long_result.work.hourglass);
      EXPECT_NEAR(twins.short_result.work.internal, twins.long_result.work.internal, 300 * unit * energy);
      EXPECT_NEAR(twins.short_result.work.hourglass, twins.long_result.work.hourglass, 300 * unit * energy);
      EXPECT_NEAR(twins.short_result.size / twins.long_result.size, 1, 100 * unit);
    }
  }
}

TYPED_TEST(ShortHex8, PacksGiveTheBitsOfScalars) {
  Random random(32);
  constexpr int width = pack_size<float>;
  const auto par = make_parameters(100e6);
  VectorModes<float> a[width], v[width];
  VectorModes<Pack<float>> packed_a, packed_v;
  for (int lane = 0; lane < width; ++lane) {
    a[lane] = find_short_modes(make_element(random, 1, 1, 1, 0.2));
    v[lane] = find_short_modes(make_velocity(random, 100));
  }
  const auto pack = [](const auto& get) {
    alignas(64) float row[width];
    for (int lane = 0; lane < width; ++lane) row[lane] = get(lane);
    return load_pack(row);
  };
  for (int m = 1; m < 8; ++m) {
    packed_a[m] = {pack([&](int l) { return a[l][m].x; }), pack([&](int l) { return a[l][m].y; }),
                   pack([&](int l) { return a[l][m].z; })};
    packed_v[m] = {pack([&](int l) { return v[l][m].x; }), pack([&](int l) { return v[l][m].y; }),
                   pack([&](int l) { return v[l][m].z; })};
  }
  using Lanes = Pack<float>;
  auto state = make_state<J2Plasticity, TypeParam::value>(Lanes(static_cast<float>(density)));
  Lanes f[3][8];
  const auto packed = advance_hex8(par, packed_a, packed_v, Lanes(1e-4F), state, {f[0], f[1], f[2]});
  alignas(64) float row[width];
  for (int lane = 0; lane < width; ++lane) {
    auto one = make_state<J2Plasticity, TypeParam::value>(static_cast<float>(density));
    float g[3][8];
    const auto result = advance_hex8(par, a[lane], v[lane], 1e-4F, one, {g[0], g[1], g[2]});
    for (int d = 0; d < 3; ++d) {
      for (int i = 0; i < 8; ++i) {
        store_pack(row, f[d][i]);
        EXPECT_EQ(row[lane], g[d][i]);
      }
    }
    store_pack(row, packed.stable_step);
    EXPECT_EQ(row[lane], result.stable_step);
    store_pack(row, state.history.value[1][0]);  // the rest of the plastic strain, or that of point 0
    EXPECT_EQ(row[lane], one.history.value[1][0]);
  }
}

/// A hundred turns: what is lost in each step of the rotation and of the strain must not add up with its sign.
TYPED_TEST(ShortHex8, HundredImposedTurnsLeaveLittleStress) {
  Random random(11);
  Twins<TypeParam::value> twins(make_element(random, 1, 1, 1, 0.2));
  twins.par = make_parameters(1e12);
  const Corners start = twins.x;
  const Vector3<double> axis{0.6, 0.0, 0.8};
  const double dt = 1e-5, angle_of_a_step = 0.01256;  // no turn repeats the positions, and the rounding, of another
  for (int n = 1; n <= 50000; ++n) {
    const double angle = n * angle_of_a_step;
    const Matrix3<double> q = find_rotation_increment(2 * std::tan(angle / 2) * axis, 1.0);
    const Corners next = apply(q, start);
    Corners v{};
    for (int i = 0; i < 8; ++i) {
      v.x[i] = (next.x[i] - twins.x.x[i]) / dt;
      v.y[i] = (next.y[i] - twins.x.y[i]) / dt;
      v.z[i] = (next.z[i] - twins.x.z[i]) / dt;
    }
    twins.advance(v, dt);
  }
  // 50 000 steps round their strain by some u of their angle each: 1e-9, of either sign.
  for (const auto& stress : list_wide_stresses(twins.shorter.stress)) EXPECT_LT(find_size(stress), 1e-5 * young);
  const Matrix3<float>& r = twins.shorter.polar.rotation;
  for (const auto& row : r.row) EXPECT_NEAR(norm(row), 1, 200 * unit);
  EXPECT_NEAR(dot(r.row[0], r.row[1]), 0, 200 * unit);
}

/// A turn of 1e-8 a step is below half of the last place of most of R, and would be lost without the rest.
TEST(ShortPolar, TurnsThatAreBelowTheLastPlaceAddUp) {
  const Matrix3<double> start = find_rotation_increment(Vector3<double>{0.7, -0.4, 0.5}, 1.0);
  Polar<float> polar{{}, {1, 1, 1, 0, 0, 0}, {}};
  for (int i = 0; i < 3; ++i) {
    const Vector3<double>& r = start.row[i];
    polar.rotation.row[i] = {static_cast<float>(r.x), static_cast<float>(r.y), static_cast<float>(r.z)};
  }
  const int steps = 100000;
  const double angle = 1e-8;
  const Vector3<float> spin{0, static_cast<float>(0.6 * angle), static_cast<float>(0.8 * angle)};
  Matrix3<float> turn;
  for (int n = 0; n < steps; ++n) advance_polar(antisymmetric(spin), 1.0F, polar, turn);
  const double half = std::tan(0.5 * steps * angle) * 2;
  const Matrix3<double> expected = find_rotation_increment(half * Vector3<double>{0, 0.6, 0.8}, 1.0) * start;
  for (int i = 0; i < 3; ++i) {
    const Vector3<float>& r = polar.rotation.row[i];
    const Vector3<double> difference = Vector3<double>{r.x, r.y, r.z} - expected.row[i];
    EXPECT_LT(norm(difference), 4 * unit);  // the whole turn is 1e-3
  }
}

TEST(ShortMaterial, StrainsThatAreBelowTheLastPlaceOfTheStressAddUp) {
  const auto par = make_parameters(400e6);
  const Elastic elastic{par.lambda, par.mu};
  const Symmetric3<float> first{1e-3F, 0, 0, 2e-4F, 0, 0};
  const float least = 1e-11F;  // of a stress of 1e-3 it is a sixth of the last place
  const int steps = 100000;
  const auto run = [&](const auto& law, auto& history) {
    Symmetric3<float> stress{}, rest{};
    law.update(stress, rest, history, first);
    const float before = stress.xx;
    for (int n = 0; n < steps; ++n) law.update(stress, rest, history, Symmetric3<float>{least, 0, 0, 0, 0, 0});
    return (double{stress.xx} - double{before}) / (steps * double{least} * (par.lambda + 2 * par.mu));
  };
  float nothing[2] = {0, 0};
  EXPECT_NEAR(run(elastic, nothing), 1, 0.02);  // the last place of the stress is 1.5 % of the whole increment
  EXPECT_NEAR(run(par.material, nothing), 1, 0.02);
  EXPECT_EQ(nothing[0], 0);  // it did not yield
}

TEST(ShortMaterial, PlasticStrainsThatAreBelowTheLastPlaceAddUp) {
  const auto par = make_parameters(100e6);
  float history[2] = {0.5F, 0};
  Symmetric3<float> stress{}, rest{};
  const float step = 1e-8F;  // shear strain xy; 0.5 has a last place of 6e-8
  for (int n = 0; n < 400000; ++n) par.material.update(stress, rest, history, Symmetric3<float>{0, 0, 0, step, 0, 0});
  // sqrt(3) s_xy = sigma_y + H p = sqrt(3) 2 mu (e_xy - sqrt(3)/2 dp)
  const double mu = par.mu, yield = 100e6 + 1e9 * 0.5;
  const double expected = (std::sqrt(3.0) * 2 * mu * 400000 * step - yield) / (3 * mu + 1e9);
  EXPECT_NEAR((history[0] - 0.5) / expected, 1, 1e-3);
}

/// The bound of floats is never above that of doubles, however thin the element and however far it lies from the node
/// that positions are counted from.
TYPED_TEST(ShortHex8, StepBoundsStayBelowThoseOfDouble) {
  Random random(33);
  for (int k = 0; k < 300; ++k) {
    const double thin = std::pow(10.0, random());  // 0.1 to 10
    const Corners shape = make_element(random, 1, thin, 1, 0.1);
    Corners far = apply(find_rotation_increment(Vector3<double>{random(), random(), random()}, 2.0), shape);
    Twins<TypeParam::value> twins(far);
    for (int i = 0; i < 8; ++i) far.x[i] += 8, far.y[i] -= 8, far.z[i] += 8;
    twins.x = far;
    twins.advance(make_velocity(random, 10), 1e-7);
    EXPECT_LE(twins.short_result.stable_step, twins.long_result.stable_step);
    EXPECT_GT(twins.short_result.stable_step, (1 - 4 * short_step_margin) * twins.long_result.stable_step);
  }
}

/// Volumes of 3e-14 to 3e4 of steel, near the limits of check_precision.cpp: nothing that the element multiplies leaves
/// floats.
TYPED_TEST(ShortHex8, SmallAndLargeElementsHaveTheStepOfDouble) {
  Random random(36);
  for (const double edge : {3e-5, 1e-3, 1.0, 30.0}) {
    Twins<TypeParam::value> twins(make_element(random, edge, edge, edge, 0.1));
    twins.advance(make_velocity(random, 10), 1e-6 * edge);
    EXPECT_LE(twins.short_result.stable_step, twins.long_result.stable_step);
    EXPECT_GT(twins.short_result.stable_step, (1 - 4 * short_step_margin) * twins.long_result.stable_step);
    const double work = twins.long_result.work.internal;
    EXPECT_NEAR(twins.short_result.work.internal, work, 1e-3 * std::abs(work));
  }
}

/// Forces by mode, turned to corners in double, add up to nothing: momentum is kept as in double.
TYPED_TEST(ShortHex8, ForcesOfAnElementAddUpToNothing) {
  Random random(34);
  Twins<TypeParam::value> twins(make_element(random, 1, 0.8, 1.1, 0.2));
  twins.advance(make_velocity(random, 300), 1e-6);
  for (const auto& force : twins.short_force) {
    double f[8], sum = 0, size = 0;
    for (int m = 0; m < 8; ++m) f[m] = widen<0>(force[m]);
    to_corners(f);
    for (const double value : f) sum += value, size += std::abs(value);
    EXPECT_GT(size, 0);
    EXPECT_LE(std::abs(sum), 1e-15 * size);
  }
}

TYPED_TEST(ShortHex8, CalledMaterialsWorkInDouble) {
  constexpr HexKind kind = TypeParam::value;
  Random random(35);
  const J2Plasticity law = J2Plasticity::make({young, poisson, 100e6, 1e9});
  SolidParameters<CalledMaterial> par;
  par.material = make_called_material(law, density);
  par.lambda = law.lambda;
  par.mu = law.mu;
  Twins<kind> twins(make_element(random, 1, 0.8, 1.2, 0.1));
  auto called = make_state<CalledMaterial, kind>(twins.shorter.mass);
  double history[CalledMaterial::history_count];
  const double center[3] = {0, 0, 0};
  start_history(par.material, history, center);
  float start[2 * CalledMaterial::history_count] = {};
  const int count = par.material.count_history();
  for (int i = 0; i < count; ++i) start[i] = static_cast<float>(history[i]);
  for (int p = 0; p < hex_points<kind>; ++p) called.history.store(p, start, 2 * count);
  auto longer = make_state<CalledMaterial, kind>(twins.longer.mass);
  for (int p = 0; p < hex_points<kind>; ++p) longer.history.store(p, history, count);
  float f[3][8];
  double long_force[3][8];
  for (int n = 0; n < 20; ++n) {
    const Corners v = make_velocity(random, 100);
    twins.advance(v, 2e-6);
    advance_hex8(par, find_short_modes(twins.x), find_short_modes(v), 2e-6F, called, {f[0], f[1], f[2]});
    advance_hex8(par, find_modes(twins.x), find_modes(v), 2e-6, longer, {long_force[0], long_force[1], long_force[2]});
  }
  const auto expected = list_stresses(longer), stresses = list_wide_stresses(called.stress);
  for (std::size_t p = 0; p < expected.size(); ++p) {
    EXPECT_LT(find_size(stresses[p] + (-1.0) * expected[p]), 300 * unit * find_size(expected[p]));
    const auto point = static_cast<int>(p);
    const double strain = longer.history.value[1][point];
    const float* const kept[2] = {&called.history.value[1][point], &called.history.value[1 + count][point]};
    EXPECT_GT(strain, 0);
    EXPECT_NEAR(double{*kept[0]} + double{*kept[1]}, strain, 300 * unit * strain);
  }
}

}  // namespace percuss::test::short_hex8_test
