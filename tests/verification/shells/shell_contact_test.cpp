// Plates of shells that meet flat on one another, against the exact impact of rigid bodies.
//
// A shell has one row of nodes across its thickness and no waves there. Contact by constraint is then the inelastic
// impact of two masses, contact by springs the elastic one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::shell_contact_test {
namespace {

/// Plate a at 10 m/s on plate b at rest, b of `ratio` times its mass by its thickness; unlike meshes. The steps, 0.72
/// of the bound, are short against the contact.
Outcome collide_plates(const std::string& enforcement, double ratio, const char* cells, const char* end) {
  return run_deck(fmt::format(R"(
title: two plates, {0}
time: {{end: {4}, step_scale: 0.72}}
parts:
  a: {{shell_plate: {{size: [0.1, 0.1], cells: [6, 6]}}, thickness: 0.002, at: [0, 0, {1:.17g}], material: steel}}
  b: {{shell_plate: {{size: [0.1, 0.1], cells: {2}}}, thickness: {3:.17g}, material: steel}}
materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}}}
initial: [{{part: a, velocity: [0, 0, -10]}}]
contact: {{surfaces: all, enforcement: {0}}}
output: {{history: {{every: 1e-6, parts: all, nodes: [{{name: a, near: [0.05, 0.05, 0.01]}}, {{name: b, near: [0.05, 0.05, -0.01]}}]}}}}
)",
                              enforcement, 0.001 + 0.5 * 0.002 * ratio + 1e-4, cells, 0.002 * ratio, end));
}

}  // namespace

TEST(FlatPlates, KeepTheirCommonVelocityUnderAConstraint) {
  for (const double ratio : {1.0, 2.0}) {
    // Right after the impact at 1e-5: later the rows leave each other and ring at 1e-3 of the velocity.
    const Outcome run = collide_plates("kinematic", ratio, "[6, 6]", "1.3e-5");
    const double common = -10 / (1 + ratio), lost = ratio / (1 + ratio);
    EXPECT_NEAR(run.history.last("a_vz"), common, 1e-6 * 10);
    EXPECT_NEAR(run.history.last("b_vz"), common, 1e-6 * 10);
    EXPECT_NEAR(run.summary.energy.contact / run.summary.energy.initial, -lost, 1e-6);
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  }
}

TEST(FlatPlates, BounceAsRigidBodiesDoOnSprings) {
  for (const double ratio : {1.0, 2.0}) {
    const Outcome run = collide_plates("penalty", ratio, "[6, 6]", "2e-4");
    const double first = -10 * (1 - ratio) / (1 + ratio), second = -20 / (1 + ratio);
    const double mass = 8000 * 0.002 * 0.01;
    EXPECT_NEAR(run.history.last("momentum_z:a") / mass, first, 1e-3 * 10);
    EXPECT_NEAR(run.history.last("momentum_z:b") / (ratio * mass), second, 1e-3 * 10);
    fmt::print("ratio {}: {:.5f} and {:.5f} m/s, of springs without loss {:.5f} and {:.5f}\n", ratio,
               run.history.last("momentum_z:a") / mass, run.history.last("momentum_z:b") / (ratio * mass), first,
               second);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  }
}

}  // namespace percuss::test::shell_contact_test
