#pragma once
// Gent's rubber, as an example of a law of your own: percuss build-law gent.hpp makes gent.so of it.

#include "kernels/material/first_invariant.hpp"

/// Stored energy -mu Jm / 2 ln(1 - (I1 - 3) / Jm) + K / 2 (J - 1)^2, whose chains cannot be stretched beyond I1 = 3 +
/// Jm (Gent, Rubber Chemistry and Technology 69, 59, 1996). History: U.
struct Gent {
  static constexpr const char* name = "gent";
  static constexpr bool stores_energy = true;
  using Constants = Gent;
  double shear_modulus = 0, limit = 0, bulk_modulus = 0;

  static constexpr auto keys() {
    using namespace percuss;
    return std::array{need("shear_modulus", &Gent::shear_modulus, KeyRange::positive, "pressure", "mu."),
                      need("limit", &Gent::limit, KeyRange::positive, "-", "Jm, the largest I1 - 3."),
                      need("bulk_modulus", &Gent::bulk_modulus, KeyRange::positive, "pressure", "K.")};
  }
  /// What is wrong between the constants; null: nothing.
  const char* find_fault() const {
    return bulk_modulus > shear_modulus ? nullptr : "a bulk_modulus that is not above its shear_modulus: raise it";
  }

  static constexpr int history_count = percuss::StretchHistory::count;
  static void start(double* history) { percuss::StretchHistory::start(history); }

  percuss::LameConstants moduli() const { return {bulk_modulus - 2.0 / 3.0 * shear_modulus, shear_modulus}; }

  /// T: a number, or a pack of them, one for each of several points.
  template <class T>
  void update(percuss::PointStep<T>& step) const {
    percuss::advance_by_first_invariant(step, moduli(), [this](const T& first) {
      const T left = percuss::larger(T(1) - (first - T(3)) * T(1 / limit), T(1e-3));
      const T slope = T(0.5 * shear_modulus) / left;
      return percuss::EnergySlopes<T>{slope, slope / (T(limit) * left)};
    });
  }
};
