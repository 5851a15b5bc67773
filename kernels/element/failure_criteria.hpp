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
  double remains = 1;            // 0 where code of a user has deleted all points
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
  double plastic_strain = 0, damage = 0, time_at_yield = 0;
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

/// Plastic strain at which a material fails under this load, by Johnson and Cook or by a table; the smaller of both.
KOKKOS_INLINE_FUNCTION double find_failure_strain(const FailureLimits& limits, const ElementLoad& load, double rate) {
  double strain = FailureLimits::none;
  if (limits.johnson_cook.any()) strain = find_failure_strain(limits.johnson_cook, load, rate);
  if (limits.triaxiality == nullptr) return strain;
  constexpr double far = 1e30;
  const double von_mises = find_von_mises(load.stress), mean = trace(load.stress) / 3;
  const double ratio = von_mises > 0 ? mean / von_mises : (mean < 0 ? -far : far);
  return smaller(strain, limits.strain_factor * (*limits.triaxiality)(ratio).y);
}

/// Adds the plastic strain of a step to a damage below 1; returns how much of it comes after the onset.
KOKKOS_INLINE_FUNCTION double approach_onset(const FailureLimits& limits, const ElementLoad& load, double growth,
                                             double dt, FailureHistory& history) {
  double after = 0;
  if (limits.adds_damage()) {
    const double strain = find_failure_strain(limits, load, growth / dt), rest = (1 - history.damage) * strain;
    history.damage = strain > growth ? history.damage + growth / strain : 1;
    if (history.damage >= 1) after = rest > 0 ? larger(growth - rest, 0.0) : growth;
  }
  if (limits.evolution.any() && load.plastic_strain >= limits.plastic_strain) {
    after = larger(after, smaller(growth, load.plastic_strain - limits.plastic_strain));
    history.damage = larger(history.damage, 1.0);
  }
  return after;
}

/// Adds the plastic strain of a step to the damage: as a share of the failure strain up to the onset, then by the
/// evolution. By work, the force that is left does G by area until failure, however the material hardens.
KOKKOS_INLINE_FUNCTION void add_damage(const FailureLimits& limits, const ElementLoad& load, double growth, double dt,
                                       FailureHistory& history) {
  const bool had_begun = history.damage >= 1;
  const double after = had_begun ? growth : approach_onset(limits, load, growth, dt, history);
  const DamageEvolution& by = limits.evolution;
  if (!by.any() || history.damage < 1) return;
  const double rate = by.by_work > 0 ? by.by_work * find_von_mises(load.stress) : by.by_strain;
  history.damage = (had_begun ? history.damage : 1) + after * rate;
}

/// Adds the step of length dt to the history; returns whether the element fails.
KOKKOS_INLINE_FUNCTION bool fails(const FailureLimits& limits, const ElementLoad& load, double dt,
                                  FailureHistory& history) {
  const double growth = load.plastic_strain - history.plastic_strain;
  history.plastic_strain = load.plastic_strain;
  if (growth > 0) {
    if (limits.yield_time < FailureLimits::none) history.time_at_yield += dt;
    if (limits.adds_damage() || limits.evolution.any()) add_damage(limits, load, growth, dt, history);
  }
  bool failed = load.remains <= 0 || (load.plastic_strain >= limits.plastic_strain && !limits.evolution.any()) ||
                history.time_at_yield >= limits.yield_time || history.damage >= limits.whole_damage() ||
                trace(load.stress) / 3 >= limits.tension || load.volume <= limits.least_volume ||
                load.volume >= limits.most_volume;
  if (limits.principal_stress < FailureLimits::none) failed = failed || reaches(load.stress, limits.principal_stress);
  if (limits.principal_strain < FailureLimits::none) {
    failed = failed || reaches(load.stretch, exp(limits.principal_strain));
  }
  return failed;
}

}  // namespace percuss
