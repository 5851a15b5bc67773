#include "src/deck/laws/fluid_at_rest.hpp"

#include "src/deck/laws/make_material.hpp"

namespace percuss {

bool can_rest(const MaterialDeck& material, double pressure, double weight) {
  constexpr double least_volume = 0.2, most_volume = 10;  // of that at the start
  bool can = false;
  visit_state(*material.equation_of_state, [&]<class State>(const State& state) {
    if constexpr (requires { State::is_lit; }) return;
    const PressedFluid at = press(state, material.density, pressure, weight);
    can = at.j > least_volume && at.j < most_volume;
  });
  return can;
}

PressedFluid find_fluid_at_rest(const MaterialDeck& material, double pressure, double weight) {
  PressedFluid at;
  visit_state(*material.equation_of_state,
              [&](const auto& state) { at = press(state, material.density, pressure, weight); });
  return at;
}

}  // namespace percuss
