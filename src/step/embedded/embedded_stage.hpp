#pragma once
// Nodes embedded in solids, in a step: each gets the velocity of its place in the solid, and the corners of that take
// what this costs, by its weights.
//
// Every rank computes all of them, from what the owners of their nodes and corners send to all.

#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/constraints/linear_constraints.hpp"
#include "src/step/model/action.hpp"
#include "src/step/springs/joined_motion.hpp"

namespace percuss {

class EmbeddedStage : public Action {
 public:
  /// Both outlive this.
  EmbeddedStage(const ChunkedMesh& chunked, const Model& model);

  /// Velocities at n+1/2 of nodes and corners, and the work that this takes.
  void follow_contact(State& state, const StepTimes& times, const ContactReport* contact) override;
  void drop_vanished(State& state) override;
  void archive(CheckpointArchive& archive, State& state) override;
  // Where there are constraints, too, these have the one column of work.
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<std::string> list_notes() const override { return model_.embedded.notes; }
  bool comes_between() const override { return true; }

 private:
  void solve_direction(std::size_t k);

  const ChunkedMesh& chunked_;
  const Model& model_;
  GatheredRows<NodeRow> rows_;
  std::vector<JoinedMotion> outcomes_;      // [EmbeddedModel::nodes][3]
  LinearConstraints system_;                // [EmbeddedModel::embedded] loose: node or solid is gone
  std::vector<double> velocity_, inverse_;  // [EmbeddedModel::nodes] of the direction that is solved
};

}  // namespace percuss
