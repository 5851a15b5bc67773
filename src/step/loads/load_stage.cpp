#include "src/step/loads/load_stage.hpp"

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/deck/deck.hpp"

namespace percuss {
namespace {

/// Values of pulses at a time, or zeros, one after the other from `first` on.
void find_values(const Array<const Pulse>& pulses, double time, bool is_on, int first, const Array<double>& values) {
  parallel_for(
      "percuss::blast_pressures", RangeOf(ExecSpace(), 0, static_cast<int>(pulses.extent(0))),
      KOKKOS_LAMBDA(const int i) { values(first + i) = is_on ? pulses(i)(time) : 0; });
}

}  // namespace

LoadStage::LoadStage(const Deck& deck, const Model& model)
    : model_(model),
      adds_forces_(!deck.pressures.empty() || !deck.nodal_loads.empty()),
      pressures_("percuss::pressures", model.pressures.size()),
      nodal_values_("percuss::nodal_values", model.nodal_values.size()) {
  list_pulses();
}

/// Each entry of the deck has either one curve or a pulse for each of its faces.
void LoadStage::list_pulses() {
  const std::vector<int>& entries = model_.pressure_entries;
  for (std::size_t i = 0, end = 0; i < entries.size(); i = end) {
    end = static_cast<std::size_t>(std::upper_bound(entries.begin(), entries.end(), entries[i]) - entries.begin());
    std::vector<Pulse> pulses;
    for (std::size_t load = i; load < end; ++load) {
      if (const Pulse* const pulse = model_.pressures[load].as_pulse())
        pulses.push_back(*pulse);
      else
        curves_.push_back(load);
    }
    if (pulses.empty()) continue;
    blasts_.push_back({static_cast<std::size_t>(entries[i]), static_cast<int>(i), to_view("percuss::pulses", pulses)});
  }
}

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
  copy_values(nodal_values_, values);
  apply_nodal_loads(ExecSpace(), state.nodal_loads, nodal_values_, state.slot_force, state.slot_moment);
}

void LoadStage::press_faces(const State& state, double time) {
  if (model_.pressure_faces.count == 0) return;
  evaluate_curves(state, time);
  evaluate_pulses(state, time);
  const Vec3& center = model_.mass_center;
  apply_pressure(ExecSpace(), state.pressure_faces, pressures_, {state.x, state.v, {center[0], center[1], center[2]}},
                 state.slot_force, state.pressure_sums);
}

void LoadStage::evaluate_curves(const State& state, double time) {
  if (curves_.empty()) return;
  const auto values = Kokkos::create_mirror_view(pressures_);
  for (const std::size_t i : curves_) {
    const auto entry = static_cast<std::size_t>(model_.pressure_entries[i]);
    values(i) = model_.switches.pressures[entry].is_on(state.happened) ? model_.pressures[i](time) : 0;
  }
  copy_values(pressures_, values);
}

void LoadStage::evaluate_pulses(const State& state, double time) {
  for (const Blast& blast : blasts_) {
    const bool is_on = model_.switches.pressures[blast.entry].is_on(state.happened);
    find_values(blast.pulses, time, is_on, blast.first_load, pressures_);
  }
}

}  // namespace percuss
