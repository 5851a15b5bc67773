#pragma once
// Damping in a step: impulses between n-1/2 and n+1/2 on nodes, and what they do.
//
// It comes before contact; what changes velocities later answers with m (1 + h). The impulses follow from the
// velocities at the end of the step, which contact, welds and constraints have changed by State::damped. Those of spins
// of nodes with a tensor are final at once: nothing joins these spins, and what holds them changes them at a constant
// momentum. Rigid bodies get theirs in RigidStage, to which this tells the coefficients.

#include <optional>
#include <vector>

#include "kernels/node/damping.hpp"
#include "src/step/model/action.hpp"
#include "src/step/model/owned_sums.hpp"

namespace percuss {

class DampingStage : public Action {
 public:
  /// The model outlives this.
  explicit DampingStage(const Model& model);

  void begin_step(const State& state, const StepTimes& times) override;
  /// Coefficients of the step, by entry of the deck [1 / time].
  const std::vector<double>& coefficients() const { return values_; }

  void change_velocities(State& state, const StepTimes& times) override;
  double bound_component(const State& state, double predicted) const override;
  /// Damps the spins of the nodes of shells and beams.
  void change_spins(State& state, const StepTimes& times) override;
  void book_motion(State& state, const StepTimes& times) override;

 private:
  DampedMotion find_motion(const State& state) const;
  DampedMotion find_spins(const State& state) const;

  const Model& model_;
  std::vector<double> values_;
  bool is_active_ = false;  // whether any coefficient of the step is above 0
  Array<double> coefficients_;
  DampedMasses masses_;  // of the last step with damping
  Rows3<double> impulse_, spin_impulse_;
  OwnedNodeSums<7> sums_{"percuss::damping_sums"};  // work, impulse, moment of impulse
};

}  // namespace percuss
