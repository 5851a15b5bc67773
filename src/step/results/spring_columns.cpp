#include "src/step/results/spring_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percuss {
namespace {

/// 0: none; from 1 on: a spring by its place among those with columns; below 0: one without, by that of its entry.
double number_limiting_spring(const SpringModel& springs, std::int64_t limiting) {
  if (!springs.has(limiting)) return 0;
  const auto at = springs.springs.begin() + static_cast<std::ptrdiff_t>(limiting);
  if (!at->has_columns) return -1 - at->law;
  return 1 +
         static_cast<double>(std::count_if(springs.springs.begin(), at, [](const Spring& s) { return s.has_columns; }));
}

}  // namespace

std::vector<HistoryColumn> list_spring_columns(const SpringModel& springs) {
  if (!springs.any()) return {};
  std::vector<HistoryColumn> columns = {{"spring_work", dimensions::energy, "energy of springs, part of internal"},
                                        {"damper_work", dimensions::energy, "energy taken by dampers, part of viscous"},
                                        {"dt_spring", {}, "spring that limits the next step, 0 where an element does"}};
  for (const Spring& spring : springs.springs) {
    if (!spring.has_columns) continue;
    columns.push_back({"spring_force:" + spring.name, dimensions::force,
                       fmt::format("force of spring '{}', positive in tension, its damper included", spring.name)});
    columns.push_back({"spring_elongation:" + spring.name, dimensions::length,
                       fmt::format("elongation of spring '{}'", spring.name)});
  }
  return columns;
}

void append_springs(const SpringModel& springs, const State& state, std::vector<double>& row) {
  if (state.springs.empty()) return;
  row.push_back(state.books.spring_work);
  row.push_back(state.books.damper_work);
  row.push_back(number_limiting_spring(springs, state.bound.spring));
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    if (!springs.springs[s].has_columns) continue;
    row.push_back(state.springs[s].force());
    row.push_back(state.springs[s].elongation);
  }
}

std::vector<HistoryColumn> list_turn_spring_columns(const std::vector<TurnSpring>& springs) {
  if (springs.empty()) return {};
  std::vector<HistoryColumn> columns = {
      {"turn_work", dimensions::energy, "energy of turn springs and their stops, part of internal"},
      {"turn_loss", dimensions::energy, "energy taken by dampers and friction of turn springs, part of viscous"}};
  for (const TurnSpring& spring : springs) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!spring.laws[k]) continue;
      columns.push_back({fmt::format("turn_angle_{}:{}", "xyz"[k], spring.name),
                         {},
                         fmt::format("angle about {} of turn spring '{}', of its second body", "xyz"[k], spring.name)});
      columns.push_back(
          {fmt::format("turn_moment_{}:{}", "xyz"[k], spring.name), dimensions::energy,
           fmt::format("moment about {} of turn spring '{}', against a positive angle", "xyz"[k], spring.name),
           HistoryColumn::Kind::moment});
    }
  }
  return columns;
}

void append_turn_springs(const std::vector<TurnSpring>& springs, const State& state, std::vector<double>& row) {
  if (springs.empty()) return;
  row.push_back(state.books.turn_work);
  row.push_back(state.books.turn_loss);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const TurnSpringState& now = state.turn_springs[s];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!springs[s].laws[k]) continue;
      row.push_back(now.angle[k]);
      row.push_back(now.elastic[k] + now.damping[k] + now.friction[k]);
    }
  }
}

std::vector<HistoryColumn> list_glue_columns(const GlueModel& glue) {
  if (!glue.any()) return {};
  return {{"glue_work", dimensions::energy, "energy of cohesive ties, part of internal"},
          {"glue_dissipated", dimensions::energy, "energy dissipated by cohesive ties, part of glue_work"},
          {"glue_failed", dimensions::area, "failed area of cohesive ties"}};
}

void append_glue(const GlueModel& glue, const State& state, std::vector<double>& row) {
  if (!glue.any()) return;
  row.push_back(state.books.glue_work);
  row.push_back(state.books.glue_dissipated);
  row.push_back(state.books.glue_failed);
}

std::vector<HistoryColumn> list_weld_columns(const WeldModel& welds) {
  if (!welds.any()) return {};
  std::vector<HistoryColumn> columns = {
      {"weld_work", dimensions::energy, "work of welds on their nodes, taken from the viscous energy"},
      {"welds_failed", {}, "number of welds that have failed"}};
  for (const Weld& weld : welds.welds) {
    if (!weld.has_columns) continue;
    columns.push_back({"weld_normal:" + weld.name, dimensions::force,
                       fmt::format("force of weld '{}' along its normal, positive in tension", weld.name)});
    columns.push_back({"weld_shear:" + weld.name, dimensions::force,
                       fmt::format("magnitude of the force of weld '{}' across its normal", weld.name)});
  }
  return columns;
}

void append_welds(const WeldModel& welds, const State& state, std::vector<double>& row) {
  if (!welds.any()) return;
  row.push_back(state.books.weld_work);
  row.push_back(static_cast<double>(std::count_if(state.welds.begin(), state.welds.end(),
                                                  [](const WeldState& weld) { return weld.is_broken != 0; })));
  for (std::size_t i = 0; i < state.welds.size(); ++i) {
    if (!welds.welds[i].has_columns) continue;
    row.push_back(state.welds[i].pull);
    row.push_back(state.welds[i].shear);
  }
}

std::vector<HistoryColumn> list_constraint_columns(const ConstraintModel& constraints, bool has_work) {
  if (!has_work) return {};
  std::vector<HistoryColumn> columns = {
      {"equal_work", dimensions::energy,
       "work of constraints on their nodes, also of embedded ones, taken from the viscous energy"}};
  for (const Constraint& constraint : constraints.constraints) {
    if (constraint.is_equation)
      columns.push_back({"equation:" + constraint.name, dimensions::force,
                         fmt::format("force of constraint '{}' on displacements of factor 1", constraint.name)});
    for (std::size_t k = 0; k < 3; ++k) {
      if (!constraint.equal[k]) continue;
      columns.push_back({fmt::format("equal_{}:{}", "xyz"[k], constraint.name), dimensions::force,
                         fmt::format("force in a direction of constraint '{}' in {}", constraint.name, "xyz"[k])});
    }
  }
  return columns;
}

void append_constraints(const ConstraintModel& constraints, bool has_work, const State& state,
                        std::vector<double>& row) {
  if (!has_work) return;
  row.push_back(state.books.equal_work);
  for (std::size_t c = 0; c < state.constraints.size(); ++c) {
    const Vector3<double>& force = state.constraints[c].force;
    const double along[] = {force.x, force.y, force.z};
    if (constraints.constraints[c].is_equation) row.push_back(force.x);
    for (std::size_t k = 0; k < 3; ++k)
      if (constraints.constraints[c].equal[k]) row.push_back(along[k]);
  }
}

}  // namespace percuss
