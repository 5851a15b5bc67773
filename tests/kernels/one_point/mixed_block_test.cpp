// The mixed form over blocks of wedges or of pyramids: patch test, power, momentum and step.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernels/tet/tet4.hpp"
#include "tests/kernels/element/node_fields.hpp"
#include "tests/kernels/one_point/random_solid.hpp"

namespace percuss::test::mixed_block_test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Elements of a cell with these corners, a Pyramid5's apex the node `middle`.
std::vector<std::array<int, 6>> cut_cell(Wedge6, const int (&c)[8], int) {
  return {{c[0], c[1], c[3], c[4], c[5], c[7]}, {c[1], c[2], c[3], c[5], c[6], c[7]}};
}
std::vector<std::array<int, 5>> cut_cell(Pyramid5, const int (&c)[8], int middle) {
  static constexpr int faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                      {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  std::vector<std::array<int, 5>> cut;
  for (const auto& f : faces) cut.push_back({c[f[0]], c[f[1]], c[f[2]], c[f[3]], middle});
  return cut;
}

/// cells^3 cubes of edge 1, their nodes moved by up to `distortion`, each cut; element by element in plain loops.
template <class Shape>
struct MixedBlock {
  static constexpr auto count = static_cast<std::size_t>(Shape::corners);
  using Corners = std::array<int, count>;
  NodeField x;
  std::vector<Corners> elements;
  std::vector<ElasticSolid<Shape>> states;
  std::vector<double> mass;  // of the nodes
  static constexpr double density = 1000;

  MixedBlock(Random& random, int cells, double distortion) {
    const int n = cells + 1;
    for (int i = 0; i < n * n * n; ++i)
      x.push_back(
          {i % n + distortion * random(), i / n % n + distortion * random(), i / (n * n) + distortion * random()});
    for (int k = 0; k < cells * cells * cells; ++k) {
      const int low = k % cells + n * (k / cells % cells) + n * n * (k / (cells * cells));
      const int corner[8] = {low,         low + 1,         low + 1 + n,         low + n,
                             low + n * n, low + 1 + n * n, low + 1 + n + n * n, low + n + n * n};
      Vector3<double> middle{0, 0, 0};
      for (const int c : corner) middle = middle + 0.125 * x[at(c)];
      if (Shape::corners == 5) x.push_back(middle);
      for (const auto& e : cut_cell(Shape(), corner, static_cast<int>(x.size()) - 1)) elements.push_back(e);
    }
    mass.assign(x.size(), 0);
    for (const Corners& e : elements) {
      states.push_back(make_solid<Shape>(density * find_corner_gradient(gather(x, e)).volume));
      for (std::size_t i = 0; i < count; ++i) mass[at(e[i])] += Shape::mass_share[i] * states.back().mass;
    }
  }

  static Places<Shape> gather(const NodeField& of, const Corners& e) {
    Places<Shape> u;
    for (std::size_t i = 0; i < count; ++i) u[static_cast<int>(i)] = of[at(e[i])];
    return u;
  }

  struct Sums {
    Symmetric3<double> a{};
    double volume = 0, bulk = 0, shear = 0;
  };
  struct Outcome {
    NodeField force;
    double step = 1e300, work = 0;
  };

  /// Mean over the corners of what nodes have in sum.
  template <class Read>
  static auto find_mean(const std::vector<Sums>& sums, const Corners& e, const Read& read) {
    auto mean = (1 / sums[at(e[0])].volume / count) * read(sums[at(e[0])]);
    for (std::size_t i = 1; i < count; ++i) mean = mean + (1 / sums[at(e[i])].volume / count) * read(sums[at(e[i])]);
    return mean;
  }

  /// Forces on the nodes, the least step and the power of the stresses, from positions at n+1 and velocities.
  Outcome advance(const SolidParameters<Elastic>& par, const NodeField& v, double dt) {
    const auto tensor = [](const Sums& s) { return s.a; };
    std::vector<Sums> rates(x.size()), stresses(x.size());
    std::vector<OnePointMotion<double, Shape>> motions;
    for (const Corners& e : elements) {
      motions.push_back(follow_one_point(gather(x, e), gather(v, e), dt));
      const double weight = motions.back().volume / count;
      for (const int node : e) {
        rates[at(node)].a = rates[at(node)].a + weight * motions.back().d;
        rates[at(node)].volume += weight;
      }
    }
    Outcome out{NodeField(x.size(), {0, 0, 0})};
    std::vector<OnePointPoint<double, Shape>> points;
    const double k = par.lambda + 2.0 / 3.0 * par.mu;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Symmetric3<double> seen = blend(motions[i].d, find_mean(rates, elements[i], tensor), tet_deviator_share);
      points.push_back(advance_point<true>(par, gather(x, elements[i]), motions[i], seen, dt, states[i]));
      const auto& p = points.back();
      out.work += p.work.internal + p.work.hourglass + p.work.viscous + p.work.guard;
      const double weight = p.geometry.volume / count;
      for (const int node : elements[i]) {
        Sums& s = stresses[at(node)];
        s.a = s.a + weight * add_to_diagonal(p.stress, -states[i].guard);
        s.volume += weight;
        s.bulk += weight * (p.own.lambda + 2.0 / 3.0 * p.own.mu + find_guard_modulus(states[i].guard, k));
        s.shear += weight * p.own.mu;
      }
    }
    for (std::size_t i = 0; i < elements.size(); ++i) add_forces(i, points[i], stresses, k, out);
    return out;
  }

  void add_forces(std::size_t i, const OnePointPoint<double, Shape>& p, const std::vector<Sums>& stresses, double k,
                  Outcome& out) const {
    TetMeans<double> means{};
    means.stress = find_mean(stresses, elements[i], [](const Sums& s) { return s.a; });
    means.bulk = find_mean(stresses, elements[i], [](const Sums& s) { return s.bulk; });
    means.shear = find_mean(stresses, elements[i], [](const Sums& s) { return s.shear; });
    Places<Shape> f;
    find_corner_forces(
        find_mixed_stress(p.stress, means.stress, tet_deviator_share, states[i].guard - states[i].viscous_pressure),
        states[i].hourglass, p.geometry, p.gamma, f);
    for (std::size_t c = 0; c < count; ++c) {
      Vector3<double>& sum = out.force[at(elements[i][c])];
      sum = sum + f[static_cast<int>(c)];
    }
    const TetStiffness<double> felt = mix_moduli<double>({0, p.own.mu, p.own.tangent}, means, tet_deviator_share,
                                                         find_guard_modulus(states[i].guard, k));
    const double lambda = std::max(felt.bulk - 2.0 / 3.0 * felt.shear, 0.0);
    out.step = std::min(out.step, find_one_point_step<double>(p.size, p.geometry.volume, states[i].mass,
                                                              {lambda, felt.shear, p.own.hourglass, felt.tangent}));
  }
};

template <class Shape>
class MixedOnePoint : public testing::Test {};
using MixedShapes = testing::Types<Wedge6, Pyramid5>;
TYPED_TEST_SUITE(MixedOnePoint, MixedShapes);

TYPED_TEST(MixedOnePoint, HasOneStressInALinearField) {
  Random random(11);
  MixedBlock<TypeParam> block(random, 3, 0.15);
  const Matrix3<double> g = random_matrix(random, 1);
  NodeField v;
  for (const auto& x : block.x) v.push_back(g * x);
  block.advance(make_solid_parameters({2e9, 1e9}), v, 1e-3);
  const Symmetric3<double> first = block.states[0].stress;
  for (const auto& state : block.states) {
    const Symmetric3<double> difference = state.stress + -1.0 * first;
    EXPECT_NEAR(std::sqrt(contract(difference, difference) / contract(first, first)), 0, 1e-12);
    for (const auto& mode : state.hourglass.at) EXPECT_NEAR(norm(mode), 0, 1e-12 * std::sqrt(contract(first, first)));
  }
}

TYPED_TEST(MixedOnePoint, HasForcesWhosePowerIsThatOfItsStresses) {
  Random random(12);
  MixedBlock<TypeParam> block(random, 3, 0.15);
  const SolidParameters<Elastic> par = make_solid_parameters({2e9, 1e9}, 0.05, {0.06, 1.2});
  const NodeField v = make_field(random, block.x.size());
  for (std::size_t e = 0; e < block.states.size(); e += 5) block.states[e].gap = -0.6;  // the guard acts
  const double dt = 1e-7;
  block.advance(par, NodeField(v.size(), {0, 0, 0}), 0);
  const NodeField before = block.advance(par, v, 0).force;
  for (std::size_t n = 0; n < v.size(); ++n) block.x[n] = block.x[n] + dt * v[n];
  const auto after = block.advance(par, v, dt);
  // The geometry of forces is that of the ends, of rates that of the middle: a share of dt |grad v| apart.
  EXPECT_NEAR(after.work / (0.5 * dt * (find_power(before, v) + find_power(after.force, v))), 1, 1e-5);
}

TYPED_TEST(MixedOnePoint, ConservesMomentumAndItsMoment) {
  Random random(13);
  MixedBlock<TypeParam> block(random, 3, 0.15);
  const NodeField v = make_field(random, block.x.size());
  const auto outcome = block.advance(make_solid_parameters({2e9, 1e9}, 0.05, {0.06, 1.2}), v, 1e-3);
  expect_balance(block.x, outcome.force);
}

TYPED_TEST(MixedOnePoint, HasAStepBelowTheTrueLargestFrequency) {
  Random random(14);
  double tightest = 0;
  for (int k = 0; k < 24; ++k) {
    MixedBlock<TypeParam> block(random, 2, 0.2 * std::abs(random()));
    const double hourglass[] = {0.05, 0.5, 2, 0};
    const SolidParameters<Elastic> par =
        make_solid_parameters(find_lame_constants(1e9, 0.25 + 0.2499 * random()), hourglass[k % 4]);
    for (auto& state : block.states)
      if (k % 2 == 1 && random() < 0) state.gap = -0.6;  // the guard acts
    MixedBlock<TypeParam> evaluated = block;
    const double step = evaluated.advance(par, NodeField(block.x.size(), {0, 0, 0}), 0).step;
    const double used = step * std::sqrt(find_largest_square(block, par, random)) / 2;
    ASSERT_LE(used, 1) << "block " << k;
    tightest = std::max(tightest, used);
  }
  EXPECT_GT(tightest, 0.4);  // the averages take much of the stiffness that the bound has
}

}  // namespace
}  // namespace percuss::test::mixed_block_test
