#pragma once
// When does an element fail? Pure functions of its stress, stretch and plastic strain.

#include <cmath>

#include "kernels/core/tensor.hpp"
#include "kernels/element/element_lives.hpp"

namespace percuss {

/// What the criteria read of an element; of one with several points the means over them.
struct ElementLoad {
  Symmetric3<double> stress{};   // Cauchy; the frame does not matter; 0 where no limit asks for it
  Symmetric3<double> stretch{};  // V, likewise
  double plastic_strain = 0;     // equivalent, at n+1
  double remains = 1;            // 0 where the law has deleted all points
  double homologous = 0;         // (T - T room) / (T melt - T room)
  double volume = 1;             // V / V(0); 1 where no limit asks for it
};

/// ElementLoad::homologous at a temperature; 0 where the limits have none.
KOKKOS_INLINE_FUNCTION double find_homologous(const FailureLimits& limits, double temperature) {
  const double range = limits.melt_temperature - limits.room_temperature;
  return range > 0 ? larger((temperature - limits.room_temperature) / range, 0.0) : 0;
}

/// What adds up over the steps.
struct FailureHistory {
  double plastic_strain = 0, damage = 0;
  double second = 0;  // time at yield; or damage by shear; or, with DamageCoupling::strain, the sum that reaches 1
                      // where force begins to fall, then 1 and what the damage was there
};

/// J of a stretch V.
KOKKOS_INLINE_FUNCTION double find_stretch_determinant(const Symmetric3<double>& v) {
  return v.xx * (v.yy * v.zz - v.yz * v.yz) - v.xy * (v.xy * v.zz - v.yz * v.zx) + v.zx * (v.xy * v.yz - v.yy * v.zx);
}

KOKKOS_INLINE_FUNCTION Symmetric3<double> find_deviator(const Symmetric3<double>& a) {
  const double mean = trace(a) / 3;
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy, a.yz, a.zx};
}

/// The largest eigenvalue: mean + 2 p cos(acos(det(A / p) / 2) / 3) with A the deviator, p^2 = A : A / 6.
/// Source: Smith, Eigenvalues of a symmetric 3 x 3 matrix, Comm. ACM 4 (1961).
KOKKOS_INLINE_FUNCTION double find_largest_eigenvalue(const Symmetric3<double>& a) {
  const Symmetric3<double> d = find_deviator(a);
  const double mean = trace(a) / 3, p = sqrt(contract(d, d) / 6);
  if (!(p > 0)) return mean;
  const double det =
      d.xx * (d.yy * d.zz - d.yz * d.yz) - d.xy * (d.xy * d.zz - d.yz * d.zx) + d.zx * (d.xy * d.yz - d.yy * d.zx);
  const double half = det / (2 * p * p * p);
  const double cosine = half > 1 ? 1 : (half < -1 ? -1 : half);
  return mean + 2 * p * cos(acos(cosine) / 3);
}

/// Whether the largest eigenvalue reaches a limit. It is at most mean + sqrt(2/3) |A|, which mostly answers already.
KOKKOS_INLINE_FUNCTION bool reaches(const Symmetric3<double>& a, double limit) {
  const Symmetric3<double> d = find_deviator(a);
  const double room = limit - trace(a) / 3;
  if (room > 0 && 1.5 * room * room > contract(d, d)) return false;
  return find_largest_eigenvalue(a) >= limit;
}

/// Logarithm of the thickness at the start over that now, of a layer in plane stress whose strain in the plane is
/// known: plastic flow keeps the volume, so that its change is that of the stress.
KOKKOS_INLINE_FUNCTION double find_thinning(const Symmetric3<double>& strain, double stress_sum,
                                            double compressibility) {
  return strain.xx + strain.yy - compressibility * stress_sum;
}

/// Plastic strain at which a material fails under this load.
/// Source: Johnson and Cook, Eng. Fracture Mech. 21 (1985), eq. (4), for mean stresses up to 1.5 times von Mises'; the
/// stress ratio counts as 1.5 beyond. Rates below the reference count as the reference.
KOKKOS_INLINE_FUNCTION double find_failure_strain(const JohnsonCookDamage& d, const ElementLoad& load, double rate) {
  constexpr double largest_ratio = 1.5;
  const Symmetric3<double> deviator = find_deviator(load.stress);
  const double von_mises = sqrt(1.5 * contract(deviator, deviator)), mean = trace(load.stress) / 3;
  const double ratio = mean < largest_ratio * von_mises ? mean / von_mises : largest_ratio;
  const double relative_rate = rate > d.reference_rate ? rate / d.reference_rate : 1;
  return (d.d1 + d.d2 * exp(d.d3 * ratio)) * (1 + d.d4 * log(relative_rate)) * (1 + d.d5 * load.homologous);
}

/// Von Mises stress.
KOKKOS_INLINE_FUNCTION double find_von_mises(const Symmetric3<double>& stress) {
  const Symmetric3<double> deviator = find_deviator(stress);
  return sqrt(1.5 * contract(deviator, deviator));
}

/// Mean by von Mises stress.
KOKKOS_INLINE_FUNCTION double find_triaxiality(const Symmetric3<double>& stress) {
  constexpr double far = 1e30;
  const double von_mises = find_von_mises(stress), mean = trace(stress) / 3;
  return von_mises > 0 ? mean / von_mises : (mean < 0 ? -far : far);
}

/// (von Mises stress - factor mean stress) / largest shear stress; Abaqus' shear stress ratio.
KOKKOS_INLINE_FUNCTION double find_shear_ratio(const Symmetric3<double>& stress, double factor) {
  constexpr double far = 1e30;
  const Symmetric3<double> d = find_deviator(stress), turned{-d.xx, -d.yy, -d.zz, -d.xy, -d.yz, -d.zx};
  const double shear = 0.5 * (find_largest_eigenvalue(d) + find_largest_eigenvalue(turned));
  return shear > 0 ? (find_von_mises(stress) - factor * trace(stress) / 3) / shear : far;
}

/// Factor of the failure strain by the strain rate, from a table.
KOKKOS_INLINE_FUNCTION double find_rate_factor(const FailureLimits& limits, double rate) {
  return limits.rate_factor == nullptr ? 1 : (*limits.rate_factor)(rate).y;
}

/// Plastic strain at which a material fails under this load, by Johnson and Cook or by a table; the smaller of both.
KOKKOS_INLINE_FUNCTION double find_failure_strain(const FailureLimits& limits, const ElementLoad& load, double rate) {
  double strain = FailureLimits::none;
  if (limits.johnson_cook.any()) strain = find_failure_strain(limits.johnson_cook, load, rate);
  if (limits.triaxiality == nullptr) return strain;
  const double factor = limits.strain_factor * find_rate_factor(limits, rate);
  return smaller(strain, factor * (*limits.triaxiality)(find_triaxiality(load.stress)).y);
}

/// Adds a plastic strain to a sum below 1, as a share of that at which the sum is 1. Returns how much of it comes
/// after.
KOKKOS_INLINE_FUNCTION double add_share(double growth, double strain, double& sum) {
  const double rest = (1 - sum) * strain;
  sum = strain > growth ? sum + growth / strain : 1;
  return sum < 1 ? 0 : (rest > 0 ? larger(growth - rest, 0.0) : growth);
}

/// Adds the plastic strain of a step to a damage below 1; returns how much of it comes after the onset.
KOKKOS_INLINE_FUNCTION double approach_onset(const FailureLimits& limits, const ElementLoad& load, double growth,
                                             double dt, FailureHistory& history) {
  double after = 0;
  if (limits.johnson_cook.any() || limits.triaxiality != nullptr)
    after = add_share(growth, find_failure_strain(limits, load, growth / dt), history.damage);
  if (limits.shear.strain != nullptr) {
    const double ratio = find_shear_ratio(load.stress, limits.shear.pressure_factor),
                 factor = limits.strain_factor * find_rate_factor(limits, growth / dt);
    after = larger(after, add_share(growth, factor * (*limits.shear.strain)(ratio).y, history.second));
    if (history.second >= 1) history.damage = larger(history.damage, 1.0);
  }
  if (limits.evolution.any() && load.plastic_strain >= limits.plastic_strain) {
    after = larger(after, smaller(growth, load.plastic_strain - limits.plastic_strain));
    history.damage = larger(history.damage, 1.0);
  }
  return after;
}

/// Adds the plastic strain of a step to the sum that says where force begins to fall; had: the damage before the step.
KOKKOS_INLINE_FUNCTION void approach_coupling(const FailureLimits& limits, const ElementLoad& load, double growth,
                                              double dt, double had, FailureHistory& history) {
  if (limits.coupling.strain == nullptr || history.second >= 1) return;
  const double strain =
                   find_rate_factor(limits, growth / dt) * (*limits.coupling.strain)(find_triaxiality(load.stress)).y,
               after = add_share(growth, strain, history.second);
  if (history.second < 1) return;
  history.second = 1 + smaller(history.damage - (history.damage - had) * (after / growth), 1.0);
}

/// Adds the plastic strain of a step to the damage: as a share of the failure strain up to the onset, then by the
/// evolution. By work, the force that is left does G by area until failure, however the material hardens.
KOKKOS_INLINE_FUNCTION void add_damage(const FailureLimits& limits, const ElementLoad& load, double growth, double dt,
                                       FailureHistory& history) {
  const bool had_begun = history.damage >= 1;
  const double had = history.damage;
  const double after = had_begun ? growth : approach_onset(limits, load, growth, dt, history);
  if (!had_begun) approach_coupling(limits, load, growth, dt, had, history);
  const DamageEvolution& by = limits.evolution;
  if (!by.any() || history.damage < 1) return;
  const double rate = by.by_work > 0 ? by.by_work * find_von_mises(load.stress) : by.by_strain;
  history.damage = (had_begun ? history.damage : 1) + after * rate;
}

/// Share of the force that is left at a damage from 1 to 2.
KOKKOS_INLINE_FUNCTION double find_share(const DamageEvolution& by, double damage) {
  if (!(damage > 1)) return 1;
  if (!(damage < 2)) return 0;
  if (by.lost != nullptr) return 1 - (*by.lost)(damage - 1).y;
  if (!(by.exponent > 0)) return 2 - damage;
  const double last = exp(-by.exponent);
  return (exp(-by.exponent * (damage - 1)) - last) / (1 - last);
}

/// Share of the force that is left of an element whose damage is coupled to it.
KOKKOS_INLINE_FUNCTION double find_share(const DamageCoupling& by, const FailureHistory& history) {
  const double damage = pow(history.damage, by.damage_exponent);
  if (by.strain != nullptr && !(history.second >= 1)) return 1;
  const double start = by.strain == nullptr ? by.start : pow(history.second - 1, by.damage_exponent);
  if (!(damage > start)) return 1;
  return damage < 1 ? 1 - pow((damage - start) / (1 - start), by.fade_exponent) : 0;
}

/// Share of the force that damage leaves.
KOKKOS_INLINE_FUNCTION double find_force_share(const FailureLimits& limits, const FailureHistory& history) {
  return limits.coupling.any() ? find_share(limits.coupling, history) : find_share(limits.evolution, history.damage);
}

/// Damage as results show it: up to the onset the larger of both, then 1 and the share of force that is lost; with a
/// coupling the sum to its power.
KOKKOS_INLINE_FUNCTION double find_shown_damage(const FailureLimits& limits, const FailureHistory& history) {
  if (limits.coupling.any()) return pow(history.damage, limits.coupling.damage_exponent);
  if (history.damage < 1)
    return limits.shear.strain == nullptr ? history.damage : larger(history.damage, history.second);
  const DamageEvolution& by = limits.evolution;
  const bool is_straight = by.lost == nullptr && !(by.exponent > 0);
  return is_straight ? history.damage : 2 - find_share(by, history.damage);
}

/// Adds the step of length dt to the history; returns whether the element fails by anything but its stretch.
KOKKOS_INLINE_FUNCTION bool fails_by_load(const FailureLimits& limits, const ElementLoad& load, double dt,
                                          FailureHistory& history) {
  const double growth = load.plastic_strain - history.plastic_strain;
  history.plastic_strain = load.plastic_strain;
  if (growth > 0) {
    if (limits.yield_time < FailureLimits::none) history.second += dt;
    if (limits.adds_damage() || limits.evolution.any()) add_damage(limits, load, growth, dt, history);
  }
  const bool failed = load.remains <= 0 || (load.plastic_strain >= limits.plastic_strain && !limits.evolution.any()) ||
                      history.second >= limits.yield_time || history.damage >= limits.whole_damage() ||
                      trace(load.stress) / 3 >= limits.tension || load.volume <= limits.least_volume ||
                      load.volume >= limits.most_volume;
  return failed || (limits.principal_stress < FailureLimits::none && reaches(load.stress, limits.principal_stress));
}

/// Adds the step of length dt to the history; returns whether the element fails.
KOKKOS_INLINE_FUNCTION bool fails(const FailureLimits& limits, const ElementLoad& load, double dt,
                                  FailureHistory& history) {
  const bool failed = fails_by_load(limits, load, dt, history);
  return failed ||
         (limits.principal_strain < FailureLimits::none && reaches(load.stretch, exp(limits.principal_strain)));
}

}  // namespace percuss
