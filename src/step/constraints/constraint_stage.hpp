#pragma once
// Constraints of a step: nodes with equal displacements in a direction get the mean velocity of their masses. Where
// there are equations, all constraints are rows of one linear system.
//
// Every rank computes all constraints, from what the owners of their nodes send to all.

#include <vector>

#include "src/step/constraints/linear_constraints.hpp"
#include "src/step/model/action.hpp"
#include "src/step/springs/joined_motion.hpp"

namespace percuss {

class ConstraintStage : public Action {
 public:
  /// The model outlives this.
  explicit ConstraintStage(const Model& model);

  /// Velocities at n+1/2 of constrained nodes, the forces that this takes, and their work.
  void follow_contact(State& state, const StepTimes& times, const ContactReport* contact) override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<std::string> list_notes() const override { return model_.constraints.notes; }
  double bound_component(const State& /*state*/, double predicted) const override { return predicted; }

 private:
  double value(std::size_t node, std::size_t what, std::size_t k = 0) const { return rows_.value(node, what, k); }
  double find_answering_mass(std::size_t node) const {
    return value(node, NodeRow::mass) * value(node, NodeRow::growth);
  }
  JoinedMotion& outcome(int node, std::size_t k) { return outcomes_[3 * static_cast<std::size_t>(node) + k]; }
  void solve_groups();
  void solve_rows(double time, double dt);
  void check_rows(double time) const;
  void join_group(const int* first, const int* last, std::size_t k);
  void book(State& state) const;
  void book_sums(State& state) const;
  void set_forces(State& state, double dt_mean);
  void set_row_forces(State& state, double dt_mean) const;

  const Model& model_;
  GatheredRows<NodeRow> rows_;
  std::vector<JoinedMotion> outcomes_;              // [ConstraintModel::nodes][3]
  LinearConstraints system_;                        // of ConstraintModel::rows
  std::vector<double> velocity_, inverse_, after_;  // [3 nodes] of the unknowns
  std::vector<double> rates_;                       // [rows] of their sums
};

}  // namespace percuss
