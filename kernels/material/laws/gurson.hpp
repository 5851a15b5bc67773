#pragma once
// Metal with voids that grow, nucleate and coalesce: Gurson's surface as Tvergaard and Needleman changed it.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// (q/Y)^2 + 2 q1 g cosh(3 q2 P / (2 Y)) - 1 - q3 g^2 = 0, with von Mises stress q, mean stress P (tension), the yield
/// stress Y(p) of the metal between the voids, and g(f): the void fraction f, above the critical one steeper by voids
/// that coalesce (Gurson, J. Eng. Mater. Technol. 99, 2, 1977; Tvergaard and Needleman, Acta Metall. 32, 157, 1984).
/// Flow is normal to it; (1 - f) Y dp = stress : dep; df = (1 - f) tr(dep) + A(p) dp, A a normal distribution (Chu and
/// Needleman, J. Eng. Mater. Technol. 102, 249, 1980). Stress and p are those of backward Euler (Aravas, Int. J. Numer.
/// Methods Eng. 24, 1395, 1987) with the f of the start of the step. History: p, f, and 0 once f has reached that of
/// failure, else 1.
struct Gurson {
  static constexpr const char* name = "gurson";
  static constexpr double rounding = 1e-9;  // share of a q3 that is meant to be the square of q1
  static constexpr int halving = 8;         // the equations fall, but may bend (find_falling_root)
  static constexpr bool grows_in_increments = true;
  using Constants = Gurson;
  double youngs_modulus = 0, poissons_ratio = 0;
  MaterialTable hardening;
  double q1 = 1.5, q2 = 1, q3 = 2.25;
  double void_fraction = 0, critical_void_fraction = 1, failure_void_fraction = 1;
  double nucleation_fraction = 0, nucleation_strain = 0, nucleation_deviation = 0.1;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = Gurson;
    return join_keys(
        with_elastic_keys<M>(
            need("hardening", &M::hardening, KeyRange::positive, "-, pressure",
                 "Yield stress of the metal between the voids over its equivalent plastic strain; level before the "
                 "first and after the last row."),
            may("q1", &M::q1, KeyRange::positive, "-", "Tvergaard's factor of the void fraction."),
            may("q2", &M::q2, KeyRange::positive, "-", "Tvergaard's factor of the mean stress."),
            may("q3", &M::q3, KeyRange::positive, "-", "Tvergaard's factor of the squared void fraction; mostly q1^2."),
            may("void_fraction", &M::void_fraction, KeyRange::share, "-", "Void volume over volume at the start."),
            may("critical_void_fraction", &M::critical_void_fraction, KeyRange::share, "-",
                "Void fraction from which on voids coalesce."),
            may("failure_void_fraction", &M::failure_void_fraction, KeyRange::share, "-",
                "Void fraction at which no strength is left and the element erodes."),
            may("nucleation_fraction", &M::nucleation_fraction, KeyRange::share, "-",
                "Void fraction that plastic strain nucleates in all."),
            may("nucleation_strain", &M::nucleation_strain, KeyRange::not_negative, "-",
                "Mean plastic strain at which voids nucleate."),
            may("nucleation_deviation", &M::nucleation_deviation, KeyRange::positive, "-",
                "Standard deviation of that strain.")),
        rate_keys<M>());
  }
  const char* find_fault() const {
    if (void_fraction >= critical_void_fraction) return "a void_fraction that is not below critical_void_fraction";
    if (critical_void_fraction < 1 && failure_void_fraction <= critical_void_fraction)
      return "a failure_void_fraction that is not above critical_void_fraction";
    if (q3 > q1 * q1 * (1 + rounding)) return "a q3 above the square of q1, with which voids never take all strength";
    return q1 * void_fraction < 1 ? "" : "voids that leave no strength at the start (q1 void_fraction is 1 or more)";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain,
                                                    HistoryScalar::void_fraction, HistoryScalar::remains};
  static constexpr int history_count = 3;
  void start(double* history) const { history[1] = void_fraction, history[2] = 1; }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const auto row = hardening(p);
    return {row.y, row.slope};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants c = moduli();
    T &p = step.history[0], &f = step.history[1], &remains = step.history[2];
    const ElasticTrial<T> trial = find_trial(c, step.stress, step.motion.de);
    const Voids<T> voids{*this, {c.lambda + 2.0 / 3.0 * c.mu, 3 * c.mu}, find_effective(f), trial};
    const auto flow = start_rate_flow(*this, step.history, step.motion.dt);
    const T dp = find_increment(voids, f, flow);
    const T yield = larger(flow(dp).value, T(1e-300));
    const Return<T> to = voids.return_to(yield);
    step.stress = add_pressure((to.von_mises / larger(trial.von_mises, T(1e-300))) * trial.deviator, to.mean);
    const T strength = yield * square_root(larger(voids.find_square(to.mean, yield), T(1e-24)));
    const T ratio = to.von_mises / strength;
    step.plastic = {select(dp > T(0), to.von_mises / larger(trial.von_mises, T(1e-300)), T(1)), strength,
                    smaller(ratio * ratio, T(1))};
    const T grown = (T(1) - f) * to.volume + nucleate(p + T(0.5) * dp) * dp;
    f = smaller(larger(f + grown, T(0)), T(failure_void_fraction));
    p = p + dp;
    remains = select(f >= T(failure_void_fraction), T(0), remains);
  }

 private:
  struct Stiffness {
    double bulk, deviatoric;  // K, 3 mu
  };

  /// Where a trial returns to for one yield stress, and the plastic strain: its trace and its deviatoric part.
  template <class T>
  struct Return {
    T mean, von_mises, volume, shape;

    KOKKOS_INLINE_FUNCTION T work() const { return mean * volume + von_mises * shape; }
  };

  /// The surface at one void fraction, about a trial.
  template <class T>
  struct Voids {
    const Gurson& law;
    Stiffness stiffness;
    T effective;
    const ElasticTrial<T>& trial;

    /// What 3 q2 P / (2 Y) is bounded by, so that its cosh is finite.
    KOKKOS_INLINE_FUNCTION T find_angle(const T& mean, const T& yield) const {
      return smaller(larger(mean, -mean) * T(1.5 * law.q2) / yield, T(600));
    }

    /// (q/Y)^2 on the surface; negative where there is none at this mean stress.
    KOKKOS_INLINE_FUNCTION T find_square(const T& mean, const T& yield) const {
      return square_at(exponential(find_angle(mean, yield)));
    }
    KOKKOS_INLINE_FUNCTION T square_at(const T& exp) const {
      return T(1) + effective * (T(law.q3) * effective - T(law.q1) * (exp + T(1) / exp));
    }

    /// The root of normality between P = 0 and the trial's: 2 q tr(dep) = 3 q1 q2 g Y sinh(angle) (q_trial - q) / (3
    /// mu).
    KOKKOS_INLINE_FUNCTION Return<T> return_to(const T& yield) const {
      const T square = find_square(trial.mean, yield);
      const auto outside = trial.von_mises * trial.von_mises > yield * yield * square;
      if (!any(outside)) return {trial.mean, trial.von_mises, T(0), T(0)};
      // cosh(angle) where the surface ends at q = 0
      const T end = (T(1) + T(law.q3) * effective * effective) / larger(T(2 * law.q1) * effective, T(1e-250));
      const T last = logarithm(end + square_root(larger(end * end - T(1), T(0))));
      const T size = larger(trial.mean, -trial.mean), high = smaller(find_angle(trial.mean, yield), last);
      const T per_angle = yield * T(1 / (1.5 * law.q2)),
              scale = yield * (size * T(1 / stiffness.bulk) + trial.von_mises * T(1 / stiffness.deviatoric));
      const auto porous = outside && effective > T(0);  // without voids nothing pulls the volume, not even round-off
      const T angle = find_falling_root<halving>(porous, select(porous, high, T(1)), scale, [&](const T& at) {
        const T exp = exponential(at), sinh = T(0.5) * (exp - T(1) / exp), cosh = T(0.5) * (exp + T(1) / exp);
        const T q = yield * square_root(larger(square_at(exp), T(0)));
        const T volume = (size - per_angle * at) * T(1 / stiffness.bulk);
        const T shape = (trial.von_mises - q) * T(1 / stiffness.deviatoric);
        const T pull = T(3 * law.q1 * law.q2) * effective * yield;
        const T q_slope = T(-law.q1) * effective * yield * yield * sinh / larger(q, T(1e-8) * yield);
        return ValueAndSlope<T>{T(2) * q * volume - pull * sinh * shape,
                                T(2) * (q_slope * volume - q * per_angle * T(1 / stiffness.bulk)) -
                                    pull * (cosh * shape - sinh * q_slope * T(1 / stiffness.deviatoric))};
      });
      const T mean = select(trial.mean < T(0), -per_angle * angle, per_angle * angle);
      const T q = smaller(yield * square_root(larger(square_at(exponential(angle)), T(0))), trial.von_mises);
      return {select(porous, mean, trial.mean), select(outside, q, trial.von_mises),
              select(porous, (trial.mean - mean) * T(1 / stiffness.bulk), T(0)),
              select(outside, (trial.von_mises - q) * T(1 / stiffness.deviatoric), T(0))};
    }
  };

  /// g(f): above the critical fraction it rises to where it leaves no strength at that of failure.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_effective(const T& f) const {
    const double last =
        (q1 + sqrt(larger(q1 * q1 - q3, 0.0))) / q3;  // q1 g - 1 = q3 g^2 - q1 g: the surface is a point
    if (critical_void_fraction >= 1) return smaller(f, T(0.999 * last));
    const double steeper = (last - critical_void_fraction) / (failure_void_fraction - critical_void_fraction);
    const T above = larger(f - T(critical_void_fraction), T(0));
    return smaller(f - above + T(steeper) * above, T(0.999 * last));
  }

  /// A(p).
  template <class T>
  KOKKOS_INLINE_FUNCTION T nucleate(const T& p) const {
    if (nucleation_fraction == 0) return T(0);
    const T off = (p - T(nucleation_strain)) * T(1 / nucleation_deviation);
    return T(nucleation_fraction / (nucleation_deviation * 2.5066282746310002)) * exponential(T(-0.5) * off * off);
  }

  /// dp with stress : dep = (1 - f) Y(dp) dp; 0 where the trial is elastic.
  template <class T, class Flow>
  KOKKOS_INLINE_FUNCTION T find_increment(const Voids<T>& voids, const T& f, const Flow& flow) const {
    const ElasticTrial<T>& trial = voids.trial;
    const T square = voids.find_square(trial.mean, flow.at_rest);
    const auto yields = trial.von_mises * trial.von_mises > flow.at_rest * flow.at_rest * square;
    if (!any(yields)) return T(0);
    const T solid = T(1) - f;
    const auto find_excess = [&](const T& dp) {
      const FlowStress<T> now = flow(dp);
      const Return<T> to = voids.return_to(now.value);
      return ValueAndSlope<T>{
          to.work() - solid * now.value * dp,
          -solid * (now.value + now.slope * dp) - now.slope * to.von_mises * T(1 / voids.stiffness.deviatoric)};
    };
    // dp without hardening, which with hardening is too large and mostly near; else all work of the trial
    const T near = T(1 + rounding) * voids.return_to(flow.at_rest).work() / (solid * flow.at_rest);
    const T most = trial.mean * trial.mean * T(1 / voids.stiffness.bulk) +
                   trial.von_mises * trial.von_mises * T(1 / voids.stiffness.deviatoric);
    const auto is_bound = find_excess(near).value <= T(0);
    const T high = select(yields, select(is_bound, near, most / (solid * T(find_lowest_yield()))), T(1));
    return find_falling_root<halving>(yields, high, select(yields, most, T(1)), find_excess);
  }

  KOKKOS_INLINE_FUNCTION double find_lowest_yield() const {
    double lowest = hardening.y[0];
    for (int i = 1; i < hardening.rows; ++i) lowest = hardening.y[i] < lowest ? hardening.y[i] : lowest;
    return lowest;
  }
};

}  // namespace percuss
