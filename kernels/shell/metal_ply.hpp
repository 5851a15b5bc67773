#pragma once
// A layer of rolled sheet in plane stress: anisotropic_plasticity, whose axis 1 has an angle to the element's.

#include "kernels/material/laws/anisotropic_plasticity.hpp"
#include "kernels/shell/barlat_surface.hpp"
#include "kernels/shell/ply.hpp"

namespace percuss {

/// History: p in the place 0 of PlyHistory.
struct MetalPly {
  PlaneElasticity elasticity;
  AnisotropicPlasticity law;
  HillCoefficients hill;
  // Modes of Hill's surface: stresses 11 and 22 by the modes in which it and elasticity are diagonal, and back.
  double to_modes[2][2] = {}, from_modes[2][2] = {}, rate[2] = {};
  BarlatSurface surface;  // where the exponent is not 2

  static MetalPly make(const AnisotropicPlasticity& law, const PlaneElasticity& elasticity) {
    const AnisotropicPlasticityConstants& c = law.constants;
    MetalPly ply;
    ply.elasticity = elasticity;
    ply.law = law;
    ply.hill = c.find_hill();
    if (!c.is_quadratic()) {
      const bool given = AnisotropicPlasticityConstants::is_given(c.barlat);
      ply.surface = given ? BarlatSurface{c.barlat[0], c.barlat[1], c.barlat[2], c.exponent}
                          : BarlatSurface::of_strain_ratios(c.r_values, c.exponent);
    }
    ply.set_modes();
    return ply;
  }

  template <class T>
  PERCUSS_NO_INLINE LayerResponse<T> update(const PlaneDirection<T>& axes, T (&stress)[3], T* history, const T (&de)[3],
                                            const T& dt) const {
    T own[3], before[3];
    axes.turn_strain(de, own);
    axes.turn_stress(stress, before);
    T trial[3] = {before[0], before[1], before[2]};
    elasticity.add_stress(trial, own);
    const auto flow = start_rate_flow(law, history, dt);
    const T secant = find_secant_share(elasticity, flow.at_rest, history[0]);
    const Return<T> to = law.constants.is_quadratic() ? return_to_hill(trial, flow) : return_to_barlat(trial, flow);
    history[0] = history[0] + to.multiplier * to.equivalent;
    axes.back().turn_stress(to.stress, stress);
    const T elastic = T(-elasticity.poissons_ratio / elasticity.youngs_modulus) *
                      (to.stress[0] + to.stress[1] - before[0] - before[1]);
    const T share = T(1) / (T(1) + T(3 * elasticity.shear_modulus) * to.multiplier);
    return {elastic - to.in_plane, share, secant};
  }

 private:
  template <class T>
  struct Return {
    T stress[3], equivalent;
    T multiplier;  // dp over the equivalent stress
    T in_plane;    // sum of the plastic strains 11 and 22
  };

  template <class T, class Flow>
  KOKKOS_INLINE_FUNCTION Return<T> return_to_hill(const T (&trial)[3], const Flow& flow) const {
    const double in_shear = 2 * hill.n * elasticity.shear_modulus;
    QuadraticTrial<T, 3> of{{}, {rate[0], rate[1], in_shear}};
    T mode[2];
    for (int k = 0; k < 2; ++k) {
      mode[k] = T(to_modes[k][0]) * trial[0] + T(to_modes[k][1]) * trial[1];
      of.part[k] = T(rate[k]) * mode[k] * mode[k];
    }
    of.part[2] = T(2 * hill.n) * trial[2] * trial[2];
    const T l = find_multiplier(of, flow);
    for (int k = 0; k < 2; ++k) mode[k] = mode[k] * (T(1) / (T(1) + T(rate[k]) * l));
    Return<T> to;
    for (int k = 0; k < 2; ++k) to.stress[k] = T(from_modes[k][0]) * mode[0] + T(from_modes[k][1]) * mode[1];
    to.stress[2] = trial[2] * (T(1) / (T(1) + T(in_shear) * l));
    to.equivalent = of.find_equivalent(l).value;
    to.multiplier = l;
    to.in_plane = l * (T(hill.g) * to.stress[0] + T(hill.f) * to.stress[1]);
    return to;
  }

  template <class T, class Flow>
  KOKKOS_INLINE_FUNCTION Return<T> return_to_barlat(const T (&trial)[3], const Flow& flow) const {
    const BarlatSolver<T, Flow> solver(surface, elasticity, surface.find_numbers(trial), flow);
    const BarlatReturn<T> of = solver.solve();
    Return<T> to;
    surface.find_stress(of.stress, to.stress);
    const auto elastic = !(of.dp > T(0));
    for (int k = 0; k < 3; ++k) to.stress[k] = select(elastic, trial[k], to.stress[k]);
    T strain[3];
    surface.find_strain(of.gradient, strain);
    to.equivalent = of.equivalent;
    to.multiplier = of.dp / larger(of.equivalent, T(1e-300));
    to.in_plane = of.dp * (strain[0] + strain[1]);
    return to;
  }

  /// Sets the modes v with surface v = rate compliance v, v compliance v = 1 (in the plane of 11 and 22).
  void set_modes() {
    const double over_e = 1 / elasticity.youngs_modulus, s = over_e, t = -elasticity.poissons_ratio * over_e;
    const double own[2] = {s + t, s - t};  // of the sum and of the difference, as unit vectors
    const double xx = hill.g + hill.h, yy = hill.f + hill.h, xy = -hill.h;
    // The surface by these, each over the root of its compliance: a symmetric matrix, whose eigenvectors are sought.
    const double a = 0.5 * (xx + yy + 2 * xy) / own[0], b = 0.5 * (xx + yy - 2 * xy) / own[1];
    const double ab = 0.5 * (xx - yy) / std::sqrt(own[0] * own[1]);
    const double angle = 0.5 * std::atan2(2 * ab, a - b), cosine = std::cos(angle), sine = std::sin(angle);
    const double turn[2][2] = {{cosine, sine}, {-sine, cosine}};
    rate[0] = a * cosine * cosine + 2 * ab * cosine * sine + b * sine * sine;
    rate[1] = a * sine * sine - 2 * ab * cosine * sine + b * cosine * cosine;
    for (int k = 0; k < 2; ++k) {
      const double root = std::sqrt(0.5);
      const double sum = turn[k][0] * std::sqrt(own[0]), difference = turn[k][1] * std::sqrt(own[1]);
      const double over_sum = turn[k][0] / std::sqrt(own[0]), over_difference = turn[k][1] / std::sqrt(own[1]);
      to_modes[k][0] = root * (sum + difference);
      to_modes[k][1] = root * (sum - difference);
      from_modes[0][k] = root * (over_sum + over_difference);
      from_modes[1][k] = root * (over_sum - over_difference);
    }
  }
};

}  // namespace percuss
