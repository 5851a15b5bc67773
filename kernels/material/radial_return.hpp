#pragma once
// Radial return (Wilkins 1964; Krieg and Krieg 1977) for any flow stress that depends on the equivalent plastic strain
// and its rate: the return factor is the root of one scalar equation.

#include "kernels/material/elastic.hpp"
#include "kernels/material/point_step.hpp"

namespace percuss {

/// A function and its derivative.
template <class T>
struct ValueAndSlope {
  T value;
  T slope;
};

/// A plastic law whose flow stress start_flow() tells at the beginning of a step, from its history.
template <class Law>
concept FlowLaw = requires(const Law& law, const double* history) {
  law.start_flow(history, 1.0);
};

/// A law whose stress grows by increments, so that it may begin with any.
template <class Law>
concept GrowingLaw = FlowLaw<Law> || requires {
  requires Law::grows_in_increments;
};

/// A law that fibres of beams know.
template <class Law>
concept LawOfFibres = requires {
  requires Law::is_of_fibres;
};

/// Flow stress, and its derivative by dp at a given step (hardening and rate together).
template <class T>
using FlowStress = ValueAndSlope<T>;

/// The elastic trial of a step.
template <class T>
struct ElasticTrial {
  T mean;                  // stress
  Symmetric3<T> deviator;  // stress
  T von_mises;
};

template <class T>
KOKKOS_INLINE_FUNCTION Symmetric3<T> add_pressure(const Symmetric3<T>& deviator, const T& mean) {
  return deviator + Symmetric3<T>{mean, mean, mean, T(0), T(0), T(0)};
}

/// The elastic stress after the strain increment, from the one before.
template <class T>
KOKKOS_INLINE_FUNCTION ElasticTrial<T> find_trial(const LameConstants& c, const Symmetric3<T>& stress,
                                                  const Symmetric3<T>& de) {
  const Symmetric3<T> trial = add_pressure(stress + T(2 * c.mu) * de, T(c.lambda) * trace(de));
  const T mean = T(1.0 / 3.0) * trace(trial);
  const Symmetric3<T> deviator = add_pressure(trial, -mean);
  return {mean, deviator, square_root(T(1.5) * contract(deviator, deviator))};
}

/// Where f falls through 0 between 0 and `high`, of the lanes that are open; 0 of others. f(x): ValueAndSlope, not
/// positive at `high`; scale: what its value is small against. Newton's method from above, kept between bounds: where f
/// is convex, it comes down once and then rises to the root from one side. A lane stays as it is once it has converged,
/// so that its bits do not depend on its neighbours. Where f may rise or bend in between, each step number `Halving`
/// halves the bounds, which are then at round-off in any case; 0: none does.
template <int Halving = 0, class T, class Mask, class F>
KOKKOS_INLINE_FUNCTION T find_falling_root(const Mask& lanes, T high, const T& scale, const F& f) {
  constexpr int most_steps = Halving > 0 ? 53 * Halving + 1 : 60;
  constexpr double tolerance = 1e-13;
  T low = T(0), x = high;
  auto open = lanes;
  for (int i = 0; i < most_steps && any(open); ++i) {
    const ValueAndSlope<T> now = f(x);
    low = select(open && now.value > T(0), x, low);
    high = select(open && now.value <= T(0), x, high);
    const T newton = x - now.value / now.slope;
    T next = select(newton > low && newton < high, newton, T(0.5) * (low + high));
    if constexpr (Halving > 0) {
      if (i % Halving == Halving - 1) next = T(0.5) * (low + high);
    }
    open = open && larger(now.value, -now.value) > T(tolerance) * scale && high - low > T(1e-15) * high;
    x = select(open, next, x);
  }
  return select(lanes, x, T(0));
}

/// Whether the flow stress may fall with dp; it then names its lowest value.
template <class Flow>
inline constexpr bool may_fall = requires(const Flow& flow) {
  flow.lowest;
};

/// Halving of find_falling_root() for a flow stress.
template <class Flow>
inline constexpr int halving_of = may_fall<Flow> ? 3 : 0;

/// What the flow stress does not fall below, whatever dp.
template <class Flow>
KOKKOS_INLINE_FUNCTION const auto& find_floor(const Flow& flow) {
  if constexpr (may_fall<Flow>)
    return flow.lowest;
  else
    return flow.at_rest;
}

/// The plastic increment dp >= 0 with von_mises - resistance dp = flow(dp).value, where von_mises > flow(0).value; 0
/// elsewhere. resistance: 3 mu.
template <class T, class Flow>
KOKKOS_INLINE_FUNCTION T find_plastic_increment(const T& von_mises, double resistance, const Flow& flow) {
  const auto yields = von_mises > flow.at_rest;
  if (!any(yields)) return T(0);
  const T high = select(yields, (von_mises - find_floor(flow)) * T(1 / resistance), T(1));
  return find_falling_root<halving_of<Flow>>(yields, high, von_mises, [&](const T& dp) {
    const FlowStress<T> now = flow(dp);
    return ValueAndSlope<T>{von_mises - T(resistance) * dp - now.value, -(T(resistance) + now.slope)};
  });
}

/// The stress after a rise of temperature, which strains by `expansion` a degree what may move.
template <class T>
KOKKOS_INLINE_FUNCTION void expand(const LameConstants& c, double expansion, const T& rise, Symmetric3<T>& stress) {
  if (expansion > 0) stress = add_pressure(stress, T(-expansion * (3 * c.lambda + 2 * c.mu)) * rise);
}

/// Sets the stress and what the element has to know from the trial and dp.
template <class T>
KOKKOS_INLINE_FUNCTION void return_stress(const ElasticTrial<T>& trial, double resistance, const T& dp,
                                          const T& flow_stress, PointStep<T>& step) {
  const T share = T(1) - T(resistance) * dp / larger(trial.von_mises, T(1e-300));
  step.stress = add_pressure(share * trial.deviator, trial.mean);
  const T ratio = share * trial.von_mises / larger(flow_stress, T(1e-300));
  step.plastic = {share, flow_stress, smaller(ratio * ratio, T(1))};
}

/// The update of a material whose flow stress depends on p, which is history[0], its rate, and the rest of its history:
/// start_flow(history, dt) is that of a step (RateFlow in rate_hardening.hpp). Some heat themselves.
template <class T, class Material>
KOKKOS_INLINE_FUNCTION void return_by_isotropic_hardening(const Material& m, PointStep<T>& step) {
  const LameConstants c = m.moduli();
  const double resistance = 3 * c.mu;
  const ElasticTrial<T> trial = find_trial(c, step.stress, step.motion.de);
  const auto flow = m.start_flow(step.history, step.motion.dt);
  const T dp = find_plastic_increment(trial.von_mises, resistance, flow);
  const T flow_stress = larger(trial.von_mises - T(resistance) * dp, flow.at_rest);
  step.history[0] = step.history[0] + dp;
  if constexpr (requires { m.heat(step.history, dp, dp, 1.0); }) {
    const Symmetric3<T> deviator = add_pressure(step.stress, T(-1.0 / 3.0) * trace(step.stress));
    // Where the point begins to yield within the step, plastic strain begins at the yield stress.
    const T before = larger(square_root(T(1.5)) * square_root(contract(deviator, deviator)), flow.at_rest);
    m.heat(step.history, dp, step.motion.middle_volume_ratio() * (T(0.5) * (before + flow_stress)), step.density);
  }
  return_stress(trial, resistance, dp, flow_stress, step);
}

}  // namespace percuss
