#pragma once
// Held and driven directions of nodes in a step: their velocities and spins at n+1/2.

#include "src/step/model/action.hpp"

namespace percuss {

class ConditionStage : public Action {
 public:
  /// The model outlives this.
  explicit ConditionStage(const Model& model);

  /// Held directions begin at their prescribed velocity; a displacement curve begins at rest.
  void start(State& state) override;
  void change_velocities(State& state, const StepTimes& times) override;
  double bound_component(const State& state, double predicted) const override;
  void change_spins(State& state, const StepTimes& times) override;
  void set_switches(State& state) override;
  bool comes_between() const override { return model_.held.count > 0; }

 private:
  void hold(const HeldDirections& held, const State& state, double dt, const Rows3<double>& velocities);
  void evaluate(const State& state, double dt);

  const Model& model_;
  PrescribedMotions motions_;
};

}  // namespace percuss
