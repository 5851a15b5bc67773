#include "kernels/shell/shell4.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::shell4_test {

namespace {

constexpr double young = 200e9, poisson = 0.3, density = 7800;

ElasticLayer make_elastic() { return {find_plane_elasticity(young, poisson)}; }
J2Layer make_plastic(double yield) { return {find_plane_elasticity(young, poisson), yield, 0}; }

double largest_stress(const std::vector<double>& layers) {
  double largest = 0;
  for (const double s : layers) largest = std::max(largest, std::abs(s));
  return largest;
}

}  // namespace

TEST(Shell4, HundredImposedTurnsLeaveNoForce) {
  Random random(11);
  const ShellCorners start = make_quad(random, 1, 1.4, 0.2, 0.3);
  TestShell<ElasticLayer> shell(make_elastic(), 3, start, 0.05, density);
  const Vec axis{0.6, 0.0, 0.8};
  const int steps_per_turn = 200;
  const double angle = 2 * std::numbers::pi / steps_per_turn;
  // Over a step of a finite turn the chords of the corners are those of a rigid spin by 2 tan(angle / 2).
  const Vec spin = (2 * std::tan(angle / 2)) * axis;
  const ShellCorners w{spin, spin, spin, spin};
  ShellCorners x = start;
  for (int step = 1; step <= 100 * steps_per_turn; ++step) {
    ShellCorners next, v;
    for (std::size_t i = 0; i < 4; ++i) {
      next[i] = rotate(axis, angle * step, start[i]);
      v[i] = next[i] - x[i];
    }
    shell.advance(next, v, w, 1);
    x = next;
  }
  EXPECT_LT(largest_stress(shell.layers), 1e-13 * young);  // 5e-15 measured: round-off of 2e4 steps
  EXPECT_LT(largest_norm(shell.force), 1e-13 * young * 0.05);
  EXPECT_NEAR(shell.state.thickness, 0.05, 1e-14);
}

TEST(Shell4, WorkIsThatOfTheForces) {
  Random random(12);
  const ShellCorners start = make_quad(random, 1, 1.2, 0.2, 0.2);
  const ShellCorners v = random_field(random, 1), w = random_field(random, 1);
  for (const double offset : {0.0, 0.05, -0.15}) {  // of the section from the mesh
    double error[2];
    for (int level = 0; level < 2; ++level) {
      const int steps = level == 0 ? 100 : 200;
      const double dt = 1e-3 / steps;
      TestShell<ElasticLayer> shell(make_elastic(), 3, start, 0.1, density);
      shell.par.offset = offset;
      ShellCorners x = start;
      double work = 0, by_forces = 0;
      shell.advance(x, v, w, 0);
      for (int step = 0; step < steps; ++step) {
        by_forces += 0.5 * dt * find_power(shell.force, shell.moment, v, w);
        x = move(x, v, dt);
        const auto result = shell.advance(x, v, w, dt);
        work += result.work.internal + result.work.hourglass;
        by_forces += 0.5 * dt * find_power(shell.force, shell.moment, v, w);
      }
      error[level] = std::abs(work / by_forces - 1);
    }
    EXPECT_LT(error[1], 1e-6);
    EXPECT_NEAR(error[0] / error[1], 4, 0.5);  // second order in the step
  }
}

TEST(Shell4, ItsShareScalesTheForcesAgainstHourglassModesAndDrilling) {
  // A square of edge a: bending in its plane stores E t (4 / 3) X^2 / 2 at u_x = X h, h = 1, -1, 1, -1.
  Random random(15);
  const double a = 0.1, t = 0.002, size = 1e-9;
  for (const double share : {1.0, 0.02}) {
    const ShellCorners x = make_quad(random, a, a, 0, 0);
    TestShell<ElasticLayer> shell(make_elastic(), 3, x, t, density);
    shell.par.stabilization = share;
    ShellCorners v, turning;
    for (std::size_t i = 0; i < 4; ++i) {
      v[i] = {i % 2 == 0 ? size : -size, 0, 0};
      turning[i] = {0, 0, size};
    }
    shell.advance(move(x, v, 1.0), v, {}, 1);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(shell.force[i].x, share * young * t * v[i].x / 3, 1e-6 * share * young * t * size);
    TestShell<ElasticLayer> turned(make_elastic(), 3, x, t, density);
    turned.par.stabilization = share;
    turned.advance(x, {}, turning, 1);
    const double shear = young / (2 * (1 + poisson));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(turned.moment[i].z, share * shell_drilling * shear * t * a * a * size / 4,
                  1e-9 * shear * t * a * a * size);
  }
}

TEST(Shell4, FullyPlasticMomentIsThatOfTheRule) {
  // Bending far beyond yield: every layer at the yield stress in plane strain, as the sides do not bend.
  const double yield = 300e6, t = 0.1;
  for (const auto& [points, share] : {std::pair{3, 0.8607}, std::pair{5, 0.9448}}) {
    Random random(13);
    const ShellCorners x = make_quad(random, 1, 1, 0, 0);
    TestShell<J2Layer> shell(make_plastic(yield), points, x, t, density);
    ShellCorners w{};
    for (std::size_t i = 0; i < 4; ++i) w[i] = {0, x[i].x > 0 ? 1.0 : -1.0, 0};
    for (int step = 0; step < 100; ++step) shell.advance(x, {}, w, 0.01);
    // Moment about y of one side, of length 1; plane strain raises the yield stress by 2 / sqrt(3).
    const double moment = shell.moment[1].y + shell.moment[2].y;
    EXPECT_NEAR(moment / (yield * 2 / std::sqrt(3.0) * t * t / 4), share, 1e-3) << points << " points";
  }
}

TEST(Shell4, PlasticStretchKeepsTheVolume) {
  Random random(14);
  ShellCorners x = make_quad(random, 1, 1, 0.1, 0);
  TestShell<J2Layer> shell(make_plastic(1e6), 3, x, 0.01, density);
  const double before = find_shell_geometry(find_differences(x)).area * shell.state.thickness;
  for (int step = 0; step < 2000; ++step) {
    ShellCorners v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = {x[i].x, -0.2 * x[i].y, 0};
    ShellCorners next;
    // the chord of exponential growth, so that the rate at mid-step is the logarithmic one
    const double dt = 2e-4;
    for (std::size_t i = 0; i < 4; ++i) {
      next[i] = {x[i].x * (1 + dt / 2) / (1 - dt / 2), x[i].y * (1 - 0.1 * dt) / (1 + 0.1 * dt), 0};
      v[i] = (1 / dt) * (next[i] - x[i]);
    }
    shell.advance(next, v, {}, dt);
    x = next;
  }
  const double after = find_shell_geometry(find_differences(x)).area * shell.state.thickness;
  // Elastic volume strain is of the order of yield stress over Young's modulus, 1e-5; the rates of trial and return
  // differ from the logarithmic ones by the square of the step.
  EXPECT_NEAR(after / before, 1, 1e-5);
}

TEST(Shell4, FoldedElementSaysSoAndGoesOn) {
  const ShellCorners square{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}};
  const ShellCorners dart{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{0.2, 0.2, 0}, Vec{0, 1, 0}};  // concave at the third corner
  TestShell<ElasticLayer> shell(make_elastic(), 3, square, 0.01, density);
  const auto whole = shell.advance(square, {}, {}, 0);
  EXPECT_EQ(whole.least_cosine, 1);
  const auto folded = shell.advance(dart, {}, {}, 0);
  EXPECT_LT(folded.least_cosine, 0);
  EXPECT_DOUBLE_EQ(folded.size, 0.2);
  EXPECT_GT(folded.stable_step, 0.05 * whole.stable_step);
}

TEST(Shell4, DrillingHasItsStiffnessAndItsWorkIsBookedWithThatOfHourglassModes) {
  const ShellCorners x{Vec{0, 0, 0}, Vec{2, 0, 0}, Vec{2, 1, 0}, Vec{0, 1, 0}};
  const double thickness = 0.1, rate = 3, dt = 1e-5, shear_modulus = young / (2 * (1 + poisson));
  TestShell<ElasticLayer> shell(make_elastic(), 3, x, thickness, density);
  const Vec w{0, 0, rate};
  const auto result = shell.advance(x, {}, {w, w, w, w}, dt);
  const double moment = 0.1 * shear_modulus * thickness * 2 * rate * dt;
  EXPECT_NEAR(result.work.hourglass / (0.5 * moment * rate * dt), 1, 1e-14);
  EXPECT_EQ(result.work.internal, 0);
  Vec force_moment{0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(shell.moment[i].z / (moment / 4), 1, 1e-14);
    force_moment = force_moment + cross(x[i], shell.force[i]);
  }
  EXPECT_NEAR(force_moment.z / -moment, 1, 1e-14);
}

TEST(Shell4, PlasticFlowLeavesOfDrillingWhatItLeavesOfTheMembrane) {
  const ShellCorners x{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}};
  const double yield = 1e6, dt = 1e-3;
  TestShell<J2Layer> shell(make_plastic(yield), 3, x, 0.01, density);
  const Vec turn{0, 0, 1e-3};
  shell.advance(x, {}, {turn, turn, turn, turn}, dt);
  const double before = shell.state.drilling;
  EXPECT_GT(before, 0);
  ShellCorners v;  // uniform shear: the trial stress is 2 G v, ten times what flows
  const double shear = young / (2 * (1 + poisson)), rate = 10 * yield / std::sqrt(3.0) / (2 * shear * dt);
  for (std::size_t i = 0; i < 4; ++i) v[i] = {rate * x[i].y, rate * x[i].x, 0};
  const ShellCorners sheared = move(x, v, dt);
  shell.advance(sheared, v, {}, dt);
  EXPECT_NEAR(shell.state.drilling / before, 0.1, 1e-6);

  // The stiffness is now that of the secant: 9 of the 10 parts of the strain are plastic, p = 9 yield / 3 G.
  const double left = shell.state.drilling, p = 9 * yield / (3 * shear);
  shell.advance(sheared, {}, {turn, turn, turn, turn}, dt);
  EXPECT_NEAR((shell.state.drilling - left) / before, yield / (yield + young * p), 1e-4);
}

}  // namespace percuss::test::shell4_test
