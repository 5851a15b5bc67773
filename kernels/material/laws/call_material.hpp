#pragma once
// How a called material is made, started and called: all that sees the list of materials.

#include "kernels/material/advance_point.hpp"
#include "kernels/material/laws/called_material.hpp"
#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"

namespace percuss {

template <class Law>
CalledMaterial make_called_material(const Law& law, double density) {
  static_assert(CalledMaterial::law_place + Law::history_count + state_history_count + 1 <=
                CalledMaterial::history_count);
  CalledMaterial called;
  set_any_of(called.law, Materials(), law);
  called.reference = law.moduli();
  called.density = density;
  called.law_history = Law::history_count;
  called.stores_energy = requires { requires Law::stores_energy; };
  called.changes_at_rest = requires { requires Law::changes_at_rest; };
  if constexpr (requires { law.count_history(); }) called.law_history = law.count_history();
  if constexpr (requires { law.find_place(); }) {
    if (law.find_place() >= 0) called.place = CalledMaterial::law_place + law.find_place();
  }
  if constexpr (requires { law.made.entry; }) {
    called.stores_energy = law.made.entry->stores_energy;
    called.changes_at_rest = law.made.entry->changes_at_rest;
  }
  return called;
}

/// Update with an equation of state. Its bulk modulus takes the place of the law's, and a material without strength
/// gets a small stiffness for hourglass control only.
template <class Law, class State>
CalledMaterial make_called_material(const Law& law, double density, const State& state) {
  constexpr double least_share = 0.01;
  CalledMaterial called = make_called_material(law, density);
  set_any_of(called.state, EquationsOfState(), state);
  called.state_history = state_history_count;
  called.stores_energy = false;
  const double bulk = find_start_modulus(state, density);
  LameConstants& reference = called.reference;
  if (!(reference.mu > 0)) reference.mu = least_share * bulk;
  reference.lambda = bulk - 2.0 / 3.0 * reference.mu;
  if constexpr (requires { State::is_lit; }) called.changes_at_rest = true;
  return called;
}

/// History of an element at the start. history: out, [count_history()]; center: of the element.
inline void start_history(const CalledMaterial& called, double* history, const double (&center)[3]) {
  for (int i = 0; i < called.count_history(); ++i) history[i] = 0;
  history[0] = (called.reference.lambda > 0 ? called.reference.lambda : 0) + 2 * called.reference.mu;
  visit_any_of(called.law, Materials(), [&](const auto& law) {
    if constexpr (requires { law.start(history); }) law.start(history + CalledMaterial::law_place);
  });
  visit_any_of(called.state, EquationsOfState(),
               [&](const auto& state) { start_state(state, history + called.find_state_place(), center); });
}

/// Whether code of a user needs data of its elements.
inline bool needs_elements(const CalledMaterial& called) {
  bool needs = false;
  visit_any_of(called.law, Materials(), [&](const auto& law) {
    if constexpr (requires { law.needs_elements(); }) needs = law.needs_elements();
  });
  return needs;
}

/// Sets the data of the element that code of a user gets; call after start_history().
inline void start_element(const CalledMaterial& called, const UserElement& element, double* history) {
  visit_any_of(called.law, Materials(), [&](const auto& law) {
    if constexpr (requires { law.start_element(element, history); })
      law.start_element(element, history + CalledMaterial::law_place);
  });
}

template <class T>
PERCUSS_NO_INLINE void CalledMaterial::update(PointStep<T>& step) const {
  constexpr double least_share = 1e-6;  // of the modulus at the start
  T* const own = step.history;
  const Symmetric3<T> old = step.stress;
  step.density = density;
  step.lambda = T(reference.lambda);
  step.mu = T(reference.mu);
  step.plastic = {T(1), T(1e300), T(0)};
  step.history = own + law_place;
  visit_any_of(law, Materials(), [&](const auto& one) { advance_point(one, step); });
  const double least_bulk = least_share * (reference.lambda + reference.mu);
  visit_any_of(state, EquationsOfState(), [&](const auto& one) {
    const StateChange<T> change = advance_state(one, old, own + law_place + law_history, least_bulk, step);
    visit_any_of(law, Materials(), [&](const auto& heated) {
      if constexpr (requires { heated.compress(change, step); }) heated.compress(change, step);
    });
  });
  step.lambda = larger(step.lambda, T(0));
  own[0] = step.lambda + T(2) * step.mu;
}

}  // namespace percuss
