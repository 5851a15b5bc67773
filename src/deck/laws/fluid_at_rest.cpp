#include "src/deck/laws/fluid_at_rest.hpp"

#include <cmath>

#include "src/deck/laws/make_material.hpp"

namespace percuss {

bool can_rest(const MaterialDeck& material, double pressure) {
  constexpr double tolerance = 1e-9, most_volume = 10;  // of the modulus and of the volume at the start
  bool can = false;
  visit_state(*material.equation_of_state, [&]<class State>(const State& state) {
    if constexpr (requires { State::is_lit; }) return;
    const PressedFluid at = press_to(state, material.density, pressure);
    const double reached = find_pressure(state, material.density, at).pressure;
    can = at.j > 0 && at.j < most_volume &&
          std::abs(reached - pressure) <= tolerance * find_start_modulus(state, material.density);
  });
  return can;
}

PressedFluid find_fluid_at_rest(const MaterialDeck& material, double pressure, double gravity, double depth) {
  PressedFluid at;
  visit_state(*material.equation_of_state, [&](const auto& state) {
    const double weight = material.density * gravity * depth;
    at = press(state, material.density, press_to(state, material.density, pressure),
               [&](double j) { return weight / j; });
  });
  return at;
}

}  // namespace percuss
