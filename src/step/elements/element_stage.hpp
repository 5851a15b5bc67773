#pragma once
// The elements of a step, family by family: (1.3) to (1.5) of all, what failed, and what they ask of the step.

#include <memory>

#include "comm/exchange/data_exchange.hpp"
#include "kernels/element/element_motion.hpp"
#include "kernels/element/failure.hpp"
#include "src/step/model/element_bounds.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class TetStage;

class ElementStage {
 public:
  /// Collective. The model outlives this.
  explicit ElementStage(const Model& model);
  ~ElementStage();

  /// Prepares the forces: the stresses that wedges, pyramids and tetrahedra average over nodes. Collective.
  void prepare(const State& state, const ElementMotion& motion);

  /// The forces at n+1 of some chunks into their slots, and those of damping in proportion to stiffness.
  void advance(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const;

  /// Finds elements that fail by the forces at n+1, and elements that die. dt: of the step; time: n+1.
  FailureCounts judge(const State& state, double dt, double time) const;

  /// The step that a chunk allows with its damping. bound: without it.
  double find_step(std::size_t chunk, double bound) const;

  /// Messages of this rank with rates and stresses.
  Traffic traffic() const;

 private:
  void damp(const State& state, const ElementBlocks& blocks, const ElementMotion& motion) const;

  const Model& model_;
  ExecSpace space_;
  std::unique_ptr<TetStage> tets_;  // only with wedges, pyramids or tetrahedra
  HostMirror<Array<double>> damping_factor_;
};

}  // namespace percuss
