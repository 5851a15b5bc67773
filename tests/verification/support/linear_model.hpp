#pragma once
// The linear limit of a mesh of hexahedra: stiffness from the elements' own forces after an infinitesimal step, solved
// by banded Cholesky. Static deflections and natural frequencies then show the element alone, free of time integration.

#include <cmath>
#include <stdexcept>
#include <vector>

#include "kernels/element/hex8/hex8_full.hpp"
#include "kernels/material/elastic.hpp"
#include "tests/kernels/element/random_element.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::test {

/// Component k of the vectors at the corners. (A choice between arrays that is indexed at once takes a wrong index
/// where GCC 12 checks bounds.)
inline double* get_component(Corners& corners, std::size_t k) {
  double* const components[3] = {corners.x, corners.y, corners.z};
  return components[k];
}

/// Symmetric positive definite matrix of bandwidth `band`, its lower half by rows.
class BandedMatrix {
 public:
  BandedMatrix(std::size_t size, std::size_t band) : size_(size), band_(band), values_(size * (band + 1)) {}

  std::size_t size() const { return size_; }
  /// Entry (i, j), j <= i <= j + band.
  double& at(std::size_t i, std::size_t j) { return values_[i * (band_ + 1) + (j + band_ - i)]; }

  void factorise() {
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t first = i > band_ ? i - band_ : 0;
      for (std::size_t j = first; j <= i; ++j) {
        double sum = at(i, j);
        for (std::size_t k = std::max(first, j > band_ ? j - band_ : 0); k < j; ++k) sum -= at(i, k) * at(j, k);
        if (i == j && !(sum > 0)) throw std::runtime_error("the stiffness matrix is not positive definite");
        at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
      }
    }
  }
  /// After factorise().
  std::vector<double> solve(std::vector<double> b) {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = i > band_ ? i - band_ : 0; k < i; ++k) b[i] -= at(i, k) * b[k];
      b[i] /= at(i, i);
    }
    for (std::size_t i = size_; i-- > 0;) {
      b[i] /= at(i, i);
      for (std::size_t k = i > band_ ? i - band_ : 0; k < i; ++k) b[k] -= at(i, k) * b[i];
    }
    return b;
  }

 private:
  std::size_t size_, band_;
  std::vector<double> values_;
};

struct LinearMaterial {
  double young = 1, poisson = 0.3, density = 1;
};

/// A mesh of one block, with unknown 3 n + k in direction k of node n.
class LinearModel {
 public:
  explicit LinearModel(const testing_mesh::WrittenMesh& mesh)
      : nodes_(mesh.nodes), mass(3 * mesh.nodes.size()), held(3 * mesh.nodes.size(), 0) {
    const auto& corners = mesh.blocks.at(0).corners;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (c % 8 == 0) elements_.emplace_back();
      elements_.back()[c % 8] = static_cast<std::size_t>(corners[c] - 1);
    }
  }

  /// Stiffness with `shift` times the mass added; held unknowns are decoupled.
  template <HexKind Kind>
  BandedMatrix assemble(const LinearMaterial& material, double coefficient, double shift) {
    std::size_t band = 0;
    for (const auto& element : elements_) {
      const auto [low, high] = std::minmax_element(element.begin(), element.end());
      band = std::max(band, 3 * (*high - *low) + 2);
    }
    BandedMatrix k(3 * nodes_.size(), band);
    std::fill(mass.begin(), mass.end(), 0.0);
    for (const auto& element : elements_) add_element<Kind>(element, material, coefficient, k);
    for (std::size_t i = 0; i < k.size(); ++i) k.at(i, i) = held[i] ? 1 : k.at(i, i) + shift * mass[i];
    return k;
  }

 private:
  std::vector<Vec3> nodes_;
  std::vector<std::array<std::size_t, 8>> elements_;

 public:
  std::vector<double> mass;  // after assemble()
  std::vector<char> held;

 private:
  template <HexKind Kind>
  void add_element(const std::array<std::size_t, 8>& element, const LinearMaterial& material, double coefficient,
                   BandedMatrix& k) {
    const LameConstants m = find_lame_constants(material.young, material.poisson);
    const SolidParameters<Elastic> par{{m.lambda, m.mu}, m.lambda, m.mu, coefficient, {0, 0}};
    Corners c{};
    for (std::size_t i = 0; i < 8; ++i)
      c.x[i] = nodes_[element[i]][0], c.y[i] = nodes_[element[i]][1], c.z[i] = nodes_[element[i]][2];
    const VectorModes<double> a = find_modes(c);
    const double share = material.density * find_volume_gradient(a).volume / 8;
    const double dt = 1e-60;  // nothing of the second order is left
    for (std::size_t j = 0; j < 24; ++j) {
      const std::size_t column = 3 * element[j % 8] + j / 8;
      mass[column] += share;
      if (held[column]) continue;
      Corners v{}, f{};
      get_component(v, j / 8)[j % 8] = 1;
      auto state = make_state<Elastic, Kind>(1.0, a);
      advance_hex8(par, a, find_modes(v), dt, state, {f.x, f.y, f.z});
      for (std::size_t i = 0; i < 24; ++i) {
        const std::size_t row = 3 * element[i % 8] + i / 8;
        const double force = get_component(f, i / 8)[i % 8];
        if (row >= column && !held[row]) k.at(row, column) += force / dt;
      }
    }
  }
};

/// Calls f(kind, coefficient) with each choice that a deck can make, and its name.
template <class F>
void for_each_choice(F f) {
  f(KindOf<HexKind::stiffness>{}, 0.02, "stiffness 0.02");
  f(KindOf<HexKind::stiffness>{}, 0.05, "stiffness 0.05");
  f(KindOf<HexKind::stiffness>{}, 0.1, "stiffness 0.1");
  f(KindOf<HexKind::assumed_strain>{}, 0.0, "assumed_strain");
  f(KindOf<HexKind::full>{}, 0.0, "full");
}

}  // namespace percuss::test
