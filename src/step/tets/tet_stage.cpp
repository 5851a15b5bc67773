#include "src/step/tets/tet_stage.hpp"

namespace percuss {

TetStage::TetStage(const Model& model)
    : model_(model), rates_(model.ranks, model.halo), stresses_(model.ranks, model.halo) {
  if (!model.mixes_tets) return;
  const auto packs = static_cast<int>(model.chunks.corner_slots.extent(0) / (8 * pack_size<Real>));
  launch_ = {model.tet_nodes, make_tet_passes(model.tet_nodes, model.slot_count, packs)};
}

void TetStage::prepare(const State& state, const ElementMotion& motion) {
  if (!model_.mixes_tets) return;
  const TetStep step{motion, launch_};
  sum_tet_rates(space_, model_.chunks, model_.sending_tet_blocks, step);
  rates_.begin(space_, launch_.passes.slot_rates);
  sum_tet_rates(space_, model_.chunks, model_.tet_blocks, step);
  rates_.end();
  average_tet_rates(space_, launch_);
  advance_tet_stresses(space_, model_.chunks, model_.sending_tet_blocks, step, state.elements, state.results);
  stresses_.begin(space_, launch_.passes.slot_stresses);
  advance_tet_stresses(space_, model_.chunks, model_.tet_blocks, step, state.elements, state.results);
  stresses_.end();
  average_tet_stresses(space_, launch_);
}

void TetStage::advance(const State& state, const TetBlocks& blocks, const ElementMotion& motion) const {
  if (model_.mixes_tets)
    sum_tet_forces(space_, model_.chunks, blocks, {motion, launch_}, state.chunk_fields());
  else
    advance_plain_tets(space_, model_.chunks, blocks, motion, state.chunk_fields());
}

Traffic TetStage::traffic() const {
  const Traffic a = rates_.traffic(), b = stresses_.traffic();
  return {a.messages + b.messages, a.bytes + b.bytes};
}

}  // namespace percuss
