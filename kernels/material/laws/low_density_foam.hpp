#pragma once
// Low-density foam: each principal stretch has its own stress, from one curve of a uniaxial test; less of it on the way
// back.

#include "kernels/material/foam_stress.hpp"

namespace percuss {

/// Nominal stress in each principal direction of U, without coupling: f(1 - stretch) in compression, from the table,
/// and youngs_modulus (stretch - 1) in tension; Cauchy stress is stretch / J times that, and times
///   g = 1 - (1 - hysteretic_unloading) (1 - (W / W_max)^unloading_shape),
/// W the energy that the curves store now and W_max the most that it has been (foam_stress.hpp). A release to rest
/// gives hysteretic_unloading + (1 - hysteretic_unloading) / (unloading_shape + 1) of W_max back. History: U, with
/// hysteresis W_max.
struct LowDensityFoam {
  static constexpr const char* name = "low_density_foam";
  static constexpr bool is_stretched_far = true;  // as what stores energy is
  using Constants = LowDensityFoam;
  double youngs_modulus = 0;
  double hysteretic_unloading = 1, unloading_shape = 1;
  MaterialTable compression;

  static constexpr auto keys() {
    using M = LowDensityFoam;
    return std::array{
        need("youngs_modulus", &M::youngs_modulus, KeyRange::positive, "pressure", "Young's modulus."),
        need("compression", &M::compression, KeyRange::not_negative, "-, pressure",
             "Nominal stress over nominal strain of a uniaxial compression, both positive, from [0, 0] on; its last "
             "slope goes on."),
        may("hysteretic_unloading", &M::hysteretic_unloading, KeyRange::share, "-",
            "Share h of the stress that is left at the end of a release: 1 - (1 - h) (1 - (W / W_max)^s) of it is left "
            "at the stored energy W; 1: no hysteresis."),
        may("unloading_shape", &M::unloading_shape, KeyRange::positive, "-",
            "Exponent s of the release; see hysteretic_unloading.")};
  }
  const char* find_fault() const {
    if (compression.rows < 2 || compression.x[0] != 0 || compression.y[0] != 0) {
      return "a compression that does not begin with [0, 0] and a second row";
    }
    for (int i = 0; i + 1 < compression.rows; ++i) {
      if (compression.y[i + 1] < compression.y[i]) return "a compression whose stress falls";
    }
    return "";
  }

  static constexpr int history_count = StretchHistory::count + 1;
  int count_history() const { return StretchHistory::count + (has_hysteresis() ? 1 : 0); }
  static void start(double* history) { StretchHistory::start(history); }

  /// Moduli at rest, without lateral strain.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    const double slope = compression.y[1] / compression.x[1];
    return {0, 0.5 * larger(slope, youngs_modulus)};
  }

  /// Nominal stress, positive in tension, and its slope.
  template <class T>
  KOKKOS_INLINE_FUNCTION MaterialTable::Value<T> find_nominal(const T& stretch) const {
    const int last = compression.rows - 1;
    const double end =
        (compression.y[last] - compression.y[last - 1]) / (compression.x[last] - compression.x[last - 1]);
    const T strain = T(1) - stretch, beyond = strain - T(compression.x[last]);
    auto value = compression(strain);
    value.y = select(beyond > T(0), T(compression.y[last]) + T(end) * beyond, value.y);
    value.slope = select(beyond >= T(0), T(end), value.slope);
    const auto pulled = strain < T(0);
    return {select(pulled, T(-youngs_modulus) * strain, -value.y), select(pulled, T(youngs_modulus), value.slope)};
  }

  /// Area below the curve up to there, on either side: energy per volume at the start.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_energy(const T& stretch) const {
    const T strain = T(1) - stretch, pull = larger(-strain, T(0));
    T energy = T(0.5 * youngs_modulus) * pull * pull;
    for (int i = 0; i + 1 < compression.rows; ++i) {
      const double width = compression.x[i + 1] - compression.x[i];
      const double slope = (compression.y[i + 1] - compression.y[i]) / width;
      T within = larger(strain - T(compression.x[i]), T(0));
      if (i + 2 < compression.rows) within = smaller(within, T(width));
      energy = energy + within * (T(compression.y[i]) + T(0.5 * slope) * within);
    }
    return energy;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
    StretchHistory::store(u, step.history);
    const PrincipalAxes<T> axes = find_principal_axes(u);
    FoamRelease<T> release{T(1), T(0)};
    if (has_hysteresis()) release = find_release(axes, step.history[StretchHistory::count]);
    FoamStress<T> stress(step.motion.volume_ratio);
    for (int i = 0; i < 3; ++i) {
      const auto nominal = find_nominal(axes.value[i]);
      stress.add(axes.direction[i], axes.value[i], {release.share * nominal.y, nominal.slope}, nominal.y, release);
    }
    stress.set(step);
  }

 private:
  KOKKOS_INLINE_FUNCTION bool has_hysteresis() const { return hysteretic_unloading < 1; }

  /// most: W_max, updated.
  template <class T>
  KOKKOS_INLINE_FUNCTION FoamRelease<T> find_release(const PrincipalAxes<T>& axes, T& most) const {
    const T energy = find_energy(axes.value[0]) + find_energy(axes.value[1]) + find_energy(axes.value[2]);
    return find_foam_release(energy, most, hysteretic_unloading, unloading_shape);
  }
};

}  // namespace percuss
