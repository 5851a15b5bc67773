// The elements as a linear operator against their own forces, which know nothing of it.

#include "kernels/element/elastic_operator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::elastic_operator_test {
namespace {

constexpr double lambda = 3e9, mu = 2e9, density = 1000;

Elastic make_material(const Elastic*) { return {lambda, mu}; }
J2Plasticity make_material(const J2Plasticity*) { return {lambda, mu, 1e30, 0}; }

template <class Material, HexKind Kind>
struct Probed {
  SolidParameters<Material> par{make_material(static_cast<const Material*>(nullptr)), lambda, mu, 0.05, {0, 0}};
  Corners corners;
  double mass;

  Probed(Random& random, double distortion) : corners(make_element(random, 1, 0.6, 1.7, distortion)) {
    mass = density * find_volume_gradient(find_modes(corners)).volume;
  }
  Corners probe(const Corners& u, double step, double pressure = 0) const {
    Corners f{};
    probe_hex8<Kind>(par, find_modes(corners), find_modes(u), ProbedElement<double>{mass, pressure, step},
                     {f.x, f.y, f.z});
    return f;
  }
  /// What the element itself answers, after a step dt at the velocity u from rest.
  Corners advance(const Corners& u, double dt) const {
    auto state = make_state<Material, Kind>(mass, find_modes(corners));
    Corners f{};
    advance_hex8(par, find_modes(corners), find_modes(u), dt, state, {f.x, f.y, f.z});
    return f;
  }
};

Corners make_velocities(Random& random) {
  Corners u{};
  for (int i = 0; i < 8; ++i) u.x[i] = random(), u.y[i] = random(), u.z[i] = random();
  return u;
}

double find_product(const Corners& a, const Corners& b) {
  double sum = 0;
  for (int i = 0; i < 8; ++i) sum += a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
  return sum;
}

Corners combine(const Corners& a, double factor, const Corners& b) {
  Corners c = a;
  for (int i = 0; i < 8; ++i) c.x[i] += factor * b.x[i], c.y[i] += factor * b.y[i], c.z[i] += factor * b.z[i];
  return c;
}

/// |a - b| / |b|.
double find_difference(const Corners& a, const Corners& b) {
  const Corners d = combine(a, -1, b);
  return std::sqrt(find_product(d, d) / find_product(b, b));
}

template <HexKind Kind, class Material>
void compare_with_forces(double distortion) {
  Random random(3);
  for (int n = 0; n < 20; ++n) {
    Probed<Material, Kind> element(random, distortion);
    const Corners u = make_velocities(random);
    // A step without length shows the damping alone, and a trial step so short that stiffness has no part in it.
    element.par.viscosity = {0.06, 0};
    const double instant = 1e-20;
    EXPECT_LT(find_difference(element.probe(u, instant), combine({}, instant / 2, element.advance(u, 0))), 1e-12) << n;
    if (Kind == HexKind::viscous) continue;
    // Without viscosity a step so short that the second order is 1e-8 of the first shows the stiffness.
    element.par.viscosity = {0, 0};
    const double dt = 1e-8, h = 1e-3;
    EXPECT_LT(find_difference(element.probe(u, h), combine({}, h * h / 4 / dt, element.advance(u, dt))), 3e-7) << n;
  }
}

template <HexKind Kind>
void expect_symmetry() {
  Random random(4);
  Probed<J2Plasticity, Kind> element(random, 0.2);
  element.par.viscosity = {0.06, 1.2};
  const Corners a = make_velocities(random), b = make_velocities(random);
  const double h = 1e-3, pressure = 1e7;
  const double left = find_product(a, element.probe(b, h, pressure)), size = find_product(a, element.probe(a, h));
  EXPECT_NEAR(left, find_product(b, element.probe(a, h, pressure)), 1e-13 * size);
}

}  // namespace

TEST(ElasticOperator, IsTheLinearisedElementWithAssumedStrain) {
  compare_with_forces<HexKind::assumed_strain, Elastic>(0.2);
}
TEST(ElasticOperator, IsTheLinearisedElementWithTheGuardOfNearInvertedElements) {
  compare_with_forces<HexKind::assumed_strain, J2Plasticity>(0.3);
}
TEST(ElasticOperator, IsTheLinearisedElementWithStiffness) { compare_with_forces<HexKind::stiffness, Elastic>(0.2); }
TEST(ElasticOperator, IsTheLinearisedElementWithFullIntegration) { compare_with_forces<HexKind::full, Elastic>(0.2); }
TEST(ElasticOperator, IsTheLinearisedElementWithViscousControl) { compare_with_forces<HexKind::viscous, Elastic>(0.2); }

TEST(ElasticOperator, IsSymmetric) {
  expect_symmetry<HexKind::assumed_strain>();
  expect_symmetry<HexKind::stiffness>();
  expect_symmetry<HexKind::viscous>();
  expect_symmetry<HexKind::full>();
}

TEST(ElasticOperator, TheTangentOfTheViscosityFollowsFromItsPressure) {
  const BulkViscosity viscosity{0.06, 1.2};
  for (const double rate : {-3000.0, -20.0, 0.0, 500.0}) {  // compression to expansion
    const auto q = find_viscous_pressure(viscosity, 2700.0, 0.01, 6000.0, rate);
    EXPECT_NEAR(find_viscous_tangent(viscosity, 2700.0, 0.01, 6000.0, q.pressure) / q.tangent, 1, 1e-14) << rate;
  }
}

}  // namespace percuss::test::elastic_operator_test
