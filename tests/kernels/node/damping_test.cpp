#include "kernels/node/damping.hpp"

#include <gtest/gtest.h>

namespace percuss::test {

// One step of the formula in the header, a held direction, a node that nothing damps.
TEST(Damping, IsTheImpulseOfTheMeanVelocity) {
  constexpr double c = 40, dt = 0.01, h = 0.5 * c * dt, mass = 3, before = 2, gain = 0.7;
  const DampedNodes nodes{Array<int>("entry", 2)};
  nodes.entry(0) = 1;
  nodes.entry(1) = -1;
  const Array<double> coefficients("c", 2), masses("m", 2);
  coefficients(0) = 1000;
  coefficients(1) = c;
  const Rows3<double> v_before("before", 2), v("v", 2), inverse("inverse", 2), impulse("impulse", 2);
  for (int n = 0; n < 2; ++n) {
    masses(n) = mass;
    for (int k = 0; k < 3; ++k) {
      v_before(n, k) = before;
      v(n, k) = before + gain;
      inverse(n, k) = k == 2 ? 0 : 1 / mass;
    }
  }
  damp_velocities(ExecSpace(), nodes, {coefficients, dt}, {v_before, inverse, masses, v, impulse});
  const double damped = ((1 - h) * before + gain) / (1 + h);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(v(0, k), damped, 1e-15);
    EXPECT_NEAR(impulse(0, k), mass * (damped - before - gain), 1e-14);
    EXPECT_NEAR(impulse(0, k), -c * mass * dt * 0.5 * (before + damped), 1e-14);
  }
  EXPECT_EQ(v(0, 2), before + gain);
  EXPECT_EQ(impulse(0, 2), 0);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(v(1, k), before + gain);
    EXPECT_EQ(impulse(1, k), 0);
  }
}

// However large c is, the velocity goes to zero or turns, and never grows.
TEST(Damping, NeverAddsEnergy) {
  for (const double both : {1e-8, 0.1, 2.0, 50.0, 1e12}) {
    const double kept = 1 - find_damped_share(both, 1, DampedVelocity::mean);
    EXPECT_LE(kept, 1);
    EXPECT_GE(kept, -1);
  }
}

// A spring without mass of its own, in steps of 0.9 of its largest one: from rest its force is whole, and it ends at
// the deflection of its load, whatever c is.
TEST(Damping, OfTheOldVelocityLeavesForcesWhole) {
  constexpr double mass = 2, stiffness = 8, load = 3, dt = 0.9 * 2 / 2;  // frequency 2
  const DampedNodes nodes{Array<int>("entry", 1)};
  const Array<double> coefficients("c", 1), masses("m", 1);
  masses(0) = mass;
  const Rows3<double> before("before", 1), v("v", 1), inverse("inverse", 1), impulse("impulse", 1);
  for (int k = 0; k < 3; ++k) inverse(0, k) = 1 / mass;
  for (const double c : {0.2, 1e9}) {
    coefficients(0) = c;
    double x = 0;
    v(0, 0) = 0;
    for (int step = 0; step < 500; ++step) {
      before(0, 0) = v(0, 0);
      v(0, 0) += dt * load / mass;  // the spring comes after the damping, as contact does
      damp_velocities(ExecSpace(), nodes, {coefficients, dt, DampedVelocity::old},
                      {before, inverse, masses, v, impulse});
      if (step == 0) {
        EXPECT_EQ(v(0, 0), dt * load / mass);
      }
      v(0, 0) -= dt * stiffness * x / mass;
      x += dt * v(0, 0);
    }
    EXPECT_NEAR(x, load / stiffness, 1e-12);
  }
}

}  // namespace percuss::test
