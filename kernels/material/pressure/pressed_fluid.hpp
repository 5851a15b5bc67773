#pragma once
// Fluids under pressure at time 0: compressed from their start along the adiabat of their equation of state. On the
// host.

#include "kernels/material/pressure/equation_of_state.hpp"

namespace percuss {

/// J = V / V(0) and the internal energy e per volume at the start.
struct PressedFluid {
  double j = 1, energy = 0;
};

template <class State>
StatePressure<double> find_pressure(const State& state, double density, const PressedFluid& at) {
  return state(at.j, at.energy, StatePoint<double>{density, 0, 1, 1});
}

/// Follows the adiabat de = -p dJ while s goes from 0 to 1. rise(J): dp/ds. By Runge and Kutta's fourth-order method.
template <class State, class Rise>
PressedFluid press(const State& state, double density, PressedFluid at, const Rise& rise) {
  constexpr int steps = 16;
  constexpr double h = 1.0 / steps;
  const auto find_slope = [&](const PressedFluid& of) -> PressedFluid {
    const StatePressure<double> p = find_pressure(state, density, of);
    const double dj = rise(of.j) / (p.by_volume - p.pressure * p.by_energy);
    return {dj, -p.pressure * dj};
  };
  const auto go = [](const PressedFluid& from, double share, const PressedFluid& slope) -> PressedFluid {
    return {from.j + share * slope.j, from.energy + share * slope.energy};
  };
  for (int i = 0; i < steps; ++i) {
    const PressedFluid a = find_slope(at), b = find_slope(go(at, h / 2, a)), c = find_slope(go(at, h / 2, b)),
                       d = find_slope(go(at, h, c));
    at = go(go(go(go(at, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  return at;
}

/// From the start to this pressure: what the method leaves is followed again.
template <class State>
PressedFluid press_to(const State& state, double density, double pressure) {
  constexpr int times = 3;
  PressedFluid at{1, state.find_start_energy()};
  for (int i = 0; i < times; ++i) {
    const double missing = pressure - find_pressure(state, density, at).pressure;
    if (missing == 0) break;
    at = press(state, density, at, [&](double) { return missing; });
  }
  return at;
}

}  // namespace percuss
