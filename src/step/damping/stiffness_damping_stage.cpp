#include "src/step/damping/stiffness_damping_stage.hpp"

#include "kernels/core/host_copy.hpp"

namespace percuss {

StiffnessDampingStage::StiffnessDampingStage(const Model& model)
    : model_(model),
      force_("percuss::stiffness_damping_force", static_cast<std::size_t>(model.slot_count)),
      factor_(to_host(model.stiffness_damping)) {
  if (model.has_rotations)
    moment_ = Rows3<double>("percuss::stiffness_damping_moment", static_cast<std::size_t>(model.slot_count));
}

ShellDampingFields StiffnessDampingStage::find_fields(const State& state) const {
  ShellDampingFields fields;
  fields.force = force_;
  fields.slot_force = state.slot_force;
  fields.work = state.results.work;
  fields.moment = moment_;
  fields.slot_moment = state.slot_moment;
  fields.state = state.elements;
  return fields;
}

void StiffnessDampingStage::damp_sending(const State& state, const DampedMotions& motions) const {
  const ShellDampingFields fields = find_fields(state);
  damp_solids(ExecSpace(), model_.chunks, model_.sending_damped_solids, motions.solids, fields);
  damp_shells(ExecSpace(), model_.chunks, model_.sending_damped_shells, motions.shells, fields);
}

void StiffnessDampingStage::damp_others(const State& state, const DampedMotions& motions) const {
  const ShellDampingFields fields = find_fields(state);
  damp_solids(ExecSpace(), model_.chunks, model_.damped_solids, motions.solids, fields);
  damp_shells(ExecSpace(), model_.chunks, model_.damped_shells, motions.shells, fields);
}

void StiffnessDampingStage::restore(const State& state, const DampedMotions& motions) const {
  State spare = state;
  spare.slot_force = Rows3<double>("percuss::spare_forces", static_cast<std::size_t>(model_.slot_count));
  if (model_.has_rotations)
    spare.slot_moment = Rows3<double>("percuss::spare_moments", static_cast<std::size_t>(model_.slot_count));
  damp_sending(spare, motions);
  damp_others(spare, motions);
}

}  // namespace percuss
