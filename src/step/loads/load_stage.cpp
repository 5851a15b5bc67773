#include "src/step/loads/load_stage.hpp"

#include "src/deck/deck.hpp"

namespace percuss {

LoadStage::LoadStage(const Deck& deck, const Model& model)
    : model_(model),
      adds_forces_(!deck.pressures.empty() || !deck.nodal_loads.empty()),
      pressures_("percuss::pressures", model.pressures.size()),
      nodal_values_("percuss::nodal_values", model.nodal_values.size()) {}

void LoadStage::add_forces(State& state, double time) {
  state.gravity = find_gravity(model_, time);
  load_nodes(state, time);
  press_faces(state, time);
}

void LoadStage::load_nodes(const State& state, double time) {
  if (model_.nodal_loads.count == 0) return;
  const auto values = Kokkos::create_mirror_view(nodal_values_);
  for (std::size_t i = 0; i < model_.nodal_values.size(); ++i) {
    const bool is_on = model_.switches.nodal_loads[i].is_on(state.happened);
    for (std::size_t k = 0; k < 6; ++k) values(i, k) = is_on ? model_.nodal_values[i][k](time) : 0;
  }
  Kokkos::deep_copy(nodal_values_, values);
  apply_nodal_loads(ExecSpace(), state.nodal_loads, nodal_values_, state.slot_force, state.slot_moment);
}

void LoadStage::press_faces(const State& state, double time) {
  if (model_.pressure_faces.count == 0) return;
  const auto values = Kokkos::create_mirror_view(pressures_);
  for (std::size_t i = 0; i < model_.pressures.size(); ++i) {
    const auto entry = static_cast<std::size_t>(model_.pressure_entries[i]);
    values(i) = model_.switches.pressures[entry].is_on(state.happened) ? model_.pressures[i](time) : 0;
  }
  Kokkos::deep_copy(pressures_, values);
  apply_pressure(ExecSpace(), state.pressure_faces, pressures_, state.x, state.slot_force);
}

}  // namespace percuss
