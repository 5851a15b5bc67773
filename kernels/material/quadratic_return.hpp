#pragma once
// Return to a quadratic yield surface, in the modes in which elasticity and the surface are both diagonal.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// A trial: the squared equivalent stress is the sum of the parts, each of which falls with the multiplier l by
/// 1 / (1 + rate l)^2; dp = l times the equivalent stress (Simo and Hughes 1998, section 3.4, for more modes).
template <class T, int modes>
struct QuadraticTrial {
  T part[modes];
  double rate[modes];

  /// The equivalent stress at l, and its derivative.
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_equivalent(const T& l) const {
    T square = T(0), fall = T(0);
    for (int k = 0; k < modes; ++k) {
      const T a = T(1) / (T(1) + T(rate[k]) * l), now = part[k] * a * a;
      square = square + now;
      fall = fall + T(rate[k]) * a * now;
    }
    const T equivalent = larger(square_root(square), T(1e-300));
    return {equivalent, T(0) - fall / equivalent};
  }
};

/// The multiplier with the equivalent stress on the flow stress; 0 where the trial is not above flow.at_rest.
template <class T, int modes, class Flow>
KOKKOS_INLINE_FUNCTION T find_multiplier(const QuadraticTrial<T, modes>& trial, const Flow& flow) {
  constexpr double next_to_molten = 1e-12;  // share of the trial's equivalent stress
  const T start = trial.find_equivalent(T(0)).value;
  const auto yields = start > flow.at_rest;
  if (!any(yields)) return T(0);
  double slowest = trial.rate[0];
  for (int k = 1; k < modes; ++k) slowest = smaller(slowest, trial.rate[k]);
  const T floor = select(yields, larger(flow.at_rest, T(next_to_molten) * start), T(1));
  const T high = select(yields, (start - floor) / (T(slowest) * floor), T(1));
  return find_falling_root(yields, high, start, [&](const T& l) {
    const ValueAndSlope<T> of = trial.find_equivalent(l);
    const FlowStress<T> now = flow(l * of.value);
    return ValueAndSlope<T>{of.value - now.value, of.slope - now.slope * (of.value + l * of.slope)};
  });
}

}  // namespace percuss
