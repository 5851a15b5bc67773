#include "src/step/elements/element_stage.hpp"

#include "kernels/beam/beam_failure.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/shell/shell_failure.hpp"
#include "src/step/elements/tet_stage.hpp"
#include "src/step/model/element_blocks.hpp"

namespace percuss {

ElementStage::ElementStage(const Model& model) : model_(model), damping_factor_(to_host(model.stiffness_damping)) {
  if (model.has_small_solids) tets_ = std::make_unique<TetStage>(model);
}

ElementStage::~ElementStage() = default;

void ElementStage::prepare(const State& state, const ElementMotion& motion) {
  if (tets_) tets_->prepare(state, motion);
}

void ElementStage::advance(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const {
  const ChunkFields fields = state.chunk_fields();
  advance_elements(space_, model_.chunks, blocks.hexahedra, motion, fields);
  if (tets_) tets_->advance(state, blocks, motion);
  if (model_.has_rotations) advance_shells(space_, model_.chunks, blocks.shells, motion, fields);
  if (model_.has_beams) advance_beams(space_, model_.chunks, blocks.beams, motion, fields);
  if (damping_factor_.extent(0) > 0) damp(state, blocks, motion);
}

double ElementStage::find_step(std::size_t chunk, double bound) const {
  return damping_factor_.extent(0) > 0 ? find_damped_step(bound, damping_factor_(chunk)) : bound;
}

Traffic ElementStage::traffic() const { return tets_ ? tets_->traffic() : Traffic{}; }

/// Adds forces to the slots, and their work to the viscous work of the chunks.
void ElementStage::damp(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const {
  const DampingFields fields{state.damping_force,  state.slot_force,  state.results.work,
                             state.damping_moment, state.slot_moment, state.elements};
  damp_solids(space_, model_.chunks, blocks.damped_solids, motion, fields);
  damp_shells(space_, model_.chunks, blocks.damped_shells, motion, fields);
  damp_beams(space_, model_.chunks, blocks.damped_beams, motion, fields);
}

FailureCounts ElementStage::judge(const State& state, double dt, double time) const {
  if (model_.failing.pack_count == 0) return {};
  const FailingElements elements = state.failing_elements(model_.failing);
  const FailureCounts counts = find_failures(space_, model_.chunks, elements, dt, state.results);
  const FailureCounts of_shells =
      find_shell_failures(space_, model_.chunks, elements, model_.thickness_rules, dt, state.results);
  if (model_.has_beams)
    find_beam_failures(space_, model_.chunks, {model_.others->beams.parameters, time}, elements, state.results);
  return {counts.failing + of_shells.failing, counts.died + of_shells.died};
}

}  // namespace percuss
