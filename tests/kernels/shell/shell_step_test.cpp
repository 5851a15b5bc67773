// The step bound against the largest eigenvalue of random elements.

#include <gtest/gtest.h>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test {

namespace {

constexpr int freedoms = 24;
using Matrix = std::array<std::array<double, freedoms>, freedoms>;

double& component(Vec& a, std::size_t k) { return k == 0 ? a.x : k == 1 ? a.y : a.z; }

/// Stiffness of an unstressed element, scaled by its masses: column by column, by motions so small that nothing turns.
Matrix find_scaled_stiffness(const TestShell<ElasticLayer>& shell, const ShellCorners& x) {
  const double node_mass = shell.state.mass / 4, inertia = node_mass * shell.state.gyration_square;
  const double dt = 1e-10;
  Matrix k{};
  for (std::size_t j = 0; j < freedoms; ++j) {
    ShellCorners v{}, w{};
    component(j < 12 ? v[j / 3] : w[j / 3 - 4], j % 3) = 1;
    TestShell<ElasticLayer> moved = shell;
    moved.advance(move(x, v, dt), v, w, dt);
    for (std::size_t i = 0; i < freedoms; ++i) {
      Vec row = i < 12 ? moved.force[i / 3] : moved.moment[i / 3 - 4];
      k[i][j] = component(row, i % 3) / dt / std::sqrt((i < 12 ? node_mass : inertia) * (j < 12 ? node_mass : inertia));
    }
  }
  return k;
}

/// The same of a triangle, whose nodes have a third of the mass each; the rows and columns of the corner that stands
/// twice are left empty.
Matrix find_scaled_triangle_stiffness(const TestShell<ElasticLayer>& shell, const ShellCorners& x) {
  const double node_mass = shell.state.mass / 3, inertia = node_mass * shell.state.gyration_square;
  const double dt = 1e-10;
  Matrix k{};
  for (std::size_t j = 0; j < freedoms; ++j) {
    if (j % 12 / 3 == 3) continue;
    ShellCorners v{}, w{};
    component(j < 12 ? v[j / 3] : w[j / 3 - 4], j % 3) = 1;
    v[3] = v[2];
    w[3] = w[2];
    TestShell<ElasticLayer> moved = shell;
    moved.advance(move(x, v, dt), v, w, dt);
    moved.force[2] = moved.force[2] + moved.force[3];
    moved.moment[2] = moved.moment[2] + moved.moment[3];
    for (std::size_t i = 0; i < freedoms; ++i) {
      if (i % 12 / 3 == 3) continue;
      Vec row = i < 12 ? moved.force[i / 3] : moved.moment[i / 3 - 4];
      k[i][j] = component(row, i % 3) / dt / std::sqrt((i < 12 ? node_mass : inertia) * (j < 12 ? node_mass : inertia));
    }
  }
  return k;
}

/// The matrix times itself, scaled to a norm of 1.
Matrix square(const Matrix& k) {
  Matrix product{};
  double sum = 0;
  for (std::size_t i = 0; i < freedoms; ++i) {
    for (std::size_t j = 0; j < freedoms; ++j) {
      for (std::size_t l = 0; l < freedoms; ++l) product[i][l] += k[i][j] * k[j][l];
    }
    for (const double value : product[i]) sum += value * value;
  }
  for (auto& row : product) {
    for (double& value : row) value /= std::sqrt(sum);
  }
  return product;
}

/// Largest eigenvalue: Rayleigh quotient of the largest column of the 256th power.
double find_largest_eigenvalue(const Matrix& k) {
  Matrix power = square(k);
  for (int squaring = 0; squaring < 7; ++squaring) power = square(power);
  std::size_t largest = 0;
  for (std::size_t j = 1; j < freedoms; ++j) {
    if (power[j][j] > power[largest][largest]) largest = j;
  }
  const auto& u = power[largest];  // of a symmetric matrix
  double quotient = 0, size = 0;
  for (std::size_t i = 0; i < freedoms; ++i) {
    size += u[i] * u[i];
    for (std::size_t j = 0; j < freedoms; ++j) quotient += u[i] * k[i][j] * u[j];
  }
  return quotient / size;
}

struct StepShare {
  double largest = 0, least = 1e300;  // bound over the exact step
  int concave = 0;

  void take(double share) {
    largest = std::max(largest, share);
    least = std::min(least, share);
  }
};

/// distortion, warp: of the elements at most, as a share of their edges. Every other element is flat.
struct Shapes {
  double distortion = 0.2, warp = 0.2, longest = 5;
  double thinnest = 1e-3, thickest = 0.3;  // in edges
};

/// offset: of the middle of the section from the mesh, in units of half the thickness.
StepShare compare_steps(Random& random, int trials, double stretch, double offset = 0, const Shapes& shapes = {}) {
  StepShare share;
  for (int trial = 0; trial < trials; ++trial) {
    const double aspect = 1 + (shapes.longest - 1) * (0.5 + 0.5 * random()), poisson = -0.2 + 0.69 * random();
    const double thickness = shapes.thinnest * std::pow(shapes.thickest / shapes.thinnest, 0.5 + 0.5 * random());
    const ShellCorners start = make_quad(random, aspect, 1, shapes.distortion, trial % 2 == 0 ? 0 : shapes.warp);
    const auto geometry = find_shell_geometry(find_differences(start));
    if (geometry.area < 1e-2 * aspect) continue;  // a sliver: differences have no small step
    TestShell<ElasticLayer> shell({find_plane_elasticity(1, poisson)}, 2, start, thickness, 1);
    shell.par.offset = offset * thickness / 2;
    shell.state.gyration_square += shell.par.offset * shell.par.offset;
    ShellCorners x = start;
    for (Vec& corner : x) corner = stretch * corner;
    shell.state.thickness /= stretch * stretch;
    const double bound = shell.advance(x, {}, {}, 0).stable_step;
    share.take(bound / (2 / std::sqrt(find_largest_eigenvalue(find_scaled_stiffness(shell, x)))));
    if (geometry.least_cosine < 0) ++share.concave;
  }
  return share;
}

/// Stiffness by differences.
constexpr double round_off = 1e-6;

/// Random triangles with angles down to some 5 degrees.
StepShare compare_triangle_steps(Random& random, int trials, double stretch, double offset = 0) {
  StepShare share;
  for (int trial = 0; trial < trials; ++trial) {
    const double poisson = -0.2 + 0.69 * random(), thickness = std::pow(10.0, -1.5 + 1.5 * random());
    ShellCorners x = make_triangle({0, 0, 0}, {1, 0, 0}, {0.5 + random(), 0.65 + 0.55 * random(), 0});
    TestShell<ElasticLayer> shell({find_plane_elasticity(1, poisson)}, 2, x, thickness, 1);
    shell.par.offset = offset * thickness / 2;
    shell.state.gyration_square += shell.par.offset * shell.par.offset;
    for (Vec& corner : x) corner = stretch * corner;
    shell.state.thickness /= stretch * stretch;
    const double bound = shell.advance(x, {}, {}, 0).stable_step;
    const double exact = 2 / std::sqrt(find_largest_eigenvalue(find_scaled_triangle_stiffness(shell, x)));
    share.take(bound / exact);
  }
  return share;
}

}  // namespace

TEST(ShellStep, BoundIsBelowTheExactStepOfRandomTriangles) {
  Random random(25);
  // A stretched triangle is thinner and pays for rotary inertia that its section no longer has: the bound falls with
  // it.
  const double least[][2] = {{1, 0.6}, {0.5, 0.6}, {2, 0.45}, {4, 0.22}};
  for (const auto& [stretch, enough] : least) {
    const StepShare share = compare_triangle_steps(random, 4000, stretch);
    EXPECT_LE(share.largest, 1 + round_off) << stretch;
    EXPECT_GT(share.least, enough) << stretch;
  }
}

TEST(ShellStep, BoundHoldsForTrianglesWhoseSectionIsOffTheMesh) {
  Random random(26);
  for (const double offset : {1.0, -1.0, 4.0, 30.0}) {
    const StepShare share = compare_triangle_steps(random, 500, 1, offset);
    EXPECT_LE(share.largest, 1 + round_off) << offset;
    EXPECT_GT(share.least, 0.6) << offset;
  }
}

TEST(ShellStep, BoundIsBelowTheExactStepOfRandomElements) {
  Random random(21);
  const StepShare share = compare_steps(random, 3000, 1);
  EXPECT_LE(share.largest, 1 + round_off);
  EXPECT_GT(share.least, 0.75);
}

TEST(ShellStep, BoundHoldsForThickAndForLongElements) {
  Random random(27);
  for (const Shapes& shapes : {Shapes{0.2, 0.2, 5, 0.1, 2}, Shapes{0.2, 0.2, 20, 1e-3, 0.5}}) {
    const StepShare share = compare_steps(random, 1000, 1, 0, shapes);
    EXPECT_LE(share.largest, 1 + round_off) << shapes.longest;
    EXPECT_GT(share.least, 0.65) << shapes.longest;
  }
}

TEST(ShellStep, BoundHoldsForElementsThatWereStretched) {
  Random random(22);
  for (const double stretch : {0.5, 2.0, 4.0}) {
    const StepShare share = compare_steps(random, 500, stretch);
    EXPECT_LE(share.largest, 1 + round_off) << stretch;
    EXPECT_GT(share.least, 0.65) << stretch;
  }
}

TEST(ShellStep, BoundHoldsForStronglyWarpedElements) {
  Random random(24);
  // Corners out of the plane by up to as much as half the shorter edge, which turns their normals by up to 70 degrees.
  const StepShare share = compare_steps(random, 1000, 1, 0, {0.2, 0.5});
  EXPECT_LE(share.largest, 1 + round_off);
  EXPECT_GT(share.least, 0.7);
}

TEST(ShellStep, BoundHoldsForConcaveAndCrossedElements) {
  // Corners of squares moved by up to 0.8 of an edge; of oblongs by 1.3, so that edges cross. Flat ones and warped ones.
  Random random(28);
  for (const Shapes& shapes : {Shapes{0.8, 0.8, 1.01}, Shapes{1.3, 0.3, 3}}) {
    const StepShare share = compare_steps(random, 2000, 1, 0, shapes);
    EXPECT_GT(share.concave, 150) << shapes.distortion;
    EXPECT_LE(share.largest, 1 + round_off) << shapes.distortion;
    EXPECT_GT(share.least, 0.3) << shapes.distortion;
  }
}

TEST(ShellStep, BoundHoldsForSectionsOffTheMesh) {
  Random random(23);
  for (const double offset : {1.0, -1.0, 4.0, 30.0}) {
    const StepShare share = compare_steps(random, 500, 1, offset);
    EXPECT_LE(share.largest, 1 + round_off) << offset;
    EXPECT_GT(share.least, 0.4) << offset;
  }
  EXPECT_LE(compare_steps(random, 300, 2, 1).largest, 1 + round_off);
}

}  // namespace percuss::test
