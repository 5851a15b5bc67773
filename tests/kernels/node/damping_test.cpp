#include "kernels/node/damping.hpp"

#include <gtest/gtest.h>

namespace percuss::test::damping_test {

// One step of the formula in the header, a held direction, a node that nothing damps.
TEST(Damping, IsTheImpulseOfTheMeanVelocity) {
  constexpr double c = 40, dt = 0.01, h = 0.5 * c * dt, mass = 3, before = 2, gain = 0.7;
  const DampedNodes nodes{Array<int>("entry", 2)};
  nodes.entry(0) = 1;
  nodes.entry(1) = -1;
  const Array<double> coefficients("c", 2), masses("m", 2);
  coefficients(0) = 1000;
  coefficients(1) = c;
  const Rows3<double> v_before("before", 2), v("v", 2), inverse("inverse", 2), damped_inverse("damped", 2),
      impulse("impulse", 2);
  const Array<double> growth("growth", 2);
  for (int n = 0; n < 2; ++n) {
    masses(n) = mass;
    for (int k = 0; k < 3; ++k) {
      v_before(n, k) = before;
      v(n, k) = before + gain;
      inverse(n, k) = k == 2 ? 0 : 1 / mass;
    }
  }
  const DampedMotion motion{v_before, masses, inverse, v, damped_inverse};
  damp_velocities(ExecSpace(), nodes, {coefficients, dt}, motion, growth);
  find_damping_impulses(ExecSpace(), nodes, {coefficients, dt}, motion, impulse);
  const double damped = ((1 - h) * before + gain) / (1 + h);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(v(0, k), damped, 1e-15);
    EXPECT_NEAR(impulse(0, k), mass * (damped - before - gain), 1e-14);
    EXPECT_NEAR(impulse(0, k), -c * mass * dt * 0.5 * (before + damped), 1e-14);
  }
  EXPECT_EQ(v(0, 2), before + gain);
  EXPECT_EQ(impulse(0, 2), 0);
  EXPECT_EQ(growth(0), 1 + h);
  EXPECT_EQ(growth(1), 1);
  EXPECT_DOUBLE_EQ(damped_inverse(0, 0), 1 / (mass * (1 + h)));
  EXPECT_EQ(damped_inverse(0, 2), 0);
  EXPECT_EQ(damped_inverse(1, 0), inverse(1, 0));
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(v(1, k), before + gain);
    EXPECT_EQ(impulse(1, k), 0);
  }
}

// However large c is, the velocity goes to zero or turns, and never grows.
TEST(Damping, NeverAddsEnergy) {
  for (const double h : {1e-8, 0.1, 2.0, 50.0, 1e12}) {
    const double kept = 1 - find_damped_share(h);
    EXPECT_LE(kept, 1);
    EXPECT_GE(kept, -1);
  }
}

// A spring that pushes after the damping, as contact does, in steps of 0.9 of its largest one: its work and that of the
// damping are the change of kinetic energy, and it ends at the deflection of its load, whatever c is.
TEST(Damping, LeavesALaterImpulseWhole) {
  constexpr double mass = 2, stiffness = 8, load = 3, dt = 0.9 * 2 / 2;  // frequency 2
  const DampedNodes nodes{Array<int>("entry", 1)};
  const Array<double> coefficients("c", 1), masses("m", 1), growth("growth", 1);
  masses(0) = mass;
  const Rows3<double> before("before", 1), v("v", 1), inverse("inverse", 1), damped_inverse("damped", 1),
      impulse("impulse", 1);
  for (int k = 0; k < 3; ++k) inverse(0, k) = 1 / mass;
  const DampedMotion motion{before, masses, inverse, v, damped_inverse};
  for (const double c : {0.2, 4.0, 40.0}) {
    coefficients(0) = c;
    double x = 0;
    v(0, 0) = 0;
    for (int step = 0; step < 2000; ++step) {
      before(0, 0) = v(0, 0);
      v(0, 0) += dt * load / mass;
      damp_velocities(ExecSpace(), nodes, {coefficients, dt}, motion, growth);
      const double push = -dt * stiffness * x;
      v(0, 0) += push * damped_inverse(0, 0);
      find_damping_impulses(ExecSpace(), nodes, {coefficients, dt}, motion, impulse);
      ASSERT_NEAR(mass * (v(0, 0) - before(0, 0)), dt * load + push + impulse(0, 0), 1e-14 * dt * load);
      x += dt * v(0, 0);
    }
    EXPECT_NEAR(x, load / stiffness, 1e-12);
  }
}

}  // namespace percuss::test::damping_test
