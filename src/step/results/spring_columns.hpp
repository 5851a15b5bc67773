#pragma once
// The columns of history.csv of springs, glue, welds and constraints.

#include <vector>

#include "src/output/history_columns.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Work of all springs and dampers, which spring limits the step, then "spring_force:NAME" and
/// "spring_elongation:NAME", spring after spring, of those with Spring::has_columns; none without springs.
std::vector<HistoryColumn> list_spring_columns(const SpringModel& springs);

/// Appends the values of those columns to a row.
void append_springs(const SpringModel& springs, const State& state, std::vector<double>& row);

/// Energy of all turn springs and what they took, angle and moment about each axis that has a law; none without any.
std::vector<HistoryColumn> list_turn_spring_columns(const std::vector<TurnSpring>& springs);

/// Their values, in the same order.
void append_turn_springs(const std::vector<TurnSpring>& springs, const State& state, std::vector<double>& row);

/// Energy of all glue, what of it is dissipated, and the area that has failed; none without glue.
std::vector<HistoryColumn> list_glue_columns(const GlueModel& glue);

/// The values of these columns.
void append_glue(const GlueModel& glue, const State& state, std::vector<double>& row);

/// Work of all welds, how many have failed, then "weld_normal:NAME" and "weld_shear:NAME", weld after weld, of those
/// with Weld::has_columns; none without welds.
std::vector<HistoryColumn> list_weld_columns(const WeldModel& welds);

/// The values of these columns.
void append_welds(const WeldModel& welds, const State& state, std::vector<double>& row);

/// Work of all constraints, then "equal_x:NAME" and so on, constraint after constraint, of their directions. has_work:
/// whether there are constraints or embedded nodes; none without.
std::vector<HistoryColumn> list_constraint_columns(const ConstraintModel& constraints, bool has_work);

/// Their values.
void append_constraints(const ConstraintModel& constraints, bool has_work, const State& state,
                        std::vector<double>& row);

}  // namespace percuss
