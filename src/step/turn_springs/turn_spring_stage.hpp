#pragma once
// Turn springs in a step: their angles and moments at n+1, which act on the bodies in the next step.
//
// Every rank finds them, from the same bits. RigidForces adds the moments to what else acts on the bodies.

#include "src/step/model/action.hpp"

namespace percuss {

class TurnSpringStage : public Action {
 public:
  /// The model outlives this.
  explicit TurnSpringStage(const Model& model) : model_(model) {}

  void advance(State& state, double dt) override;
  bool comes_between() const override { return false; }
  void limit_step(const State& state, StepBound& bound) const override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;

 private:
  const Model& model_;
};

}  // namespace percuss
