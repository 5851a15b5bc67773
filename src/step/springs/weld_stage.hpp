#pragma once
// The welds of a step: what makes pairs of nodes move as one, what that takes, and which fail.
//
// Every rank computes all welds, from what the owners of their nodes send to all.

#include <array>
#include <vector>

#include "src/step/model/action.hpp"
#include "src/step/springs/gathered_rows.hpp"
#include "src/step/springs/weld_patch.hpp"

namespace percuss {

class WeldStage : public Action {
 public:
  /// The model outlives this.
  explicit WeldStage(const Model& model);

  /// Velocities and spins at n+1/2 of welded nodes, their forces and work, and which welds fail at the end of the
  /// step.
  void follow_contact(State& state, const StepTimes& times, const ContactReport* contact) override;
  void drop_vanished(State& state) override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<std::string> list_notes() const override { return model_.welds.notes; }
  std::vector<Warning> list_start_warnings() const override { return model_.welds.warnings; }
  std::vector<Warning> take_warnings() override;
  double bound_component(const State& /*state*/, double predicted) const override { return predicted; }

  // Kernels of its own: nvcc takes none in a private function.
  void give_back(const State& state) const;

 private:
  void gather(const State& state);
  std::array<WeldNode, 2> find_ends(const Weld& weld) const;
  void join_one(std::size_t index, double dt, WeldImpulse& impulse, std::array<WeldNode, 2>& ends);
  double solve(const State& state, double dt);
  double solve_once(const State& state, double dt);
  void warn_of_unsettled(double time);
  Vector3<double> find_new_normal(const Weld& weld, const Vector3<double>& normal, double dt) const;
  bool has_lost_nodes(const Weld& weld) const;
  void judge(State& state, double dt, double dt_mean);
  double find_work() const;
  double find_work_of_contact() const;

  const Model& model_;
  GatheredRows<NodeRow> rows_;
  std::vector<WeldNode> nodes_;        // [WeldModel::nodes]
  std::vector<MovingPatch> patches_;   // [WeldModel::patches] at n
  std::vector<NodeImpulse> on_nodes_;  // [WeldModel::nodes] of the step
  std::vector<WeldImpulse> sums_;      // [welds] of the step
  std::size_t slowest_ = 0;            // weld that changed most in the last turn
  std::vector<Warning> warnings_;
};

}  // namespace percuss
