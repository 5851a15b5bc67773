#include "src/step/constraints/constraint_stage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/impulses.hpp"

namespace percuss {

ConstraintStage::ConstraintStage(const Model& model)
    : model_(model),
      rows_(model.constraints.nodes.size() * NodeRow::count),
      outcomes_(3 * model.constraints.nodes.size()),
      own_rows_("percuss::constrained_rows", model.constraints.owned_node.extent(0), NodeRow::count) {}

void ConstraintStage::gather(const State& state) {
  const auto& constraints = model_.constraints;
  gather_nodes(model_, state, {constraints.owned_node, constraints.owned_place}, own_rows_, rows_);
}

void ConstraintStage::solve() {
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
    mass += value(n, NodeRow::mass);
    momentum += value(n, NodeRow::mass) * (value(n, NodeRow::velocity, k) - value(at(base), NodeRow::velocity, k));
  }
  if (base < 0) return;
  const double common =
      held >= 0 ? value(at(held), NodeRow::velocity, k) : value(at(base), NodeRow::velocity, k) + momentum / mass;
  double given = 0;
  for (const int* i = first; i < last; ++i) {
    const std::size_t n = at(*i);
    if (!(value(n, NodeRow::mass) > 0) || *i == held) continue;
    const double impulse = value(n, NodeRow::mass) * (common - value(n, NodeRow::velocity, k));
    outcome(*i, k) = {common, impulse};
    given += impulse;
  }
  if (held >= 0) outcome(held, k).impulse = -given;
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

void ConstraintStage::follow_contact(State& state, const StepTimes& times, const ContactReport* /*contact*/) {
  gather(state);
  solve();
  book(state);
  set_forces(state, times.dt_mean);
  give_joined_motion(model_.constraints, outcomes_, state);
}

void ConstraintStage::archive(CheckpointArchive& archive, State& state) {
  for (std::size_t c = 0; c < state.constraints.size(); ++c) {
    Vector3<double>& force = state.constraints[c].force;
    double values[] = {force.x, force.y, force.z};
    archive.numbers(fmt::format("constraints/{}", c), values);
    force = {values[0], values[1], values[2]};
  }
  archive.number("books/equal_work", state.books.equal_work);
}

}  // namespace percuss
