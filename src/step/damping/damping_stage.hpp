#pragma once
// Damping in a step: impulses between n-1/2 and n+1/2 on nodes, and what they do.
//
// Rigid bodies get theirs in RigidStage, to which this tells the coefficients.

#include <optional>
#include <vector>

#include "src/step/model/owned_sums.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class DampingStage {
 public:
  /// The model outlives this.
  explicit DampingStage(const Model& model);

  /// Coefficients of a step from this time on, by entry of the deck [1 / time].
  void begin_step(double time);
  const std::vector<double>& coefficients() const { return values_; }

  /// Damps v(n+1/2), which must be without contact. Call with v_before.
  void damp(State& state, double dt_mean);

  /// The same of the rotations of the nodes of shells and beams.
  void damp_spins(State& state, double dt_mean);

  /// Books the work and the impulses of both. Call with v and w at n+1/2, x at n.
  void book(State& state);

 private:
  const Model& model_;
  std::vector<double> values_;
  bool is_active_ = false;  // whether any coefficient of the step is above 0
  Array<double> coefficients_;
  Rows3<double> impulse_, spin_impulse_;
  OwnedNodeSums<7> sums_{"percuss::damping_sums"};  // work, impulse, moment of impulse
};

}  // namespace percuss
