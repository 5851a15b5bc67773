#pragma once
// Honeycomb and other materials that crush direction by direction.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// Until it is compacted, each of the six components of stress has a modulus and a strength of its own, without
/// coupling (Whirley, Engelmann and Hallquist, DYNA3D manual UCRL-MA-107254, 1993). The axes are those of space at the
/// start and turn with the element. With c = 1 - J the volumetric crush and f = c / (1 - compacted_volume) between 0
/// and 1:
///   modulus_ij = start_ij + f (solid_ij - start_ij),   |sigma_ij| <= crush_ij(c)
/// A normal stress in tension also stays below tension_cutoff, if there is one.
/// From f = 1 on it is the solid: elastic and perfectly plastic. History: equivalent plastic strain (of the solid).
struct Honeycomb {
  static constexpr const char* name = "honeycomb";
  using Constants = Honeycomb;
  double youngs_modulus = 0, poissons_ratio = 0, yield_stress = 0, compacted_volume = 0;
  double crush_moduli[3] = {0, 0, 0}, shear_moduli[3] = {0, 0, 0};
  MaterialTable crush_xx, crush_yy, crush_zz, crush_xy, crush_yz, crush_zx;
  double tension_cutoff = 0;  // 0: none

  static constexpr auto keys() {
    using M = Honeycomb;
    return with_elastic_keys<M>(
        need("yield_stress", &M::yield_stress, KeyRange::positive, "pressure", "Uniaxial stress at first yield."),
        need("compacted_volume", &M::compacted_volume, KeyRange::share, "-", "V / V0 at which it is solid."),
        need("crush_moduli", &M::crush_moduli, KeyRange::positive, "pressure",
             "Moduli of xx, yy and zz before it is crushed; Young's modulus is that of the solid."),
        need("shear_moduli", &M::shear_moduli, KeyRange::positive, "pressure",
             "Shear moduli of xy, yz and zx before crushing."),
        need("crush_xx", &M::crush_xx, KeyRange::positive, "-, pressure", "Strength of xx over the crush 1 - V / V0."),
        need("crush_yy", &M::crush_yy, KeyRange::positive, "-, pressure", "Strength of yy over the crush 1 - V / V0."),
        need("crush_zz", &M::crush_zz, KeyRange::positive, "-, pressure", "Strength of zz over the crush 1 - V / V0."),
        need("crush_xy", &M::crush_xy, KeyRange::positive, "-, pressure", "Strength of xy over the crush 1 - V / V0."),
        need("crush_yz", &M::crush_yz, KeyRange::positive, "-, pressure", "Strength of yz over the crush 1 - V / V0."),
        need("crush_zx", &M::crush_zx, KeyRange::positive, "-, pressure", "Strength of zx over the crush 1 - V / V0."),
        may("tension_cutoff", &M::tension_cutoff, KeyRange::not_negative, "pressure",
            "Largest tensile stress before it is compacted; 0: the strength."));
  }
  const char* find_fault() const {
    return compacted_volume > 0 && compacted_volume < 1 ? "" : "a compacted_volume that is not between 0 and 1";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    // those at the start, as far as an isotropic material can stand for them
    const double mu = larger(larger(shear_moduli[0], shear_moduli[1]), shear_moduli[2]);
    const double normal = larger(larger(crush_moduli[0], crush_moduli[1]), crush_moduli[2]);
    return {larger(normal - 2 * mu, 0), mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants solid = find_lame_constants(youngs_modulus, poissons_ratio);
    const T crush = T(1) - step.motion.volume_ratio;
    const T share = smaller(larger(crush * T(1 / (1 - compacted_volume)), T(0)), T(1));
    const auto is_solid = share >= T(1);
    const Symmetric3<T> old = step.stress, de = step.motion.de;

    const ElasticTrial<T> trial = find_trial(solid, old, de);
    const double resistance = 3 * solid.mu;
    const T dp = select(is_solid, larger(trial.von_mises - T(yield_stress), T(0)) * T(1 / resistance), T(0));
    step.history[0] = step.history[0] + dp;
    return_stress(trial, resistance, dp, T(yield_stress), step);

    const auto crush_one = [&](const T& stress, const T& strain, double start, double end, const MaterialTable& table,
                               double most = 0) {
      const T limit = table(crush).y, moved = stress + (T(start) + share * T(end - start)) * strain;
      return larger(smaller(moved, most > 0 ? smaller(limit, T(most)) : limit), -limit);
    };
    const double g = 2 * solid.mu;
    const Symmetric3<T> crushed{crush_one(old.xx, de.xx, crush_moduli[0], youngs_modulus, crush_xx, tension_cutoff),
                                crush_one(old.yy, de.yy, crush_moduli[1], youngs_modulus, crush_yy, tension_cutoff),
                                crush_one(old.zz, de.zz, crush_moduli[2], youngs_modulus, crush_zz, tension_cutoff),
                                crush_one(old.xy, de.xy, 2 * shear_moduli[0], g, crush_xy),
                                crush_one(old.yz, de.yz, 2 * shear_moduli[1], g, crush_yz),
                                crush_one(old.zx, de.zx, 2 * shear_moduli[2], g, crush_zx)};
    step.stress = {select(is_solid, step.stress.xx, crushed.xx), select(is_solid, step.stress.yy, crushed.yy),
                   select(is_solid, step.stress.zz, crushed.zz), select(is_solid, step.stress.xy, crushed.xy),
                   select(is_solid, step.stress.yz, crushed.yz), select(is_solid, step.stress.zx, crushed.zx)};
    step.plastic.share = select(is_solid, step.plastic.share, T(1));
    step.plastic.flow_stress = select(is_solid, step.plastic.flow_stress, T(1e300));
    step.plastic.loading = select(is_solid, step.plastic.loading, T(0));
    const LameConstants start = moduli();
    step.mu = T(start.mu) + share * T(solid.mu - start.mu);
    const T normal = T(start.lambda + 2 * start.mu) + share * T(youngs_modulus - start.lambda - 2 * start.mu);
    step.lambda = select(is_solid, T(solid.lambda), larger(normal - T(2) * step.mu, T(0)));
  }
};

}  // namespace percuss
