#pragma once
// Tetrahedra, wedges and pyramids within a step: the passes of the mixed form with their swaps, or the one of the plain
// form.

#include "comm/halo/group_swap.hpp"
#include "kernels/tet/tet_force.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class TetStage {
 public:
  /// Collective. The model outlives this.
  explicit TetStage(const Model& model);

  /// Prepares the forces: of the mixed form the stresses at n+1 of all chunks, and their averages at the nodes.
  /// Collective.
  void prepare(const State& state, const ElementMotion& motion);

  /// The forces of some chunks into their slots.
  void advance(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const;

  /// Messages of this rank with rates and stresses of shared nodes.
  Traffic traffic() const;

 private:
  void sum_rates(const State& state, const ElementBlocks& blocks, const TetStep& step) const;
  void advance_stresses(const State& state, const ElementBlocks& blocks, const TetStep& step) const;

  const Model& model_;
  ExecSpace space_;
  TetLaunch launch_;
  GroupSwap<TetSums::rate_groups> rates_;
  GroupSwap<TetSums::stress_groups> stresses_;
};

}  // namespace percuss
