#pragma once
// Linear (hypo)elasticity in the unrotated configuration.

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Lame constants [stress]; they also bound the stiffness that the step estimate uses.
struct LameConstants {
  double lambda = 0;
  double mu = 0;
};

/// lambda and mu from Young's modulus and Poisson's ratio.
KOKKOS_INLINE_FUNCTION LameConstants find_lame_constants(double youngs_modulus, double poissons_ratio) {
  return {youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio)),
          youngs_modulus / (2 * (1 + poissons_ratio))};
}

/// Stress increment lambda tr(de) I + 2 mu de; no history.
struct Elastic {
  static constexpr int history_count = 0;
  double lambda = 0;
  double mu = 0;

  /// Advances the unrotated Cauchy stress by the strain increment d dt. Returns the share of the trial deviator that
  /// plastic return leaves: always 1 here.
  template <class T>
  KOKKOS_INLINE_FUNCTION T update(Symmetric3<T>& stress, T* /*history*/, const Symmetric3<T>& de) const {
    const T volumetric = T(lambda) * trace(de);
    stress = stress + T(2 * mu) * de + Symmetric3<T>{volumetric, volumetric, volumetric, T(0), T(0), T(0)};
    return T(1);
  }
};

}  // namespace percuss
