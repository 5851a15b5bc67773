// Patch tests: five distorted elements (MacNeal and Harder 1985) under a state of uniform strain or curvature. All
// nodes are moved as the exact solution says; then nothing may be left at the inner nodes.

#include <gtest/gtest.h>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test {

namespace {

constexpr double thickness = 0.001;
const Vec patch_nodes[8] = {{0, 0, 0},       {0.24, 0, 0},    {0.24, 0.12, 0}, {0, 0.12, 0},
                            {0.04, 0.02, 0}, {0.18, 0.03, 0}, {0.16, 0.08, 0}, {0.08, 0.08, 0}};
constexpr std::size_t patch_elements[5][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};

/// A linear motion of the patch: velocity and angular velocity of a point.
struct Field {
  Vec velocity, rotation;
};

struct Residual {
  double left = 0, size = 0;  // at inner nodes: what is left, and the largest share of an element
};

/// Residual of moving the patch for `dt` at the rates of the field: forces, or moments.
template <class FindField>
std::pair<Residual, Residual> load_patch(const FindField& find_field, double dt) {
  Vec force[8] = {}, moment[8] = {};
  std::pair<Residual, Residual> residual;
  for (const auto& element : patch_elements) {
    ShellCorners x, v, w;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = patch_nodes[element[i]];
      const Field field = find_field(x[i]);
      v[i] = field.velocity;
      w[i] = field.rotation;
    }
    TestShell<ElasticLayer> shell({find_plane_elasticity(1e6, 0.25)}, 2, x, thickness, 1);
    shell.advance(move(x, v, dt), v, w, dt);
    for (std::size_t i = 0; i < 4; ++i) {
      force[element[i]] = force[element[i]] + shell.force[i];
      moment[element[i]] = moment[element[i]] + shell.moment[i];
      residual.first.size = std::max(residual.first.size, norm(shell.force[i]));
      residual.second.size = std::max(residual.second.size, norm(shell.moment[i]));
    }
  }
  for (int n = 4; n < 8; ++n) {
    residual.first.left = std::max(residual.first.left, norm(force[n]));
    residual.second.left = std::max(residual.second.left, norm(moment[n]));
  }
  return residual;
}

/// Bending: w = (kxx x^2 + kyy y^2) / 2 + kxy x y, normals stay normals.
Field bend(const Vec& x, double kxx, double kyy, double kxy) {
  return {{0, 0, (kxx * x.x * x.x + kyy * x.y * x.y) / 2 + kxy * x.x * x.y},
          {kxy * x.x + kyy * x.y, -(kxx * x.x + kxy * x.y), 0}};
}

}  // namespace

// The motion is so small that the patch keeps its shape: what is left is round-off.
constexpr double small_step = 1e-16;

TEST(ShellPatch, MembraneIsExact) {
  const auto [force, moment] = load_patch(
      [](const Vec& x) {
        return Field{{1e-3 * (x.x + x.y / 2), 1e-3 * (x.y + x.x / 2), 0}, {0, 0, 0}};
      },
      small_step);
  EXPECT_GT(force.size, 0);
  EXPECT_LT(force.left, 1e-12 * force.size);
  EXPECT_LT(moment.left, 1e-12 * force.size * thickness);
}

TEST(ShellPatch, BendingAndTwistAreExactForSmallRotations) {
  for (const auto& k :
       {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, 0.0, 1.0}, std::array{1.0, 1.0, 0.5}}) {
    const auto [force, moment] = load_patch([&](const Vec& x) { return bend(x, k[0], k[1], k[2]); }, small_step);
    EXPECT_GT(moment.size, 0);
    // The round-off is that of transverse shear, stiffer by the square of length over thickness, 1e4.
    EXPECT_LT(moment.left, 1e-10 * moment.size);
    EXPECT_LT(force.left, 1e-9 * moment.size / 0.12);
  }
}

TEST(ShellPatch, FiniteBendingLeavesWhatTheWarpOfTheElementsMakes) {
  // A deflection of `share` of the thickness over the patch warps and stretches the elements: what that adds to the
  // moments grows with the square of the deflection over the thickness.
  double left[2];
  for (int level = 0; level < 2; ++level) {
    const double share = level == 0 ? 0.1 : 0.05;
    const auto [force, moment] =
        load_patch([](const Vec& x) { return bend(x, 1, 1, 0.5); }, share * thickness / (0.24 * 0.24));
    left[level] = moment.left / moment.size;
  }
  EXPECT_LT(left[0], 1e-2);
  EXPECT_NEAR(left[0] / left[1], 4, 0.2);
}

TEST(ShellPatch, TransverseShearIsUniform) {
  // w = gamma x without rotation: the shear of the exact solution in every element, at right angles too.
  const double gamma = 1e-3, shear = 1e6 / 2.5;
  Random random(1);
  const ShellCorners x = make_quad(random, 1, 1, 0, 0);
  ShellCorners v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = {0, 0, gamma * x[i].x};
  ShellCorners w;
  for (Vec& spin : w) spin = {0, 0, 0};
  TestShell<ElasticLayer> shell({find_plane_elasticity(1e6, 0.25)}, 2, x, thickness, 1);
  shell.advance(move(x, v, small_step), v, w, small_step);
  const double exact = 5.0 / 6.0 * shear * gamma * small_step * thickness;  // force on an edge of length 1
  EXPECT_NEAR((shell.force[1].z + shell.force[2].z) / exact, 1, 1e-12);
  EXPECT_NEAR((shell.force[0].z + shell.force[3].z) / exact, -1, 1e-12);
}

}  // namespace percuss::test
