#pragma once
// The springs of a step: new lengths, forces into the slots, work, and what they leave of the step.
//
// Every rank computes all springs, from places and velocities that the owners of their nodes send to all.

#include <cstdint>
#include <limits>
#include <vector>

#include "src/step/model/action.hpp"
#include "src/step/springs/gathered_rows.hpp"
#include "src/step/springs/spring_law.hpp"

namespace percuss {

class SpringStage : public Action {
 public:
  /// Collective over the model's ranks. The model outlives this.
  explicit SpringStage(const Model& model);

  /// Computes the forces; at time 0 also the energy that is stored then.
  void advance(State& state, double dt) override;
  void drop_vanished(State& state) override;
  bool comes_between() const override { return false; }
  bool adds_forces() const override { return true; }
  void add_forces(State& state, double time) override;
  void limit_step(const State& state, StepBound& bound) const override;
  void archive(CheckpointArchive& archive, State& state) override;
  /// Work of all springs and dampers, which spring limits the step, then force and elongation, spring after spring, of
  /// those with Spring::has_columns.
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<std::string> list_notes() const override { return model_.springs.notes; }

 private:
  using Row = ForcedRow<true>;

  /// Bound of all springs, and the one that alone allows the shortest step.
  struct StiffestSpring {
    SpringRates rates;  // the largest of all
    std::int64_t spring = -1;
    double step = std::numeric_limits<double>::infinity();  // that this one allows
  };

  SpringEnds find_ends(const Spring& spring) const;
  bool has_lost_a_node(const Spring& spring) const;
  StiffestSpring find_rates(const State& state) const;

  const Model& model_;
  std::vector<int> body_of_node_;  // [SpringModel::nodes] rigid; -1: none
  GatheredRows<Row> nodes_;        // at n
  Rows3<double> own_forces_;
};

}  // namespace percuss
