// Cook's membrane of tetrahedra in the linear limit: the mixed form does not lock when nearly incompressible.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/tet/tet_patch.hpp"
#include "tests/verification/support/mapped_mesh.hpp"

namespace percuss::test::cook_test {
namespace {

/// Solves K u = load for u on the free unknowns by conjugate gradients, scaled by the masses.
NodeField solve(TetPatch& patch, const SolidParameters<Elastic>& par, const NodeField& free, const NodeField& load) {
  const std::vector<ElasticTet> start = patch.states;
  const double dt = 1e-9;  // stresses grow from zero: what is left of the second order is 1e-9 of the first
  const auto apply = [&](const NodeField& u) {
    patch.states = start;
    NodeField f = patch.advance(par, u, dt).force;
    for (std::size_t n = 0; n < f.size(); ++n)
      f[n] = {f[n].x / dt * free[n].x, f[n].y / dt * free[n].y, f[n].z / dt * free[n].z};
    return f;
  };
  const auto product = [](const NodeField& a, const NodeField& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += dot(a[n], b[n]);
    return sum;
  };
  const auto scale = [&](const NodeField& a) {
    NodeField b = a;
    for (std::size_t n = 0; n < b.size(); ++n) b[n] = (1 / patch.mass[n]) * b[n];
    return b;
  };
  NodeField u(load.size(), {0, 0, 0}), r = load, z = scale(r), p = z;
  const double first = product(r, z);
  double rz = first;
  for (int i = 0; i < 4000 && rz > 1e-14 * first; ++i) {
    const NodeField kp = apply(p);
    const double alpha = rz / product(p, kp);
    for (std::size_t n = 0; n < u.size(); ++n) {
      u[n] = u[n] + alpha * p[n];
      r[n] = r[n] - alpha * kp[n];
    }
    z = scale(r);
    const double next = product(r, z), beta = next / rz;
    rz = next;
    for (std::size_t n = 0; n < u.size(); ++n) p[n] = z[n] + beta * p[n];
  }
  EXPECT_LE(rz, 1e-14 * first);
  return u;
}

/// Deflection of the upper corner (48 wide, 44 and 16 high, E 240.565, load 100, plane strain), n cells a side.
double find_cook_deflection(int n, double poisson) {
  auto mesh = make_mapped_box({1, n, n}, [](const Vec3& u) {
    const double low = 44 * u[2], high = 44 + 16 * u[2];
    return Vec3{u[0], low + u[1] * (high - low), 48 * u[2]};
  });
  const std::size_t lattice = mesh.nodes.size();
  cut_into_tetrahedra(mesh);
  NodeField x, free, load;
  for (const Vec3& p : mesh.nodes) {
    x.push_back({p[0], p[1], p[2]});
    const double moves = p[2] == 0 ? 0 : 1;
    free.push_back({0, moves, moves});
    const bool corner = p[1] == 44 || p[1] == 60;
    load.push_back({0, p[2] == 48 ? 100.0 / n * (corner ? 0.25 : 0.5) : 0, 0});
  }
  std::vector<std::array<int, 4>> elements;
  const auto& corners = mesh.blocks[0].corners;
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    std::array<int, 4> e;
    for (std::size_t k = 0; k < 4; ++k) e[k] = static_cast<int>(corners[i + k]) - 1;
    elements.push_back(e);
  }
  TetPatch patch(x, elements);
  const SolidParameters<Elastic> par = make_tet_parameters(find_lame_constants(240.565, poisson));
  return solve(patch, par, free, load)[lattice - 1].y;
}

TEST(CooksMembrane, OfMixedTetrahedraDoesNotLockWhenNearlyIncompressible) {
  double share[2][2];  // of the limit, by Poisson's ratio and mesh
  int row = 0;
  for (const auto& [poisson, limit] : {std::pair{0.3333, 9.38}, std::pair{0.4999, 8.05}}) {
    share[row][0] = find_cook_deflection(4, poisson) / limit;
    share[row][1] = find_cook_deflection(8, poisson) / limit;
    fmt::print("mixed tetrahedra, Poisson's ratio {}: {:.3f} {:.3f} of the limit\n", poisson, share[row][0],
               share[row][1]);
    ++row;
  }
  EXPECT_GT(share[0][1], 0.85);
  EXPECT_GT(share[1][1], 0.7);  // plain tetrahedra: 0.3
  EXPECT_GT(share[1][1], share[1][0]);
}

}  // namespace
}  // namespace percuss::test::cook_test
