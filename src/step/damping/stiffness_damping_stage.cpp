#include "src/step/damping/stiffness_damping_stage.hpp"

#include "kernels/core/host_copy.hpp"

namespace percuss {

StiffnessDampingStage::StiffnessDampingStage(const Model& model)
    : model_(model), factor_(to_host(model.stiffness_damping)) {}

SpinDampingFields StiffnessDampingStage::find_fields(const State& state) const {
  SpinDampingFields fields;
  fields.force = state.damping_force;
  fields.slot_force = state.slot_force;
  fields.work = state.results.work;
  fields.moment = state.damping_moment;
  fields.slot_moment = state.slot_moment;
  fields.state = state.elements;
  return fields;
}

void StiffnessDampingStage::damp_sending(const State& state, const DampedMotions& motions) const {
  const SpinDampingFields fields = find_fields(state);
  damp_solids(ExecSpace(), model_.chunks, model_.sending_damped_solids, motions.solids, fields);
  damp_shells(ExecSpace(), model_.chunks, model_.sending_damped_shells, motions.shells, fields);
  damp_beams(ExecSpace(), model_.chunks, model_.sending_damped_beams, motions.beams, fields);
}

void StiffnessDampingStage::damp_others(const State& state, const DampedMotions& motions) const {
  const SpinDampingFields fields = find_fields(state);
  damp_solids(ExecSpace(), model_.chunks, model_.damped_solids, motions.solids, fields);
  damp_shells(ExecSpace(), model_.chunks, model_.damped_shells, motions.shells, fields);
  damp_beams(ExecSpace(), model_.chunks, model_.damped_beams, motions.beams, fields);
}

}  // namespace percuss
