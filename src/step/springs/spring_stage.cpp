#include "src/step/springs/spring_stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/node_mobility.hpp"

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

SpringStage::SpringStage(const Model& model)
    : model_(model),
      body_of_node_(share_bodies(model, model.springs)),
      nodes_(model, model.springs),
      own_forces_("percuss::spring_forces", model.springs.owned_node.extent(0)) {}

SpringEnds SpringStage::find_ends(const Spring& spring) const {
  SpringEnds ends;
  for (std::size_t i = 0; i < 2; ++i) {
    ends.place[i] = nodes_.vector(spring.end[i], Row::place);
    ends.velocity[i] = nodes_.vector(spring.end[i], Row::velocity);
  }
  return ends;
}

bool SpringStage::has_lost_a_node(const Spring& spring) const {
  return std::any_of(spring.end.begin(), spring.end.end(),
                     [&](int n) { return nodes_.value(n, Row::mobility) == Row::gone; });
}

// A force does the work of its mean over the step along the change of length, as elements do theirs.
void SpringStage::advance(State& state, double dt) {
  nodes_.gather(state);
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    const Spring& spring = model_.springs.springs[s];
    const SpringLaw& law = model_.springs.laws[at(spring.law)];
    const SpringState before = state.springs[s];
    const SpringState now = stretch_spring(law, spring.rest_length, before, find_ends(spring));
    if (dt > 0) {
      const double change = now.elongation - before.elongation;
      state.books.spring_work += 0.5 * (before.elastic + now.elastic) * change;
      state.books.damper_work += 0.5 * (before.damping + now.damping) * change;
    } else if (now.is_broken == 0) {
      state.books.spring_work += find_stored_energy(law, now.elongation);
    }
    state.springs[s] = now;
  }
}

// Half of the force at n has been booked for the step to n. That force is gone, for the nodes that are left too.
void SpringStage::drop_vanished(State& state) {
  std::vector<double> changes;  // of length in the last step, by the velocities that the nodes had
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    const SpringEnds ends = find_ends(model_.springs.springs[s]);
    changes.push_back(state.dt * dot(state.springs[s].axis, ends.velocity[1] - ends.velocity[0]));
  }
  nodes_.gather(state);
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    SpringState& spring = state.springs[s];
    if (spring.is_broken != 0 || !has_lost_a_node(model_.springs.springs[s])) continue;
    state.books.spring_work -= 0.5 * spring.elastic * changes[s];
    state.books.damper_work -= 0.5 * spring.damping * changes[s];
    spring.is_broken = 1;
    spring.elastic = spring.damping = 0;
  }
}

void SpringStage::add_forces(State& state, double /*time*/) {
  std::vector<Vector3<double>> forces(model_.springs.nodes.size(), {0, 0, 0});
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    const Spring& spring = model_.springs.springs[s];
    const Vector3<double> force = state.springs[s].force() * state.springs[s].axis;
    forces[at(spring.end[0])] = forces[at(spring.end[0])] + force;
    forces[at(spring.end[1])] = forces[at(spring.end[1])] - force;
  }
  fill_force_slots(model_.springs, forces, own_forces_, state.slot_force);
}

// The mass of a node, or of a body, is divided among its springs by stiffness times mobility. The largest eigenvalue of
// each spring with its shares is then the sum of what its two nodes carry, and that of all is at most the largest of
// these (the element eigenvalue theorem, Irons and Treharne 1971).
SpringStage::StiffestSpring SpringStage::find_rates(const State& state) const {
  const std::vector<double> mobility = find_mobilities(model_, state, body_of_node_, nodes_);
  const std::size_t nodes = mobility.size();
  std::vector<SpringRates> carried(nodes + state.bodies.size());
  const auto carrier = [&](int n) { return body_of_node_[at(n)] < 0 ? at(n) : nodes + at(body_of_node_[at(n)]); };
  const auto visit = [&](const auto& take) {
    for (std::size_t s = 0; s < state.springs.size(); ++s)
      if (state.springs[s].is_broken == 0) take(s, model_.springs.springs[s]);
  };
  visit([&](std::size_t s, const Spring& spring) {
    const SpringLaw& law = model_.springs.laws[at(spring.law)];
    const double stiffness = bound_stiffness(law, state.springs[s]);
    for (const int n : spring.end) {
      carried[carrier(n)].stiffness += stiffness * mobility[at(n)];
      carried[carrier(n)].damping += law.damping * mobility[at(n)];
    }
  });
  StiffestSpring stiffest;
  visit([&](std::size_t s, const Spring& spring) {
    const SpringRates &a = carried[carrier(spring.end[0])], &b = carried[carrier(spring.end[1])];
    const SpringRates both{a.stiffness + b.stiffness, a.damping + b.damping};
    stiffest.rates.stiffness = std::max(stiffest.rates.stiffness, both.stiffness);
    stiffest.rates.damping = std::max(stiffest.rates.damping, both.damping);
    const double step = find_step_with_springs(both, std::numeric_limits<double>::infinity());
    if (!(step < stiffest.step)) return;
    stiffest.step = step;
    stiffest.spring = static_cast<std::int64_t>(s);
  });
  return stiffest;
}

void SpringStage::limit_step(const State& state, StepBound& bound) const {
  const StiffestSpring stiffest = find_rates(state);
  const SpringRates& rates = stiffest.rates;
  if (!(rates.stiffness > 0) && !(rates.damping > 0)) return;
  if (stiffest.step < bound.step) bound.spring = stiffest.spring;
  bound.step = find_step_with_springs(rates, bound.step);
}

void SpringStage::archive(CheckpointArchive& archive, State& state) {
  archive.each("springs", state.springs, [](SpringState& s, const auto& take) {
    take(s.elongation, s.elastic, s.damping, s.axis.x, s.axis.y, s.axis.z, s.length, s.is_broken);
  });
  archive.number("bound/spring", state.bound.spring);
  archive.number("books/spring_work", state.books.spring_work);
  archive.number("books/damper_work", state.books.damper_work);
}

std::vector<HistoryColumn> SpringStage::list_columns() const {
  std::vector<HistoryColumn> columns = {{"spring_work", dimensions::energy, "energy of springs, part of internal"},
                                        {"damper_work", dimensions::energy, "energy taken by dampers, part of viscous"},
                                        {"dt_spring", {}, "spring that limits the next step, 0 where an element does"}};
  for (const Spring& spring : model_.springs.springs) {
    if (!spring.has_columns) continue;
    columns.push_back({"spring_force:" + spring.name, dimensions::force,
                       fmt::format("force of spring '{}', positive in tension, its damper included", spring.name)});
    columns.push_back({"spring_elongation:" + spring.name, dimensions::length,
                       fmt::format("elongation of spring '{}'", spring.name)});
  }
  return columns;
}

void SpringStage::append_values(const State& state, std::vector<double>& row) {
  row.push_back(state.books.spring_work);
  row.push_back(state.books.damper_work);
  row.push_back(number_limiting_spring(model_.springs, state.bound.spring));
  for (std::size_t s = 0; s < state.springs.size(); ++s) {
    if (!model_.springs.springs[s].has_columns) continue;
    row.push_back(state.springs[s].force());
    row.push_back(state.springs[s].elongation);
  }
}

}  // namespace percuss
