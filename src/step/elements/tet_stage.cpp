#include "src/step/elements/tet_stage.hpp"

#include "src/step/model/element_blocks.hpp"

namespace percuss {

TetStage::TetStage(const Model& model)
    : model_(model), rates_(model.ranks, model.halo), stresses_(model.ranks, model.halo) {
  if (!model.mixes_solids) return;
  launch_ = {*model.tet_nodes, make_tet_passes(*model.tet_nodes, model.chunks, model.slot_count)};
}

void TetStage::prepare(const State& state, const ElementMotion& motion) {
  if (!model_.mixes_solids) return;
  const TetStep step{motion, launch_};
  sum_rates(state, *model_.sending, step);
  rates_.begin(space_, launch_.passes.slot_rates);
  sum_rates(state, *model_.others, step);
  rates_.end();
  average_tet_rates(space_, launch_);
  advance_stresses(state, *model_.sending, step);
  stresses_.begin(space_, launch_.passes.slot_stresses);
  advance_stresses(state, *model_.others, step);
  stresses_.end();
  average_tet_stresses(space_, launch_);
}

void TetStage::sum_rates(const State& state, const ElementBlocks& blocks, const TetStep& step) const {
  percuss::sum_rates(space_, model_.chunks, blocks.tetrahedra, step, state.chunk_fields());
  percuss::sum_rates(space_, model_.chunks, blocks.one_point, step, state.chunk_fields());
}

void TetStage::advance_stresses(const State& state, const ElementBlocks& blocks, const TetStep& step) const {
  percuss::advance_stresses(space_, model_.chunks, blocks.tetrahedra, step, state.chunk_fields());
  percuss::advance_stresses(space_, model_.chunks, blocks.one_point, step, state.chunk_fields());
}

void TetStage::advance(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const {
  if (model_.mixes_solids) {
    sum_forces(space_, model_.chunks, blocks.tetrahedra, {motion, launch_}, state.chunk_fields());
    sum_forces(space_, model_.chunks, blocks.one_point, {motion, launch_}, state.chunk_fields());
  } else {
    advance_plain(space_, model_.chunks, blocks.tetrahedra, motion, state.chunk_fields());
    advance_plain(space_, model_.chunks, blocks.one_point, motion, state.chunk_fields());
  }
}

Traffic TetStage::traffic() const {
  const Traffic a = rates_.traffic(), b = stresses_.traffic();
  return {a.messages + b.messages, a.bytes + b.bytes};
}

}  // namespace percuss
