#pragma once
// What joined nodes get of constraints: velocities, impulses, and the work of these.

#include <vector>

#include "src/output/history_columns.hpp"
#include "src/step/springs/gathered_rows.hpp"

namespace percuss {

/// A direction of a node: its velocity with the constraint, and the impulse that this takes.
struct JoinedMotion {
  double velocity = 0, impulse = 0;
};

/// Column of the history: Books::equal_work.
HistoryColumn equal_work_column();

/// Work with the mean of the velocities before and after the step. Contact has counted its own with the velocities
/// that the constraints then changed. outcomes: [nodes][3].
void book_joined_work(const GatheredRows<NodeRow>& rows, const std::vector<JoinedMotion>& outcomes, State& state);

/// Outcomes to the nodes that this rank holds: velocities, and impulses as those of welds.
void give_joined_motion(const ConnectedNodes& connected, const std::vector<JoinedMotion>& outcomes, const State& state);

}  // namespace percuss
