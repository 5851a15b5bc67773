// Patch tests: five distorted elements (MacNeal and Harder 1985) under a state of uniform strain or curvature. All
// nodes are moved as the exact solution says; then nothing may be left at the inner nodes.

#include <gtest/gtest.h>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::shell_patch_test {

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
  double about_normal = 0;    // z of what is left
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
    residual.second.left = std::max(residual.second.left, std::hypot(moment[n].x, moment[n].y));
    residual.second.about_normal = std::max(residual.second.about_normal, std::abs(moment[n].z));
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
  EXPECT_LT(moment.about_normal, 1e-12 * force.size * 0.12);
}

TEST(ShellPatch, BendingAndTwistAreExactForSmallRotations) {
  for (const auto& k :
       {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, 0.0, 1.0}, std::array{1.0, 1.0, 0.5}}) {
    const auto [force, moment] = load_patch([&](const Vec& x) { return bend(x, k[0], k[1], k[2]); }, small_step);
    EXPECT_GT(moment.size, 0);
    // The round-off is that of transverse shear, stiffer by the square of length over thickness, 1e4.
    EXPECT_LT(moment.left, 1e-10 * moment.size);
    EXPECT_LT(moment.about_normal, 1e-10 * moment.size);
    EXPECT_LT(force.left, 1e-9 * moment.size / 0.12);
  }
}

TEST(ShellPatch, FiniteBendingLeavesWhatTheWarpOfTheElementsMakes) {
  // A deflection of `share` of the thickness over the patch warps and stretches the elements: what that adds to the
  // moments grows with the square of the deflection over the thickness. About the normal, the nodes are held: on
  // distorted elements corners then drill by what the mean of their slopes misses of the slope of the chord, and what
  // resists that grows with the deflection. Free nodes turn with it.
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

TEST(ShellPatch, TransverseShearIsExact) {
  // w = gamma . x without rotation: one shear in all elements, and inner nodes are free of forces. Their moments hold
  // the rotations back, as the exact solution's do. Edges of inner elements differ by as much as half.
  for (const auto& gamma : {std::array{1.0, 0.0}, std::array{0.0, 1.0}, std::array{0.6, -0.8}}) {
    const auto [force, moment] = load_patch(
        [&](const Vec& x) {
          return Field{{0, 0, gamma[0] * x.x + gamma[1] * x.y}, {0, 0, 0}};
        },
        small_step);
    EXPECT_GT(force.size, 0);
    EXPECT_LT(force.left, 1e-12 * force.size);
  }
}

TEST(ShellPatch, TransverseShearIsUniform) {
  // w = gamma x: ends at right angles to x bear the exact shear stress times thickness and length, half on each corner;
  // of one square, and of the distorted five.
  const double gamma = 1e-3, shear = 1e6 / 2.5;
  const double exact = 5.0 / 6.0 * shear * gamma * small_step * thickness;
  const ShellCorners square{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}};
  const auto load = [&](const ShellCorners& x) {
    ShellCorners v, w{};
    for (std::size_t i = 0; i < 4; ++i) v[i] = {0, 0, gamma * x[i].x};
    TestShell<ElasticLayer> shell({find_plane_elasticity(1e6, 0.25)}, 2, x, thickness, 1);
    shell.advance(move(x, v, small_step), v, w, small_step);
    return shell.force;
  };
  const ShellCorners on_square = load(square);
  EXPECT_NEAR((on_square[1].z + on_square[2].z) / exact, 1, 1e-12);
  EXPECT_NEAR((on_square[0].z + on_square[3].z) / exact, -1, 1e-12);
  double on_node[8] = {};
  for (const auto& element : patch_elements) {
    ShellCorners x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = patch_nodes[element[i]];
    const ShellCorners force = load(x);
    for (std::size_t i = 0; i < 4; ++i) on_node[element[i]] += force[i].z;
  }
  for (const std::size_t right : {1u, 2u}) EXPECT_NEAR(on_node[right] / (0.06 * exact), 1, 1e-12);
  for (const std::size_t left : {0u, 3u}) EXPECT_NEAR(on_node[left] / (0.06 * exact), -1, 1e-12);
}

}  // namespace percuss::test::shell_patch_test
