#include "src/step/turn_springs/turn_spring_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/turn_springs/turn_law.hpp"

namespace percuss {
namespace {

TurnAxes find_axes(const TurnSpring& spring, const State& state) {
  TurnAxes axes;
  for (std::size_t e = 0; e < 2; ++e) {
    const Matrix3<double> rotation = find_rotation(state.bodies[at(spring.body[e])].orientation);
    for (std::size_t k = 0; k < 3; ++k) axes[e][k] = rotation * spring.axes[e][k];
  }
  return axes;
}

/// Moments of the laws in new places of the bodies. rates: of the angles.
void set_moments(const TurnSpring& spring, const TurnSpringState& before, const std::array<double, 3>& rates,
                 TurnSpringState& now) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!spring.laws[k]) continue;
    const TurnLaw& law = *spring.laws[k];
    now.elastic[k] = find_elastic_moment(law, now.angle[k]);
    now.damping[k] = find_elastic_force(law.damper, rates[k]);
    now.friction[k] = find_friction(law, now.angle[k], now.angle[k] - before.angle[k], before.friction[k]);
  }
}

/// Stiffness and damping that the angles of a spring have for a body, over its inertia.
SpringRates find_body_rates(const TurnSpring& spring, const std::array<Vector3<double>, 3>& vectors,
                            const Symmetric3<double>& inverse_inertia) {
  SpringRates rates;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!spring.laws[k]) continue;
    const double mobility = dot(vectors[k], inverse_inertia * vectors[k]);
    rates.stiffness += bound_turn_stiffness(*spring.laws[k]) * mobility;
    rates.damping += spring.laws[k]->damper.largest_slope * mobility;
  }
  return rates;
}

}  // namespace

// A moment does the work of its mean over the step along the change of its angle, as springs do theirs.
void TurnSpringStage::advance(State& state, double dt) {
  for (std::size_t s = 0; s < state.turn_springs.size(); ++s) {
    const TurnSpring& spring = model_.turn_springs[s];
    const TurnSpringState before = state.turn_springs[s];
    TurnSpringState now;
    const TurnAxes axes = find_axes(spring, state);
    now.angle = find_turn_angles(axes, before.angle);
    const std::array<Vector3<double>, 3> vectors = find_rate_vectors(axes, now.angle);
    const Vector3<double> spin = state.bodies[at(spring.body[1])].spin - state.bodies[at(spring.body[0])].spin;
    std::array<double, 3> rates{};
    for (std::size_t k = 0; k < 3; ++k)
      rates[k] = dt > 0 ? (now.angle[k] - before.angle[k]) / dt : dot(vectors[k], spin);
    set_moments(spring, dt > 0 ? before : now, rates, now);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!spring.laws[k]) continue;
      now.moment = now.moment + (-(now.elastic[k] + now.damping[k] + now.friction[k])) * vectors[k];
      if (!(dt > 0)) {
        state.books.turn_work += find_turn_energy(*spring.laws[k], now.angle[k]);
        continue;
      }
      const double turned = now.angle[k] - before.angle[k];
      state.books.turn_work += 0.5 * (before.elastic[k] + now.elastic[k]) * turned;
      state.books.turn_loss +=
          0.5 * (before.damping[k] + now.damping[k] + before.friction[k] + now.friction[k]) * turned;
    }
    state.turn_springs[s] = now;
  }
}

// The inertia of a body is divided among its springs by stiffness times mobility, as the mass of nodes among springs.
void TurnSpringStage::limit_step(const State& state, StepBound& bound) const {
  std::vector<SpringRates> carried(state.bodies.size());
  for (std::size_t s = 0; s < state.turn_springs.size(); ++s) {
    const TurnSpring& spring = model_.turn_springs[s];
    const auto vectors = find_rate_vectors(find_axes(spring, state), state.turn_springs[s].angle);
    for (const int b : spring.body) {
      const SpringRates rates =
          find_body_rates(spring, vectors, find_free_inverse(model_.rigid.bodies[at(b)], state.bodies[at(b)]));
      carried[at(b)].stiffness += rates.stiffness;
      carried[at(b)].damping += rates.damping;
    }
  }
  SpringRates stiffest;
  for (std::size_t s = 0; s < model_.turn_springs.size(); ++s) {
    const auto [first, second] = model_.turn_springs[s].body;
    const SpringRates &a = carried[at(first)], &b = carried[at(second)];
    const SpringRates both{a.stiffness + b.stiffness, a.damping + b.damping};
    if (find_step_with_springs(both, std::numeric_limits<double>::infinity()) < bound.step)
      bound.spring = number_turn_spring(s);
    stiffest = {std::max(stiffest.stiffness, both.stiffness), std::max(stiffest.damping, both.damping)};
  }
  if (stiffest.stiffness > 0 || stiffest.damping > 0) bound.step = find_step_with_springs(stiffest, bound.step);
}

void TurnSpringStage::archive(CheckpointArchive& archive, State& state) {
  archive.each("turn_springs", state.turn_springs, [](TurnSpringState& s, const auto& take) {
    for (std::size_t k = 0; k < 3; ++k) take(s.angle[k], s.elastic[k], s.damping[k], s.friction[k]);
    take(s.moment.x, s.moment.y, s.moment.z);
  });
  archive.number("books/turn_work", state.books.turn_work);
  archive.number("books/turn_loss", state.books.turn_loss);
}

std::vector<HistoryColumn> TurnSpringStage::list_columns() const {
  std::vector<HistoryColumn> columns = {
      {"turn_work", dimensions::energy, "energy of turn springs and their stops, part of internal"},
      {"turn_loss", dimensions::energy, "energy taken by dampers and friction of turn springs, part of viscous"}};
  for (const TurnSpring& spring : model_.turn_springs) {
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

void TurnSpringStage::append_values(const State& state, std::vector<double>& row) {
  row.push_back(state.books.turn_work);
  row.push_back(state.books.turn_loss);
  for (std::size_t s = 0; s < state.turn_springs.size(); ++s) {
    const TurnSpringState& now = state.turn_springs[s];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!model_.turn_springs[s].laws[k]) continue;
      row.push_back(now.angle[k]);
      row.push_back(now.elastic[k] + now.damping[k] + now.friction[k]);
    }
  }
}

}  // namespace percuss
