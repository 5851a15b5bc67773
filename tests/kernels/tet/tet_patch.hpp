#pragma once
// A block of tetrahedra and the mixed form over it, element by element in plain loops.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "kernels/material/elastic.hpp"
#include "kernels/tet/tet4.hpp"
#include "tests/kernels/element/node_fields.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

using ElasticTet = TetState<double, Elastic>;

inline ElasticTet make_tet(double mass) {
  ElasticTet s{};
  s.mass = mass;
  s.polar.rotation = identity_matrix<double>();
  s.polar.stretch = {1, 1, 1, 0, 0, 0};
  return s;
}

inline SolidParameters<Elastic> make_tet_parameters(const LameConstants& c, BulkViscosity viscosity = {0, 0}) {
  return {{c.lambda, c.mu}, std::max(c.lambda, 0.0), c.mu, 0, viscosity};
}

/// cells^3 cubes of edge 1, their inner nodes moved by up to `distortion`, each cut into twelve.
struct TetPatch {
  NodeField x;
  std::vector<std::array<int, 4>> elements;
  std::vector<ElasticTet> states;
  std::vector<double> mass;  // of the nodes
  static constexpr double density = 1000;

  TetPatch(Random& random, int cells, double distortion) {
    const int n = cells + 1;
    for (int i = 0; i < n * n * n; ++i) {
      x.push_back(
          {i % n + distortion * random(), i / n % n + distortion * random(), i / (n * n) + distortion * random()});
    }
    static constexpr int faces[6][4] = {{0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7},
                                        {2, 0, 4, 6}, {2, 3, 1, 0}, {4, 5, 7, 6}};
    for (int c = 0; c < cells * cells * cells; ++c) {
      const int low = c % cells + n * (c / cells % cells) + n * n * (c / (cells * cells));
      int corner[8];
      Vector3<double> middle{0, 0, 0};
      for (int i = 0; i < 8; ++i) {
        corner[i] = low + (i & 1) + n * (i >> 1 & 1) + n * n * (i >> 2);
        middle = middle + 0.125 * x[at(corner[i])];
      }
      x.push_back(middle);
      for (const auto& f : faces) {
        int first = 0;
        for (int i = 1; i < 4; ++i) first = corner[f[i]] < corner[f[first]] ? i : first;
        const auto node = [&](int i) { return corner[f[(first + i) % 4]]; };
        const int apex = static_cast<int>(x.size()) - 1;
        elements.push_back({node(0), node(2), node(1), apex});
        elements.push_back({node(0), node(3), node(2), apex});
      }
    }
    start();
  }

  TetPatch(NodeField nodes, std::vector<std::array<int, 4>> of) : x(std::move(nodes)), elements(std::move(of)) {
    start();
  }

  /// Elements at rest in their first shape, and the masses of the nodes.
  void start() {
    mass.assign(x.size(), 0);
    for (const auto& e : elements) {
      const double of_element = density * find_tet_geometry(gather(x, e)).volume;
      states.push_back(make_tet(of_element));
      for (const int node : e) mass[at(node)] += of_element / 4;
    }
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static TetCorners<double> gather(const NodeField& of, const std::array<int, 4>& e) {
    return {{of[at(e[0])], of[at(e[1])], of[at(e[2])], of[at(e[3])]}};
  }

  /// Forces on the nodes, the least step and the power of the stresses, from positions at n+1 and velocities.
  struct Outcome {
    NodeField force;
    double step = 1e300, work = 0;
  };

  Outcome advance(const SolidParameters<Elastic>& par, const NodeField& v, double dt) {
    struct Sums {
      Symmetric3<double> a{};
      double volume = 0, bulk = 0, shear = 0, mass = 0, square = 0;
    };
    std::vector<Sums> rates(x.size()), stresses(x.size());
    for (const auto& e : elements) {
      const TetMotion<double> m = follow_tet(gather(x, e), gather(v, e), dt);
      for (const int node : e) {
        rates[at(node)].a = rates[at(node)].a + (0.25 * m.middle.volume) * m.d;
        rates[at(node)].volume += 0.25 * m.middle.volume;
      }
    }
    Outcome out{NodeField(x.size(), {0, 0, 0})};
    std::vector<TetPoint<double>> points;
    const double k = par.lambda + 2.0 / 3.0 * par.mu;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const auto& e = elements[i];
      Symmetric3<double> mean{};
      for (const int node : e) mean = mean + (0.25 / rates[at(node)].volume) * rates[at(node)].a;
      const TetMotion<double> m = follow_tet(gather(x, e), gather(v, e), dt);
      points.push_back(advance_tet4<true>(par, gather(x, e), m, blend(m.d, mean, tet_deviator_share), dt, states[i]));
      const TetPoint<double>& p = points.back();
      out.work += p.work.internal + p.work.viscous + p.work.guard;
      for (int corner = 0; corner < 4; ++corner) {
        Sums& s = stresses[at(e[at(corner)])];
        const double weight = 0.25 * p.geometry.volume;
        s.a = s.a + weight * add_to_diagonal(p.stress, -states[i].guard);
        s.volume += weight;
        s.bulk += weight * (p.own.bulk + find_guard_modulus(states[i].guard, k));
        s.shear += weight * p.own.shear;
        s.mass += 0.25 * states[i].mass;
        s.square += dot(p.geometry.b[corner], p.geometry.b[corner]) / p.geometry.volume;
      }
    }
    for (std::size_t i = 0; i < elements.size(); ++i) {
      TetMeans<double> means{};
      double share[4];
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const Sums& s = stresses[at(elements[i][corner])];
        means.stress = means.stress + (0.25 / s.volume) * s.a;
        means.bulk += 0.25 * s.bulk / s.volume;
        means.shear += 0.25 * s.shear / s.volume;
        share[corner] = s.mass / s.square;
      }
      const TetPoint<double>& p = points[i];
      const TetCorners<double> f = find_tet_forces(
          p.geometry,
          find_mixed_stress(p.stress, means.stress, tet_deviator_share, states[i].guard - states[i].viscous_pressure));
      for (int corner = 0; corner < 4; ++corner) {
        Vector3<double>& sum = out.force[at(elements[i][at(corner)])];
        sum = sum + f[corner];
      }
      const double guard = find_guard_modulus(states[i].guard, k);
      out.step =
          std::min(out.step, find_mixed_step(p.geometry, share, mix_moduli(p.own, means, tet_deviator_share, guard)));
    }
    return out;
  }
};

}  // namespace percuss::test
