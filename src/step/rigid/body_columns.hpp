#pragma once
// The columns of history.csv of rigid bodies and their joints.

#include <optional>
#include <vector>

#include "src/output/history_columns.hpp"
#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {

/// "body_x:ram" and so on, body after body.
std::vector<HistoryColumn> list_body_columns(const RigidModel& rigid);

/// "joint_fx:hinge" and so on, joint after joint.
std::vector<HistoryColumn> list_joint_columns(const RigidModel& rigid);

/// Appends their values to a row.
void append_joints(const Model& model, const State& state, std::vector<double>& row);

/// Values of the columns of bodies. Holds the memory of sums.
class BodyColumns {
 public:
  /// Appends them to a row. Collective.
  void append(const Model& model, const State& state, std::vector<double>& row);

 private:
  std::optional<BodyForceFinder> find_forces_;  // of the model of the first row
};

}  // namespace percuss
