#pragma once
// Linear elasticity in rates, in the unrotated configuration.
//
// Where an element tells its change of volume, the rate is that of the Kirchhoff stress J sigma, which is what strain
// works on per volume at the start. Its work then depends on the strain reached and not on the path, up to the second
// order of strain; with the rate of sigma itself, cycles of small strains give energy in the first order.

#include "kernels/core/long_sum.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/point_step.hpp"
#include "kernels/material/polar.hpp"

namespace percuss {

/// Lame constants [stress]; they also bound the stiffness that the step estimate uses.
struct LameConstants {
  double lambda = 0;
  double mu = 0;
};

/// lambda and mu from Young's modulus and Poisson's ratio.
PERCUSS_FORCE_INLINE LameConstants find_lame_constants(double youngs_modulus, double poissons_ratio) {
  return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio))};
}

/// Young's modulus, the other way round. mu must be positive.
KOKKOS_INLINE_FUNCTION double find_youngs_modulus(const LameConstants& c) {
  return c.mu * (3 * c.lambda + 2 * c.mu) / (c.lambda + c.mu);
}

/// lambda tr(de) I + 2 mu de.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_elastic_increment(const LameConstants& c, const Symmetric3<T>& de) {
  const T volumetric = number<T>(c.lambda) * trace(de);
  return number<T>(2 * c.mu) * de + Symmetric3<T>{volumetric, volumetric, volumetric, T(0), T(0), T(0)};
}

/// Elastic moduli: one number for all lanes, or one by lane.
template <class S>
struct Moduli {
  S lambda, mu;
};

/// Increment of Cauchy's stress where J sigma grows by lambda tr(de) I + 2 mu de.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_cauchy_increment(const LameConstants& c, const Symmetric3<T>& stress,
                                                         const Symmetric3<T>& de, const VolumeChange<T>& change) {
  return change.inverse * (find_elastic_increment(c, de) + (T(0) - change.growth) * stress);
}

/// Bound of the largest pressure of a direction, at least 0.
template <class T>
PERCUSS_FORCE_INLINE T bound_pressure(const Symmetric3<T>& stress) {
  return larger(bound_by_rows(number<T>(-1.0) * stress), T(0));
}

/// Moduli of the current volume that bound the stiffness: those of J sigma over J, and the largest pressure, by which
/// compression stiffens what the gradient of the velocity works on. A negative lambda counts as 0.
template <class T>
PERCUSS_FORCE_INLINE Moduli<T> find_elastic_moduli(const LameConstants& c, const T& pressure, const T& over_j) {
  return {number<T>(c.lambda > 0 ? c.lambda : 0) * over_j, number<T>(c.mu) * over_j + number<T>(0.5) * pressure};
}

/// Stress increment lambda tr(de) I + 2 mu de; no history, no yield.
struct Elastic {
  static constexpr const char* name = "elastic";
  struct Constants {
    double youngs_modulus = 0, poissons_ratio = 0;
  };
  static constexpr auto keys() { return with_elastic_keys<Constants>(); }

  static constexpr bool is_compiled_in = true;
  static constexpr int history_count = 0;
  static constexpr bool can_yield = false;
  static constexpr bool grows_in_increments = true, is_of_fibres = true;
  double lambda = 0;
  double mu = 0;

  static Elastic make(const Constants& c) {
    const LameConstants moduli = find_lame_constants(c.youngs_modulus, c.poissons_ratio);
    return {moduli.lambda, moduli.mu};
  }

  PERCUSS_FORCE_INLINE LameConstants moduli() const { return {lambda, mu}; }

  /// Advances the unrotated Cauchy stress by the strain increment d dt.
  template <class T>
  PERCUSS_FORCE_INLINE void update(Symmetric3<T>& stress, T* /*history*/, const Symmetric3<T>& de) const {
    const T volumetric = number<T>(lambda) * trace(de);
    stress = stress + number<T>(2 * mu) * de + Symmetric3<T>{volumetric, volumetric, volumetric, T(0), T(0), T(0)};
  }

  /// The update in float, with what the stress does not hold in its rest (long_sum.hpp).
  template <class T>
  PERCUSS_FORCE_INLINE void update(Symmetric3<T>& stress, Symmetric3<T>& rest, T* /*history*/,
                                   const Symmetric3<T>& de) const {
    add_to(stress, rest, find_elastic_increment(moduli(), de));
  }
};

}  // namespace percuss
