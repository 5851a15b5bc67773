#pragma once
// Arruda and Boyce's chain of eight, nearly incompressible.

#include "kernels/material/first_invariant.hpp"

namespace percuss {

/// Stored energy mu sum_i C_i / L^(2i - 2) (I1^i - 3^i) + K/2 (J - 1)^2, L the stretch at which chains lock, C = 1/2,
/// 1/20, 11/1050, 19/7000, 519/673750 (Arruda and Boyce, Journal of the Mechanics and Physics of Solids 41, 389, 1993).
/// History: U.
struct ArrudaBoyce {
  static constexpr const char* name = "arruda_boyce";
  static constexpr bool stores_energy = true;
  static constexpr int terms = 5;
  struct Constants {
    double mu = 0, locking_stretch = 0, bulk_modulus = 0;
  };
  double mu = 0, over_square = 0;  // 1 / L^2
  LameConstants start_moduli{};

  static constexpr auto keys() {
    using A = Constants;
    return std::array{need("mu", &A::mu, KeyRange::positive, "pressure",
                           "mu of the stored energy: the shear modulus of chains that never lock."),
                      need("locking_stretch", &A::locking_stretch, KeyRange::above_one, "-",
                           "Stretch at which the chains are straight."),
                      need("bulk_modulus", &A::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus.")};
  }

  static ArrudaBoyce make(const Constants& c) {
    ArrudaBoyce law{c.mu, 1 / (c.locking_stretch * c.locking_stretch)};
    const double shear = 2 * c.mu * law.find_slopes(3.0).first;
    law.start_moduli = {c.bulk_modulus - 2.0 / 3.0 * shear, shear};
    return law;
  }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  /// Slopes of the energy without mu, by I1.
  template <class T>
  KOKKOS_INLINE_FUNCTION EnergySlopes<T> find_slopes(const T& first) const {
    constexpr double c[terms] = {1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
    EnergySlopes<T> w{T(0), T(0)};
    for (int i = terms; i >= 1; --i) {  // Horner's rule in I1 / L^2
      if (i >= 2) w.second = w.second * (T(over_square) * first) + T(i * (i - 1) * c[i - 1] * over_square);
      w.first = w.first * (T(over_square) * first) + T(i * c[i - 1]);
    }
    return w;
  }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return start_moduli; }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    advance_by_first_invariant(step, moduli(), [this](const T& first) {
      const EnergySlopes<T> w = find_slopes(first);
      return EnergySlopes<T>{T(mu) * w.first, T(mu) * w.second};
    });
  }
};

}  // namespace percuss
