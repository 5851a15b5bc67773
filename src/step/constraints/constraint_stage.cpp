#include "src/step/constraints/constraint_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/impulses.hpp"

namespace percuss {

namespace {

/// Tolerated residual of an equation, as a share of the largest speed, and most iterations.
constexpr ConstraintLimits limits_of_equations{1e-13, 1000};
/// Residual from which equations and conditions contradict each other.
constexpr double contradiction = 1e-6;

}  // namespace

ConstraintStage::ConstraintStage(const Model& model)
    : model_(model),
      rows_(model, model.constraints),
      outcomes_(3 * model.constraints.nodes.size()),
      system_(limits_of_equations),
      velocity_(model.constraints.rows.empty() ? 0 : outcomes_.size()),
      inverse_(velocity_.size()),
      after_(velocity_.size()),
      rates_(model.constraints.rows.size()) {
  for (const ConstraintRow& row : model.constraints.rows) system_.add_row(row.terms);
}

void ConstraintStage::solve_groups() {
  for (std::size_t n = 0; n < model_.constraints.nodes.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) outcome(static_cast<int>(n), k) = {value(n, NodeRow::velocity, k), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const EqualGroups& groups = model_.constraints.groups[k];
    for (std::size_t g = 0; g + 1 < groups.first.size(); ++g)
      join_group(groups.members.data() + groups.first[g], groups.members.data() + groups.first[g + 1], k);
  }
}

/// The mean velocity of the nodes that are left, or that of the first one which is held: it takes what the others need.
/// Velocities count from that of the first node, so that equal ones keep their bits.
void ConstraintStage::join_group(const int* first, const int* last, std::size_t k) {
  int base = -1, held = -1;
  double mass = 0, momentum = 0;
  for (const int* i = first; i < last; ++i) {
    const std::size_t n = at(*i);
    if (!(value(n, NodeRow::mass) > 0)) continue;
    if (base < 0) base = *i;
    if (held < 0 && value(n, NodeRow::inverse_mass, k) == 0) held = *i;
    mass += find_answering_mass(n);
    momentum += find_answering_mass(n) * (value(n, NodeRow::velocity, k) - value(at(base), NodeRow::velocity, k));
  }
  if (base < 0) return;
  const double common =
      held >= 0 ? value(at(held), NodeRow::velocity, k) : value(at(base), NodeRow::velocity, k) + momentum / mass;
  double given = 0;
  for (const int* i = first; i < last; ++i) {
    const std::size_t n = at(*i);
    if (!(value(n, NodeRow::mass) > 0) || *i == held) continue;
    const double impulse = find_answering_mass(n) * (common - value(n, NodeRow::velocity, k));
    outcome(*i, k) = {common, impulse};
    given += impulse;
  }
  if (held >= 0) outcome(held, k).impulse = -given;
}

/// Nodes that have vanished free their equations.
void ConstraintStage::solve_rows(double time, double dt) {
  for (std::size_t i = 0; i < velocity_.size(); ++i) {
    velocity_[i] = value(i / 3, NodeRow::velocity, i % 3);
    inverse_[i] = value(i / 3, NodeRow::inverse_mass, i % 3);
  }
  for (std::size_t r = 0; r < rates_.size(); ++r) {
    const ConstraintRow& row = model_.constraints.rows[r];
    const auto& sum = model_.constraints.constraints[at(row.constraint)].sum;
    rates_[r] = sum ? ((*sum)(time + dt) - (*sum)(time)) / dt : 0;
    system_.set_loose(r, std::any_of(row.terms.begin(), row.terms.end(), [&](const ConstraintTerm& term) {
                        return !(value(at(term.unknown / 3), NodeRow::mass) > 0);
                      }));
  }
  system_.solve(velocity_, inverse_, rates_);
  for (std::size_t i = 0; i < velocity_.size(); ++i) {
    after_[i] = velocity_[i] + inverse_[i] * system_.impulses()[i];
    outcomes_[i] = {after_[i], system_.impulses()[i]};
  }
  check_rows(time);
}

/// Throws RunError, the same on all ranks, where conditions hold nodes against an equation.
void ConstraintStage::check_rows(double time) const {
  const double allowed = contradiction * std::max({find_largest_amount(velocity_), find_largest_amount(after_),
                                                   find_largest_amount(rates_)});
  for (std::size_t r = 0; r < rates_.size(); ++r) {
    const double missing = rates_[r] - system_.sum(r, after_);
    if (system_.is_loose(r) || std::abs(missing) <= allowed) continue;
    const Constraint& constraint = model_.constraints.constraints[at(model_.constraints.rows[r].constraint)];
    throw RunError(
        fmt::format("{}: constraint '{}' does not hold at t = {:.6g} (other constraints or conditions move its nodes "
                    "against it, at a rate of {:.3g}): leave one of them out",
                    constraint.place, constraint.name, time, missing));
  }
}

/// Equations whose factors have a sum push from outside, and those whose terms get a sum over time do work.
void ConstraintStage::book_sums(State& state) const {
  ExactSum driven;
  double taken = 0;
  std::vector<double> before(velocity_.size());
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = value(i / 3, NodeRow::velocity_before, i % 3);
  for (std::size_t r = 0; r < rates_.size(); ++r) {
    const int constraint = model_.constraints.rows[r].constraint;
    if (!model_.constraints.constraints[at(constraint)].sum) continue;
    const double work = 0.5 * system_.row_impulses()[r] * (system_.sum(r, before) + system_.sum(r, after_));
    driven.add(work);
    taken += work;
  }
  state.books.equal_work -= taken;
  if (model_.ranks.rank() != 0) return;
  add_work(driven, state.books);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = k; i < outcomes_.size(); i += 3) state.books.impulse[k].add(outcomes_[i].impulse);
    state.books.impulse[k].normalize();
  }
}

/// Forces at different places turn the nodes: their moment comes from outside.
void ConstraintStage::book(State& state) const {
  book_joined_work(rows_, outcomes_, state);
  if (model_.ranks.rank() != 0) return;
  const Vec3& center = model_.mass_center;
  ExactSum moments[3];
  for (std::size_t n = 0; n < model_.constraints.nodes.size(); ++n) {
    const JoinedMotion* const of_node = &outcomes_[3 * n];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      moments[k].add((value(n, NodeRow::place, i) - center[i]) * of_node[j].impulse -
                     (value(n, NodeRow::place, j) - center[j]) * of_node[i].impulse);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    state.books.moment_impulse[k].merge(moments[k]);
    state.books.moment_impulse[k].normalize();
  }
}

void ConstraintStage::set_forces(State& state, double dt_mean) {
  for (std::size_t c = 0; c < state.constraints.size(); ++c) {
    const Constraint& constraint = model_.constraints.constraints[c];
    double force[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!constraint.equal[k]) continue;
      for (const int n : constraint.nodes) {
        const double of_node = outcome(n, k).impulse / dt_mean;
        force[k] += constraint.has_pairs ? of_node : 0.5 * std::abs(of_node);
      }
    }
    state.constraints[c].force = {force[0], force[1], force[2]};
  }
}

/// Each from the impulses of its own rows.
void ConstraintStage::set_row_forces(State& state, double dt_mean) const {
  std::vector<std::array<double, 3>> sums(state.constraints.size()), amounts(state.constraints.size());
  for (std::size_t r = 0; r < rates_.size(); ++r) {
    const ConstraintRow& row = model_.constraints.rows[r];
    const double force = system_.row_impulses()[r] / dt_mean;
    sums[at(row.constraint)][row.direction] += force;
    amounts[at(row.constraint)][row.direction] += std::abs(force);
  }
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const Constraint& constraint = model_.constraints.constraints[c];
    if (!constraint.has_pairs && !constraint.is_equation)
      for (std::size_t k = 0; k < 3; ++k) sums[c][k] = 0.5 * (std::abs(sums[c][k]) + amounts[c][k]);
    state.constraints[c].force = {sums[c][0], sums[c][1], sums[c][2]};
  }
}

void ConstraintStage::follow_contact(State& state, const StepTimes& times, const ContactReport* /*contact*/) {
  rows_.gather(state);
  const bool has_rows = system_.count() > 0;
  has_rows ? solve_rows(times.time, times.dt) : solve_groups();
  book(state);
  if (has_rows) book_sums(state);
  has_rows ? set_row_forces(state, times.dt_mean) : set_forces(state, times.dt_mean);
  give_joined_motion(model_.constraints, outcomes_, state);
}

void ConstraintStage::archive(CheckpointArchive& archive, State& state) {
  archive.each("constraints", state.constraints,
               [](ConstraintState& c, const auto& take) { take(c.force.x, c.force.y, c.force.z); });
  archive.number("books/equal_work", state.books.equal_work);
}

std::vector<HistoryColumn> ConstraintStage::list_columns() const {
  std::vector<HistoryColumn> columns = {equal_work_column()};
  for (const Constraint& constraint : model_.constraints.constraints) {
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

void ConstraintStage::append_values(const State& state, std::vector<double>& row) {
  row.push_back(state.books.equal_work);
  for (std::size_t c = 0; c < state.constraints.size(); ++c) {
    const Vector3<double>& force = state.constraints[c].force;
    const double along[] = {force.x, force.y, force.z};
    if (model_.constraints.constraints[c].is_equation) row.push_back(force.x);
    for (std::size_t k = 0; k < 3; ++k)
      if (model_.constraints.constraints[c].equal[k]) row.push_back(along[k]);
  }
}

}  // namespace percuss
