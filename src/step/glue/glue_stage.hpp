#pragma once
// The glue of a step: separations, damage, forces into the slots, work, and what they leave of the step.
//
// Every rank computes all glue, from places that the owners of its nodes send to all.

#include <cstdint>
#include <vector>

#include "kernels/contact/geometry/glue_geometry.hpp"
#include "src/contact/contact_stage.hpp"
#include "src/deck/deck.hpp"
#include "src/step/model/action.hpp"
#include "src/step/springs/gathered_rows.hpp"

namespace percuss {

class GlueStage : public Action {
 public:
  /// Collective over the model's ranks. All outlive this. contact: gets the nodes whose glue fails.
  GlueStage(const Deck& deck, const Model& model, ContactStage& contact);

  void advance(State& state, double dt) override;
  void drop_vanished(State& state) override;
  bool comes_between() const override { return false; }
  bool adds_forces() const override { return true; }
  void add_forces(State& state, double time) override;
  void limit_step(const State& state, StepBound& bound) const override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  void resume(const State& state) override;
  std::vector<Warning> take_warnings() override;

 private:
  using Row = ForcedRow<false, true>;

  Separation find_separation_of(const GluePoint& point, const Point3& arm) const;
  void gather(const State& state);
  void turn_arms(State& state, double dt);
  void pull(const State& state, const std::vector<double>& damage_before);
  double find_work(double share_before, double share_now) const;
  void book(State& state, const std::vector<double>& damage_before, const std::vector<CohesivePoint>& before);
  void let_go(const State& state, const std::vector<double>& damage_before);

  const Deck& deck_;
  const Model& model_;
  ContactStage& contact_;
  std::vector<int> body_of_node_;  // [GlueModel::nodes] rigid; -1: none
  GatheredRows<Row> nodes_;
  std::vector<Point3> moves_;          // [GlueModel::nodes] between the last two gather()
  std::vector<CohesivePoint> points_;  // [GlueModel::points] at n
  std::vector<GlueShares> shares_;     // [GlueModel::points] at n
  std::vector<Point3> forces_;         // [GlueModel::nodes] at n
  std::vector<Point3> forces_before_;  // at n-1
  std::vector<Point3> turns_;          // [GlueModel::points] of nodes with an arm, in the last step
  std::vector<Point3> moments_;        // [GlueModel::points] on these nodes, at n
  std::vector<Point3> moments_before_;
  std::vector<Warning> warnings_;
  Rows3<double> own_forces_, own_moments_;
};

}  // namespace percuss
