#include <gtest/gtest.h>

#include <cstring>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::shell_rates_test {

namespace {

constexpr int rate_count = sizeof(ShellRates<double>) / sizeof(double);

std::array<double, rate_count> list_rates(const ShellRates<double>& rates) {
  std::array<double, rate_count> list;
  std::memcpy(list.data(), &rates, sizeof rates);
  return list;
}

ShellRates<double> find_rates(const ShellCorners& x, const ShellCorners& v, const ShellCorners& w) {
  const auto g = find_shell_geometry(find_differences(x));
  const Vec turned[4] = {g.frame * w[0], g.frame * w[1], g.frame * w[2], g.frame * w[3]};
  return find_shell_rates(g, turn(g.frame, find_differences(v)), turned);
}

struct Forces {
  ShellCorners force, moment;
};

Forces find_forces(const ShellCorners& x, const ShellRates<double>& on) {
  Vec f[4], m[4];
  find_shell_forces(find_shell_geometry(find_differences(x)), on, f, m);
  return {{f[0], f[1], f[2], f[3]}, {m[0], m[1], m[2], m[3]}};
}

ShellRates<double> random_forces(Random& random) {
  ShellRates<double> on;
  std::array<double, rate_count> list;
  for (double& value : list) value = random();
  std::memcpy(&on, list.data(), sizeof on);
  return on;
}

}  // namespace

TEST(ShellGeometry, CornersLieAtAlternatingHeightsAndFrameIsOrthonormal) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const ShellCorners x = make_quad(random, 1, 1.7, 0.2, 0.3);
    const auto g = find_shell_geometry(find_differences(x));
    Vec center = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec local = g.frame * (x[i] - center);
      EXPECT_NEAR(local.x, g.x[i], 1e-14);
      EXPECT_NEAR(local.y, g.y[i], 1e-14);
      EXPECT_NEAR(local.z, find_warp_sign(static_cast<int>(i)) * g.z, 1e-14);
      const Vec normal = g.frame * cross(x[(i + 1) % 4] - x[i], x[(i + 3) % 4] - x[i]);
      EXPECT_NEAR(norm(1 / norm(normal) * normal - Vec{g.px[i], g.py[i], g.pz[i]}), 0, 1e-13);
    }
    const auto product = symmetric_product(g.frame, g.frame);
    EXPECT_NEAR(product.xx + product.yy + product.zz, 3, 1e-14);
    EXPECT_NEAR(norm(Vec{product.xy, product.yz, product.zx}), 0, 1e-14);
    EXPECT_NEAR(determinant(g.frame), 1, 1e-14);
  }
}

TEST(ShellGeometry, FirstCornerChangesTheFrameByAQuarterTurnOnly) {
  Random random(2);
  const ShellCorners x = make_quad(random, 1, 1.3, 0.2, 0.2);
  const auto g = find_shell_geometry(find_differences(x));
  const auto next = find_shell_geometry(find_differences(ShellCorners{x[1], x[2], x[3], x[0]}));
  EXPECT_NEAR(norm(next.frame.row[0] - g.frame.row[1]), 0, 1e-14);
  EXPECT_NEAR(norm(next.frame.row[1] + g.frame.row[0]), 0, 1e-14);
  EXPECT_NEAR(next.z, -g.z, 1e-14);
}

TEST(ShellRates, RigidMotionGivesNone) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const ShellCorners x = make_quad(random, 1, 2, 0.2, 0.4);
    const Vec velocity = random_vector(random, 1), spin = random_vector(random, 1);
    ShellCorners v, w{spin, spin, spin, spin};
    for (std::size_t i = 0; i < 4; ++i) v[i] = velocity + cross(spin, x[i]);
    for (const double rate : list_rates(find_rates(x, v, w))) EXPECT_NEAR(rate, 0, 1e-14);
  }
}

TEST(ShellGeometry, DirectorOfACornerThatFoldsOverStaysUpright) {
  const double height = 0.1;
  const ShellCorners dart{Vec{0, 0, height}, Vec{1, 0, 0}, Vec{0.3, 0.3, height},
                          Vec{0, 1, 0}};  // concave at the third
  const auto g = find_shell_geometry(find_differences(dart));
  EXPECT_LT(g.least_cosine, 0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_GT(g.pz[i], 0);
    EXPECT_NEAR(norm(Vec{g.px[i], g.py[i], g.pz[i]}), 1, 1e-15);
  }
  const ShellCorners flat{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{0.3, 0.3, 0}, Vec{0, 1, 0}};
  EXPECT_EQ(find_shell_geometry(find_differences(flat)).pz[2], 1);
}

TEST(ShellRates, TurningAboutTheCornerNormalsDrillsAndNothingElse) {
  Random random(4);
  const ShellCorners x = make_quad(random, 1, 1, 0.2, 0.3);
  ShellCorners w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = random() * cross(x[(i + 1) % 4] - x[i], x[(i + 3) % 4] - x[i]);
  auto rates = find_rates(x, ShellCorners{}, w);
  const Vec normal = find_shell_geometry(find_differences(x)).frame.row[2];
  EXPECT_NEAR(rates.drilling, dot(normal, 0.25 * (w[0] + w[1] + w[2] + w[3])), 1e-14);
  rates.drilling = 0;
  for (const double rate : list_rates(rates)) EXPECT_NEAR(rate, 0, 1e-14);
}

TEST(ShellRates, DrillingIsWhatCornersTurnAgainstTheSpinOfTheElement) {
  Random random(9);
  const ShellCorners x = make_quad(random, 1, 1.5, 0.3, 0);
  const double a = 0.7, b = -0.3, turn = 0.4;  // vx = -b y, vy = a x: the spin is (a + b) / 2
  ShellCorners v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = {-b * x[i].y, a * x[i].x, 0};
  const Vec w{0, 0, turn};
  EXPECT_NEAR(find_rates(x, v, {w, w, w, w}).drilling, turn - (a + b) / 2, 1e-14);
}

TEST(ShellRates, UniformMembraneStrainOfAFlatElementIsExact) {
  Random random(5);
  const ShellCorners x = make_quad(random, 1, 1, 0.25, 0);
  const double exx = 0.3, eyy = -0.2, gxy = 0.5;
  ShellCorners v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = {exx * x[i].x + gxy * x[i].y, eyy * x[i].y, 0};
  const auto rates = find_rates(x, v, {});
  const auto g = find_shell_geometry(find_differences(x));
  const double c = g.frame.row[0].x, s = g.frame.row[0].y;  // to the axes of the frame
  EXPECT_NEAR(rates.membrane[0], c * c * exx + s * s * eyy + c * s * gxy, 1e-14);
  EXPECT_NEAR(rates.membrane[1], s * s * exx + c * c * eyy - c * s * gxy, 1e-14);
  EXPECT_NEAR(rates.membrane[2], 2 * c * s * (eyy - exx) + (c * c - s * s) * gxy, 1e-14);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(rates.membrane_hourglass[k], 0, 1e-14);
}

TEST(ShellRates, BendingToAParaboloidIsExactOnAFlatElementAndShearsNothing) {
  Random random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const ShellCorners x = make_quad(random, 1, 1, 0.25, 0);
    const double kxx = 0.3, kyy = -0.7, kxy = 0.4;  // w = (kxx x^2 + kyy y^2) / 2 + kxy x y
    ShellCorners v, w;
    for (std::size_t i = 0; i < 4; ++i) {
      const double px = x[i].x, py = x[i].y;
      v[i] = {0, 0, (kxx * px * px + kyy * py * py) / 2 + kxy * px * py};
      w[i] = {kxy * px + kyy * py, -(kxx * px + kxy * py), 0};  // normals stay normals
    }
    const auto rates = find_rates(x, v, w);
    EXPECT_NEAR(rates.curvature[0] + rates.curvature[1], -(kxx + kyy), 1e-13);
    const double half = (rates.curvature[0] - rates.curvature[1]) / 2;
    EXPECT_NEAR(std::hypot(half, rates.curvature[2] / 2), std::hypot((kxx - kyy) / 2, kxy), 1e-13);
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(rates.shear[k], 0, 1e-14);
      EXPECT_NEAR(rates.shear_hourglass[k], 0, 1e-14);
      EXPECT_NEAR(rates.bending_hourglass[k], 0, 1e-14);
    }
  }
}

TEST(ShellForces, AreTheTransposeOfTheRates) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const ShellCorners x = make_quad(random, 1, 2, 0.2, 0.4);
    const ShellCorners v = random_field(random, 1), w = random_field(random, 1);
    const auto on = random_forces(random);
    const Forces f = find_forces(x, on);
    const auto rates = list_rates(find_rates(x, v, w)), forces = list_rates(on);
    double power = 0, size = 0;
    for (std::size_t k = 0; k < rates.size(); ++k) {
      power += rates[k] * forces[k];
      size += std::abs(rates[k] * forces[k]);
    }
    EXPECT_NEAR(find_power(f.force, f.moment, v, w), power, 1e-13 * size);
  }
}

TEST(ShellForces, ForcesAndMomentsOnWarpedElementsAddUpToZero) {
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const ShellCorners x = make_quad(random, 1, 2, 0.2, 0.6);
    const Forces f = find_forces(x, random_forces(random));
    Vec force{0, 0, 0}, moment{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      force = force + f.force[i];
      moment = moment + f.moment[i] + cross(x[i], f.force[i]);
    }
    const double size = largest_norm(f.force) + largest_norm(f.moment);
    EXPECT_NEAR(norm(force), 0, 1e-14 * size);
    EXPECT_NEAR(norm(moment), 0, 1e-13 * size);
  }
}

}  // namespace percuss::test::shell_rates_test
