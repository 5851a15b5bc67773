#pragma once
// Fluids under pressure at time 0: compressed from their start along the adiabat of their equation of state. On the
// host.

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The volume and energy of a fluid along its adiabat de = -p dJ.
template <class State>
class Adiabat {
 public:
  Adiabat(const State& state, double density) : state_(state), density_(density) {}

  PressedFluid start() const { return {1, state_.find_start_energy()}; }
  double find_pressure(const PressedFluid& at) const { return percuss::find_pressure(state_, density_, at).pressure; }
  /// -dp/dJ.
  double find_stiffness(const PressedFluid& at) const {
    const StatePressure<double> p = percuss::find_pressure(state_, density_, at);
    return p.pressure * p.by_energy - p.by_volume;
  }

  /// To the pressure p from where it is `pressure`, by Newton's method between bounds; the energy by the trapezoid with
  /// the slopes of both ends. J is not a number where no volume on the way has this pressure.
  PressedFluid go_to(const PressedFluid& from, double pressure) const {
    constexpr int most_tries = 100;
    constexpr double none = std::numeric_limits<double>::quiet_NaN(), most_change = 0.2, round_off = 4e-16,
                     negligible = 1e-13;
    const double p = find_pressure(from), slope = find_stiffness(from);
    double low = 0, high = std::numeric_limits<double>::infinity();
    PressedFluid at = from;
    for (int i = 0; i < most_tries; ++i) {
      const double stiffness = find_stiffness(at), missing = pressure - find_pressure(at);
      if (!(stiffness > 0)) break;
      if (std::fabs(missing) <= round_off * stiffness * at.j) return at;
      (missing > 0 ? high : low) = at.j;
      const double most = most_change * at.j;
      double j = at.j - std::clamp(missing / stiffness, -most, most);
      if (!(j > low && j < high)) j = 0.5 * (low + high);
      if (j == at.j || (i > most_tries / 2 && std::fabs(missing) <= negligible * stiffness)) return at;
      const double change = j - from.j;
      // The slope of the end is that of the last place: it counts with the square of the change.
      at = {j, from.energy - change * (0.5 * (p + pressure) + change / 12 * (find_stiffness({j, at.energy}) - slope))};
    }
    return {none, none};
  }

 private:
  State state_;
  double density_;
};

/// From the start to this pressure, and from there down a depth with dp/ds = weight / J, s from 0 to 1; weight:
/// density g depth. By Runge and Kutta's fourth-order method for p, which has no kinks where the equation of state has
/// some. J is not a number where the fluid cannot have such pressures.
template <class State>
PressedFluid press(const State& state, double density, double pressure, double weight) {
  const Adiabat<State> adiabat(state, density);
  PressedFluid at = adiabat.start();
  const double first = adiabat.find_pressure(at);
  const double change = (std::fabs(pressure - first) + std::fabs(weight)) / adiabat.find_stiffness(at);
  const int steps = change < 0.16 ? std::max(4, static_cast<int>(400 * change)) : 64;
  for (int i = 1; i <= steps; ++i) at = adiabat.go_to(at, first + i * (pressure - first) / steps);
  const double h = weight / steps;
  double p = pressure;
  for (int i = 0; i < steps; ++i) {
    const double a = h / at.j, b = h / adiabat.go_to(at, p + a / 2).j, c = h / adiabat.go_to(at, p + b / 2).j,
                 d = h / adiabat.go_to(at, p + c).j;
    p += (a + 2 * b + 2 * c + d) / 6;
    at = adiabat.go_to(at, p);
  }
  return at;
}

}  // namespace percuss
