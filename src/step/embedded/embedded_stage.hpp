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
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<std::string> list_notes() const override { return model_.embedded.notes; }
  double bound_component(const State& /*state*/, double predicted) const override { return predicted; }

 private:
  void solve_direction(std::size_t k);

  const ChunkedMesh& chunked_;
  const Model& model_;
  const bool keeps_work_;  // Books::equal_work, its column too; where there are constraints, these keep it
  GatheredRows<NodeRow> rows_;
  std::vector<JoinedMotion> outcomes_;      // [EmbeddedModel::nodes][3]
  LinearConstraints system_;                // [EmbeddedModel::embedded] loose: node or solid is gone
  std::vector<double> velocity_, inverse_;  // [EmbeddedModel::nodes] of the direction that is solved
};

}  // namespace percuss
