#include "src/step/rigid/rigid_step.hpp"

namespace percuss {
namespace {

bool holds_spin(const RigidBody& body, const RigidState& state) {
  return holds(body, state, 3) || holds(body, state, 4) || holds(body, state, 5);
}

/// Value of a held direction: the velocity in the step of dt from `time`, or the displacement at its end.
double evaluate(const Motion& motion, double time, double dt) {
  return motion.curve(motion.is_displacement ? time + dt : time + 0.5 * dt);
}

}  // namespace

BodyResponse find_response(const RigidBody& body, const RigidState& state, double growth) {
  BodyResponse response;
  response.center = state.center;
  for (std::size_t k = 0; k < 3; ++k)
    set(response.inverse_mass, static_cast<int>(k), holds(body, state, k) ? 0 : 1 / (body.mass * growth));
  response.growth = growth;
  response.inverse_inertia = (1 / growth) * find_free_inverse(body, state);
  return response;
}

void give_wrench(const RigidBody& body, const Wrench& wrench, double growth, RigidState& next) {
  next.velocity = next.velocity + (1 / (body.mass * growth)) * wrench.impulse;
  next.spin_momentum = next.spin_momentum + (1 / growth) * wrench.moment;
}

RigidGoal find_rigid_goal(const Model& model, const State& state, std::size_t index, double dt) {
  const RigidBody& body = model.rigid.bodies[index];
  RigidGoal goal;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!holds(body, state.bodies[index], k)) continue;
    const Motion& motion = model.motions[static_cast<std::size_t>(body.motion[k])];
    double value = evaluate(motion, state.time, dt);
    if (motion.is_displacement) {
      const int axis = static_cast<int>(k);
      value = dt > 0 ? (get(body.center, axis) + value - get(state.bodies[index].center, axis)) / dt : 0;
    }
    if (k < 3) {
      goal.velocity[k] = value;
    } else {
      goal.spin.held[k - 3] = true;
      goal.spin.rate[k - 3] = value;
    }
  }
  return goal;
}

void move_body(const Model& model, const State& state, std::size_t index, double dt, RigidState& next) {
  const RigidBody& body = model.rigid.bodies[index];
  const RigidState& now = state.bodies[index];
  const RigidGoal goal = find_rigid_goal(model, state, index, dt);
  for (std::size_t k = 0; k < 3; ++k)
    if (holds(body, now, k)) set(next.velocity, static_cast<int>(k), goal.velocity[k]);
  const Symmetric3<double> inertia = find_inertia(body, now);
  const Vector3<double> q = find_turn(inertia, next.spin_momentum, goal.spin, dt);
  if (holds_spin(body, now)) {
    const Vector3<double> turned = find_spin_momentum(inertia, q, dt);
    for (int k = 0; k < 3; ++k)
      if (goal.spin.held[k]) set(next.spin_momentum, k, get(turned, k));
  }
  next.spin = (2 / dt) * q;
  next.center = now.center + dt * next.velocity;
  next.orientation = turn(now.orientation, q);
}

std::vector<RigidState> predict_momenta(const Model& model, const State& state, const std::vector<Wrench>& forces,
                                        double dt_mean) {
  std::vector<RigidState> next = state.bodies;
  const double* g = state.gravity.g;
  for (std::size_t b = 0; b < next.size(); ++b) {
    next[b].velocity = next[b].velocity + dt_mean * ((1 / model.rigid.bodies[b].mass) * forces[b].impulse +
                                                     Vector3<double>{g[0], g[1], g[2]});
    next[b].spin_momentum = next[b].spin_momentum + dt_mean * forces[b].moment;
  }
  return next;
}

}  // namespace percuss
