#pragma once
// Low-density foam: each principal stretch has its own stress, from one curve of a uniaxial test.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Nominal stress in each principal direction of U, without coupling: f(1 - stretch) in compression, from the table,
/// and youngs_modulus (stretch - 1) in tension; Cauchy stress is stretch / J times that. No hysteresis. History: U.
struct LowDensityFoam {
  static constexpr const char* name = "low_density_foam";
  using Constants = LowDensityFoam;
  double youngs_modulus = 0;
  MaterialTable compression;

  static constexpr auto keys() {
    using M = LowDensityFoam;
    return std::array{
        need("youngs_modulus", &M::youngs_modulus, KeyRange::positive, "pressure", "Young's modulus."),
        need("compression", &M::compression, KeyRange::not_negative, "-, pressure",
             "Nominal stress over nominal strain of a uniaxial compression, both positive, from [0, 0] on; its last "
             "slope goes on.")};
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

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  /// At rest, without lateral strain.
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

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
    StretchHistory::store(u, step.history);
    const PrincipalAxes<T> axes = find_principal_axes(u);
    const T over_j = T(1) / step.motion.volume_ratio;
    T stiffest(0), largest(0);
    Symmetric3<T> stress{T(0), T(0), T(0), T(0), T(0), T(0)};
    for (int i = 0; i < 3; ++i) {
      const T stretch = axes.value[i];
      const auto nominal = find_nominal(stretch);
      const Vector3<T>& n = axes.direction[i];
      const T cauchy = nominal.y * stretch * over_j;
      stress = stress + cauchy * Symmetric3<T>{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
      stiffest = larger(stiffest, nominal.slope * stretch * stretch * over_j);
      largest = larger(largest, larger(cauchy, -cauchy));
    }
    step.stress = stress;
    // The stiffest direction bounds |sym L|; what stresses do to shear is bounded by the largest of them.
    step.lambda = T(0);
    step.mu = T(0.5) * stiffest + largest;
  }
};

}  // namespace percuss
