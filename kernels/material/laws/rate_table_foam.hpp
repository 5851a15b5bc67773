#pragma once
// Foam with curves for several rates: each principal stretch has its own stress, less of it on the way back.

#include <limits>

#include "kernels/material/foam_stress.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/principal_stretches.hpp"

namespace percuss {

/// Nominal stress in each principal direction of U, without coupling, of the strain e = 1 - stretch: g f(e) + q, f the
/// curve of the lowest rate, g its release (foam_stress.hpp, with a further exponent) and q the overstress of the rate.
/// Where |e| grows at a rate r, q tends to Q(e, r), what the curves have above f at r; else to 0 (the unloading curve
/// of low-density foams in the DYNA3D line is that of the lowest rate). It moves by at most K |de| a step, K the
/// steepest growth of any Q at e and Young's modulus, and relaxes by K R(e, q) dt more, R the rate whose Q is q. K
/// depends on e alone: without slip q would be an energy, and slip only lowers it, so that closed paths give nothing.
/// Tension: youngs_modulus |e|, level at the cutoff, or the curves where they have rows below 0.
/// History: U, the tensor with the values q, W_max, whether tension has failed.
struct RateTableFoam {
  static constexpr const char* name = "rate_table_foam";
  static constexpr bool is_stretched_far = true;  // as what stores energy is
  using Constants = RateTableFoam;
  double youngs_modulus = 0;
  double hysteretic_unloading = 1, unloading_shape = 1, unloading_exponent = 1;
  double tension_cutoff = 0;  // 0: none
  RateCurves compression;
  bool logarithmic = false, engineering = false, of_volume = false, fails = false;

  static constexpr auto keys() {
    using M = RateTableFoam;
    return std::array{
        need("youngs_modulus", &M::youngs_modulus, KeyRange::positive, "pressure", "Young's modulus."),
        need("compression_at_rates", &M::compression, KeyRange::any, "1 / time, -, pressure",
             "For each strain rate, ascending, nominal stress over nominal strain of a uniaxial test, both positive in "
             "compression, through [0, 0]; the slopes of the ends go on."),
        may("rate_interpolation", &M::logarithmic, "linear", "logarithmic",
            "Between two rates the stress is straight over the rate or over its logarithm."),
        may("rate_measure", &M::engineering, "logarithmic", "engineering",
            "Rate of the curves: of the logarithmic or of the nominal strain."),
        may("rate_of", &M::of_volume, "direction", "volume",
            "Whose rate counts in a principal direction: its own, or that of the volume."),
        may("hysteretic_unloading", &M::hysteretic_unloading, KeyRange::share, "-",
            "Share h of the stress that is left at the end of a release: 1 - (1 - h) (1 - (W / W_max)^s)^n of it is "
            "left at the stored energy W; 1: no hysteresis but that of the rates."),
        may("unloading_shape", &M::unloading_shape, KeyRange::positive, "-",
            "Exponent s of the release; see hysteretic_unloading."),
        may("unloading_exponent", &M::unloading_exponent, KeyRange::positive, "-",
            "Exponent n of the release, at least 1; see hysteretic_unloading."),
        may("tension_cutoff", &M::tension_cutoff, KeyRange::not_negative, "pressure",
            "Largest tensile stress; 0: no limit."),
        may("after_cutoff", &M::fails, "held", "none", "Tensile stress of a point that has reached tension_cutoff.")};
  }
  const char* find_fault() const;

  static constexpr int history_count = 2 * StretchHistory::count + 2;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION bool has_tension_rows() const { return compression.x[0] < 0; }

  /// Moduli at rest, without lateral strain: the steepest of all curves, and what the overstress may add.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    double steepest = 0;
    for (int k = 0; k < compression.rates; ++k)
      steepest = larger(steepest, larger(find_line(k, 0.0).slope, find_line(k, -1e-12).slope));
    return {0, 0.5 * (compression.rates > 1 ? steepest + youngs_modulus : larger(steepest, youngs_modulus))};
  }

  /// Curve k, positive in compression; its first and last slope continue.
  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_line(int k, const T& strain) const {
    const int first = compression.first[k], last = compression.first[k + 1] - 1;
    ValueAndSlope<T> line{T(0), T(0)};
    for (int i = first; i < last; ++i) {
      const auto past = strain >= T(i == first ? -std::numeric_limits<double>::infinity() : compression.x[i]);
      if (!any(past)) break;
      const double slope = (compression.y[i + 1] - compression.y[i]) / (compression.x[i + 1] - compression.x[i]);
      line.value = select(past, T(compression.y[i]) + T(slope) * (strain - T(compression.x[i])), line.value);
      line.slope = select(past, T(slope), line.slope);
    }
    return line;
  }

  /// f and its slope, positive in compression; has_failed: 1 or 0.
  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_static(const T& strain, const T& has_failed) const {
    ValueAndSlope<T> line = find_line(0, strain);
    if (has_tension_rows()) return line;
    const auto pulled = strain < T(0);
    T pull = T(-youngs_modulus) * strain;
    if (tension_cutoff > 0) pull = smaller(pull, T(tension_cutoff)) * (T(1) - has_failed);
    return {select(pulled, -pull, line.value), select(pulled, T(youngs_modulus), line.slope)};
  }

  /// Area below f from 0 to there: energy per volume at the start.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_energy(const T& strain, const T& has_failed) const {
    const int last = compression.first[1] - 1;
    T energy(0);
    for (int i = 0; i < last; ++i) {
      const double low = compression.x[i], high = compression.x[i + 1], width = high - low;
      const double y = compression.y[low < 0 ? i + 1 : i], slope = (compression.y[i + 1] - compression.y[i]) / width;
      // from the end nearer to 0
      T within = low < 0 ? smaller(strain - T(high), T(0)) : larger(strain - T(low), T(0));
      if (low >= 0 && i + 1 < last) within = smaller(within, T(width));
      if (low < 0 && i > 0) within = larger(within, T(-width));
      energy = energy + within * (T(y) + T(0.5 * slope) * within);
    }
    if (has_tension_rows()) return energy;
    const T pull = larger(-strain, T(0));
    T within = pull;
    if (tension_cutoff > 0) within = smaller(pull, T(tension_cutoff / youngs_modulus));
    const T stored = T(youngs_modulus) * within * (pull - T(0.5) * within);
    return energy + (tension_cutoff > 0 ? stored * (T(1) - has_failed) : stored);
  }

  /// Where a direction is at n+1, and how it gets there.
  template <class T>
  struct Motion {
    T strain, change;  // e, and what it gains in the step
    T rate;            // of |e|, as the curves have it
    T dt;
  };

  /// What the rate adds: magnitudes, on the side of e.
  template <class T>
  struct Overstress {
    T target;    // Q(e, r)
    T modulus;   // K
    T own_rate;  // R(e, q)
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION Overstress<T> find_overstress(const Motion<T>& motion, const T& q) const {
    const T side = select(motion.strain < T(0), T(-1), T(1));
    const ValueAndSlope<T> base = find_line(0, motion.strain);
    Overstress<T> over{T(0), T(0), T(compression.rate[0])};
    T below(0);  // Q of curve k
    for (int k = 0; k + 1 < compression.rates; ++k) {
      const ValueAndSlope<T> line = find_line(k + 1, motion.strain);
      const T above = side * (line.value - base.value), more = above - below;
      over.target = over.target + find_share(k, motion.rate) * more;
      over.modulus = larger(over.modulus, line.slope - base.slope);
      const T part = (q - below) / larger(more, T(1e-300));
      const double gap = compression.rate[k + 1] - compression.rate[k];
      over.own_rate = over.own_rate + T(gap) * larger(T(0), smaller(T(1), part));
      below = above;
    }
    over.target = larger(over.target, T(0));
    over.modulus = over.modulus + T(youngs_modulus);
    return over;
  }

  /// q at n+1 from q at n, and its slope.
  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> advance_overstress(const Motion<T>& motion, const T& before) const {
    if (compression.rates < 2) return {T(0), T(0)};
    const auto pulled = motion.strain < T(0);
    const T q = larger(select(pulled, -before, before), T(0));
    const Overstress<T> over = find_overstress(motion, q);
    const T size = larger(motion.change, -motion.change);
    const T target = select(motion.strain * motion.change > T(0), over.target, T(0));
    const T least = larger(q - over.modulus * (size + over.own_rate * motion.dt), T(0));
    T now = larger(least, smaller(target, q + over.modulus * size)), slope = over.modulus;
    if (!has_tension_rows()) {
      now = select(pulled, T(0), now);
      slope = select(pulled, T(0), slope);
    }
    return {select(pulled, -now, now), slope};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const PrincipalAxes<T> axes = advance_principal_stretches(step);
    T* history = step.history + StretchHistory::count;
    const Symmetric3<T> before = StretchHistory::load(history);
    T &most = history[StretchHistory::count], &has_failed = history[StretchHistory::count + 1];
    if (fails) has_failed = find_failure(axes, has_failed);
    const FoamRelease<T> release = find_release(axes, most, has_failed);
    FoamStress<T> stress(step.motion.volume_ratio);
    Symmetric3<T> after{T(0), T(0), T(0), T(0), T(0), T(0)};
    for (int i = 0; i < 3; ++i) {
      const Vector3<T>& n = axes.direction[i];
      const Symmetric3<T> direction{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
      const T strain = T(1) - axes.value[i];
      const Motion<T> motion = find_motion(step.motion, axes.value[i], contract(step.motion.de, direction));
      const ValueAndSlope<T> base = find_static(strain, has_failed);
      const ValueAndSlope<T> over = advance_overstress(motion, contract(before, direction));
      after = after + over.value * direction;
      const T curve = -base.value;
      stress.add(n, axes.value[i], {release.share * curve - over.value, base.slope + over.slope}, curve, release);
    }
    StretchHistory::store(after, history);
    stress.set(step);
  }

 private:
  /// growth: of the logarithm of the stretch in the step.
  template <class T>
  KOKKOS_INLINE_FUNCTION Motion<T> find_motion(const PointMotion<T>& point, const T& stretch, const T& growth) const {
    const T strain = T(1) - stretch, change = -stretch * growth * (T(1) - T(0.5) * growth);
    T shortening = -growth;
    if (of_volume) shortening = -trace(point.de);
    if (engineering) shortening = shortening * (of_volume ? point.volume_ratio : stretch);
    const T rate = shortening / larger(point.dt, T(1e-300));
    return {strain, change, select(strain < T(0), -rate, rate), point.dt};
  }

  /// How far a rate is from rate k to the next, within 0 to 1.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_share(int k, const T& rate) const {
    const double low = compression.rate[k], high = compression.rate[k + 1];
    const T inside = smaller(larger(rate, T(low)), T(high));
    if (!logarithmic) return (inside - T(low)) * T(1 / (high - low));
    return logarithm(inside * T(1 / low)) * T(1 / logarithm(high / low));
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION T find_failure(const PrincipalAxes<T>& axes, T has_failed) const {
    for (const T& stretch : axes.value)
      has_failed = select(T(youngs_modulus) * (stretch - T(1)) >= T(tension_cutoff), T(1), has_failed);
    return has_failed;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION FoamRelease<T> find_release(const PrincipalAxes<T>& axes, T& most, const T& has_failed) const {
    if (!(hysteretic_unloading < 1)) return {T(1), T(0)};
    T energy(0);
    for (const T& stretch : axes.value) energy = energy + find_energy(T(1) - stretch, has_failed);
    most = larger(most, energy);
    const FoamRelease<T> plain = find_foam_release(energy, most, 0, unloading_shape);  // its share: (W / W_max)^s
    const double lost = 1 - hysteretic_unloading, n = unloading_exponent;
    if (n == 1) return {T(1) - T(lost) * (T(1) - plain.share), T(lost) * plain.steepness};
    const T gone = larger(T(1) - plain.share, T(1e-30));
    return {T(1) - T(lost) * power(gone, n), T(lost * n) * power(gone, n - 1) * plain.steepness};
  }
};

inline const char* RateTableFoam::find_fault() const {
  const bool pulls = has_tension_rows();
  for (int k = 0; k < compression.rates; ++k) {
    const int first = compression.first[k], last = compression.first[k + 1] - 1;
    bool has_origin = false;
    for (int i = first; i <= last; ++i) {
      const double x = compression.x[i], y = compression.y[i];
      has_origin = has_origin || (x == 0 && y == 0);
      if (x * y < 0 || (x == 0 && y != 0)) return "a curve whose stress has not the sign of its strain";
      if (k == 0 && i > first && y < compression.y[i - 1]) return "a curve of the lowest rate whose stress falls";
    }
    if (!has_origin) return "a curve without the row [0, 0]";
    if (compression.x[last] <= 0) return "a curve without a row of compression";
    if ((compression.x[first] < 0) != pulls) return "rows of tension in some curves and not in others";
  }
  if (logarithmic && compression.rate[0] <= 0) return "logarithmic rate_interpolation beside a rate of 0";
  if (unloading_exponent < 1) return "an unloading_exponent below 1";
  if (tension_cutoff > 0 && pulls) return "a tension_cutoff beside curves with rows of tension";
  if (fails && !(tension_cutoff > 0)) return "after_cutoff without a tension_cutoff";
  return "";
}

}  // namespace percuss
