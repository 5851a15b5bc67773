// An element that calls its material against one that the same material is compiled into, kind by kind.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/element/element_chunks.hpp"
#include "kernels/material/laws/call_material.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::called_element_test {
namespace {

constexpr double density = 7800, young = 200e9, poisson = 0.3;

template <class Material>
SolidParameters<Material> make_parameters(const Material& material) {
  const LameConstants c = find_lame_constants(young, poisson);
  SolidParameters<Material> par;
  par.material = material;
  par.lambda = c.lambda;
  par.mu = c.mu;
  return par;
}

template <HexKind Kind>
HexState<double, CalledMaterial, Kind> make_called_state(const CalledMaterial& material, double mass) {
  auto state = make_state<CalledMaterial, Kind>(mass);
  double history[CalledMaterial::history_count];
  const double center[3] = {0, 0, 0};
  start_history(material, history, center);
  for (int p = 0; p < hex_points<Kind>; ++p) state.history.store(p, history, material.count_history());
  return state;
}

template <class Kind>
class CalledElement : public testing::Test {};
using Kinds = testing::Types<KindOf<HexKind::assumed_strain>, KindOf<HexKind::stiffness>, KindOf<HexKind::viscous>,
                             KindOf<HexKind::full>>;
TYPED_TEST_SUITE(CalledElement, Kinds);

}  // namespace

TYPED_TEST(CalledElement, GivesTheForcesAndTheStepOfACompiledInMaterial) {
  constexpr HexKind kind = TypeParam::value;
  Random random(7);
  // Under assumed strain the compiled-in law yields as a section (plastic_bending.hpp), which called ones do not.
  constexpr bool yields = kind != HexKind::assumed_strain;
  const J2Plasticity law = J2Plasticity::make({young, poisson, yields ? 200e6 : 1e12, 2e9});
  const auto compiled = make_parameters(law);
  const auto called = make_parameters(make_called_material(law, density));
  Corners x = make_element(random, 1, 0.8, 1.2, 0.1);
  const double mass = density * find_volume_gradient(find_modes(x)).volume;
  auto one = make_state<J2Plasticity, kind>(mass);
  auto other = make_called_state<kind>(called.material, mass);
  const double dt = 1e-5;
  for (int n = 0; n < 30; ++n) {
    Corners v{};
    for (int i = 0; i < 8; ++i) {
      v.x[i] = 30 * random(), v.y[i] = 30 * random(), v.z[i] = 30 * random();
      x.x[i] += dt * v.x[i], x.y[i] += dt * v.y[i], x.z[i] += dt * v.z[i];
    }
    double f[3][8], g[3][8];
    const auto expected = advance_hex8(compiled, find_modes(x), find_modes(v), dt, one, {f[0], f[1], f[2]});
    const auto result = advance_hex8(called, find_modes(x), find_modes(v), dt, other, {g[0], g[1], g[2]});
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 8; ++i) EXPECT_NEAR(g[k][i], f[k][i], 1e-12 * 200e6);
    }
    EXPECT_NEAR(result.stable_step, expected.stable_step, 1e-12 * expected.stable_step);
    EXPECT_NEAR(result.work.internal, expected.work.internal, 1e-12 * 200e6);
  }
  EXPECT_EQ(one.history.value[0][0] > 1e-4, yields);
  EXPECT_EQ(one.history.value[0][0], other.history.value[1][0]);
}

TYPED_TEST(CalledElement, GasHoldsItsPressureOnEveryFace) {
  constexpr HexKind kind = TypeParam::value;
  const CalledMaterial gas = make_called_material(Fluid{}, density, IdealGasState{1.4, 2.5e5});
  const auto par = make_parameters(gas);
  Random random(9);
  const Corners x = make_element(random, 1, 1, 1, 0.1);
  const VolumeGradient<double> b = find_volume_gradient(find_modes(x));
  auto state = make_called_state<kind>(gas, density * b.volume);
  double f[3][8];
  advance_hex8(par, find_modes(x), find_modes(Corners{}), 0.0, state, {f[0], f[1], f[2]});
  // f = -p dV/dx: with x itself, -3 p V
  double virial = 0;
  for (int i = 0; i < 8; ++i) virial += f[0][i] * x.x[i] + f[1][i] * x.y[i] + f[2][i] * x.z[i];
  EXPECT_NEAR(virial, -3 * 1e5 * b.volume, 1e-9 * 1e5);
}

}  // namespace percuss::test::called_element_test
