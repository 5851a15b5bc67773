#pragma once
// The list of equations of state, and how one takes the place of a law's own pressure.

#include "kernels/material/pressure/equation_of_state.hpp"
#include "kernels/material/pressure/jwl_state.hpp"
#include "kernels/material/pressure/tillotson_state.hpp"
#include "kernels/material/radial_return.hpp"
#include "kernels/material/type_list.hpp"

namespace percuss {

using EquationsOfState =
    TypeList<LinearState, MieGrueneisenState, PolynomialState, IdealGasState, TillotsonState, JwlState, TabulatedState>;

/// History of an equation of state: e, J, and the lighting time of an explosive.
inline constexpr int state_history_count = 3;

/// Adiabatic bulk modulus at the start.
template <class State>
double find_start_modulus(const State& state, double density) {
  const StatePressure<double> start = state(1.0, state.find_start_energy(), StatePoint<double>{density, 0, 1, 1});
  return start.pressure * start.by_energy - start.by_volume;
}

/// Its history at the start. x: center of the element.
template <class State>
void start_state(const State& state, double* history, const double (&x)[3]) {
  history[0] = state.find_start_energy();
  history[1] = 1;
  history[2] = 0;
  if constexpr (requires { State::is_lit; }) history[2] = state.find_lighting_time(x);
}

/// Replaces the law's mean stress by the pressure at n+1, and updates its energy. old: stress at n; history: e, J,
/// lighting time; least_bulk: least modulus that is returned.
template <class T, class State>
PERCUSS_NO_INLINE StateChange<T> advance_state(const State& state, const Symmetric3<T>& old, T* history,
                                               double least_bulk, PointStep<T>& step) {
  constexpr int most_steps = 20;
  constexpr double tolerance = 1e-12;  // share of the pressures and moduli that meet
  const T half(0.5), j = step.motion.volume_ratio, change = j - history[1];
  const StatePoint<T> at{step.density, step.motion.time, step.motion.length, history[2]};
  const T old_pressure = T(-1.0 / 3.0) * trace(old);
  const Symmetric3<T> deviator = add_pressure(step.stress, T(-1.0 / 3.0) * trace(step.stress));
  const Symmetric3<T> old_deviator = add_pressure(old, old_pressure);
  const T work = half * (j + history[1]) * half * contract(old_deviator + deviator, step.motion.de);
  const T known = history[0] + work - (half * old_pressure + step.motion.viscosity) * change;

  // p with p = p(J, known - p change / 2), by Newton's method: at once where p is linear in e
  T pressure = old_pressure;
  StatePressure<T> now = state(j, known - half * change * pressure, at);
  auto open = now.pressure == now.pressure;
  for (int i = 0; i < most_steps && any(open); ++i) {
    const T excess = now.pressure - pressure;
    const T next = pressure + excess / (T(1) + half * change * now.by_energy);
    const T size = larger(next, -next) + T(least_bulk);
    open = open && larger(next - pressure, pressure - next) > T(tolerance) * size;
    pressure = select(open, next, pressure);
    const StatePressure<T> again = state(j, known - half * change * pressure, at);
    now.pressure = select(open, again.pressure, now.pressure);
    now.by_energy = select(open, again.by_energy, now.by_energy);
    now.by_volume = select(open, again.by_volume, now.by_volume);
  }
  // adiabatic: -J dp/dJ with de = -p dJ; at the cutoff that of the state, which is there again once it closes
  const T bulk = larger(j * (pressure * now.by_energy - now.by_volume), T(least_bulk));
  pressure = larger(pressure, T(state.least_pressure));
  history[0] = known - half * change * pressure;
  history[1] = j;
  step.stress = add_pressure(deviator, -pressure);
  step.lambda = bulk - T(2.0 / 3.0) * step.mu;
  return {change, now.by_energy};
}

}  // namespace percuss
