#pragma once
// Soil, concrete and crushable foam: compaction by a table, shear strength that grows with pressure.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// After Krieg (A simple constitutive description for cellular concrete, Sandia SC-DR-72-0883, 1972): pressure follows
/// `compaction` over the volumetric strain -ln J as far as the material has ever been compacted, and below that a line
/// of slope unloading_bulk_modulus, down to -tension_limit. The von Mises stress is at most a0 + a1 p + a2 p^2, by
/// radial return without dilatation. History: equivalent plastic strain, largest volumetric strain.
struct SoilAndFoam {
  static constexpr const char* name = "soil_and_foam";
  using Constants = SoilAndFoam;
  double shear_modulus = 0, unloading_bulk_modulus = 0, a0 = 0, a1 = 0, a2 = 0, tension_limit = 0;
  MaterialTable compaction;

  static constexpr auto keys() {
    using M = SoilAndFoam;
    return std::array{
        need("shear_modulus", &M::shear_modulus, KeyRange::positive, "pressure", "Shear modulus."),
        need("unloading_bulk_modulus", &M::unloading_bulk_modulus, KeyRange::positive, "pressure",
             "Slope of pressure over volumetric strain on unloading, and after the last row of compaction."),
        need("compaction", &M::compaction, KeyRange::not_negative, "-, pressure",
             "Pressure over the volumetric strain -ln(V / V0), from [0, 0]; no steeper than unloading."),
        need("a0", &M::a0, KeyRange::not_negative, "pressure", "a0 of the strength a0 + a1 p + a2 p^2."),
        may("a1", &M::a1, KeyRange::any, "-", "a1 of the strength a0 + a1 p + a2 p^2."),
        may("a2", &M::a2, KeyRange::any, "1 / pressure", "a2 of the strength a0 + a1 p + a2 p^2."),
        may("tension_limit", &M::tension_limit, KeyRange::not_negative, "pressure",
            "Mean tension at which the material parts.")};
  }
  const char* find_fault() const {
    if (compaction.x[0] != 0 || compaction.y[0] != 0) return "a compaction that does not begin with [0, 0]";
    for (int i = 0; i + 1 < compaction.rows; ++i) {
      const double rise = compaction.y[i + 1] - compaction.y[i];
      if (rise < 0) return "a compaction whose pressure falls";
      if (rise > unloading_bulk_modulus * (compaction.x[i + 1] - compaction.x[i]) * (1 + 1e-12)) {
        return "a compaction that is steeper than its unloading_bulk_modulus";
      }
    }
    return "";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 2;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    return {unloading_bulk_modulus - 2.0 / 3.0 * shear_modulus, shear_modulus};
  }

  /// Pressure at a volumetric strain never reached before.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_compaction(const T& strain) const {
    const T beyond = larger(strain - T(compaction.x[compaction.rows - 1]), T(0));
    return compaction(strain).y + T(unloading_bulk_modulus) * beyond;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const T strain = -logarithm(step.motion.volume_ratio);
    const T largest = larger(step.history[1], strain);
    step.history[1] = largest;
    const T line = find_compaction(largest) - T(unloading_bulk_modulus) * (largest - strain);
    const T pressure = larger(line, T(-tension_limit));

    ElasticTrial<T> trial = find_trial(moduli(), step.stress, step.motion.de);
    trial.mean = -pressure;
    const T strength = larger(T(a0) + pressure * (T(a1) + pressure * T(a2)), T(0));
    const double resistance = 3 * shear_modulus;
    const T dp = larger(trial.von_mises - strength, T(0)) * T(1 / resistance);
    step.history[0] = step.history[0] + dp;
    return_stress(trial, resistance, dp, strength, step);
  }
};

}  // namespace percuss
