#pragma once
// Damping in a step: impulses between n-1/2 and n+1/2 on nodes, and what they do.
//
// Rigid bodies get theirs in RigidStage, to which this tells the coefficients.

#include <optional>
#include <vector>

#include "src/step/model/action.hpp"
#include "src/step/model/owned_sums.hpp"

namespace percuss {

class DampingStage : public Action {
 public:
  /// The model outlives this.
  explicit DampingStage(const Model& model);

  void begin_step(const State& state, const StepTimes& times) override;
  /// Of the step, by entry of the deck [1 / time].
  const std::vector<double>& coefficients() const { return values_; }

  void change_velocities(State& state, const StepTimes& times) override;
  double bound_component(const State& state, double predicted) const override;
  /// Of the nodes of shells and beams.
  void change_spins(State& state, const StepTimes& times) override;
  void book_motion(State& state, const StepTimes& times) override;

 private:
  const Model& model_;
  std::vector<double> values_;
  bool is_active_ = false;  // whether any coefficient of the step is above 0
  Array<double> coefficients_;
  Rows3<double> impulse_, spin_impulse_;
  OwnedNodeSums<7> sums_{"percuss::damping_sums"};  // work, impulse, moment of impulse
};

}  // namespace percuss
