#include "src/step/rigid/rigid_stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/step/model/impulses.hpp"

namespace percuss {
namespace {

bool holds_spin(const RigidBody& body) { return body.holds(3) || body.holds(4) || body.holds(5); }

/// Value of a held direction: the velocity in the step of dt from `time`, or the displacement at its end.
double evaluate(const Motion& motion, double time, double dt) {
  return motion.curve(motion.is_displacement ? time + dt : time + 0.5 * dt);
}

BodyResponse find_response(const RigidBody& body, const RigidState& state) {
  BodyResponse response;
  response.center = state.center;
  for (std::size_t k = 0; k < 3; ++k)
    set(response.inverse_mass, static_cast<int>(k), body.holds(k) ? 0 : 1 / body.mass);
  response.inverse_inertia = find_free_inverse(body, state);
  return response;
}

}  // namespace

/// What holds a body in a step.
struct RigidStage::Goal {
  double velocity[3] = {0, 0, 0};  // where held
  HeldSpin spin;
};

RigidStage::RigidStage(const Model& model) : model_(model) {
  if (!any()) return;
  for (const RigidBody& body : model.rigid.bodies)
    for (const int motion : body.motion) is_moved_ = is_moved_ || motion > 0;  // row 0 is rest
  const std::size_t count = model.rigid.bodies.size();
  steps_ = Array<BodyStep>("percuss::body_steps", count);
  responses_ = Array<BodyResponse>("percuss::body_responses", count);
  inputs_ = {static_cast<int>(count), model.rigid.body_of_node, responses_};
}

/// dt = 0: at time 0.
RigidStage::Goal RigidStage::find_goal(const State& state, std::size_t index, double dt) const {
  const RigidBody& body = model_.rigid.bodies[index];
  Goal goal;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!body.holds(k)) continue;
    const Motion& motion = model_.motions[static_cast<std::size_t>(body.motion[k])];
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

void RigidStage::start(State& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    RigidState& now = state.bodies[b];
    const Goal goal = find_goal(state, b, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (body.holds(k)) set(now.velocity, static_cast<int>(k), goal.velocity[k]);
      if (goal.spin.held[k]) set(now.spin, static_cast<int>(k), goal.spin.rate[k]);
    }
    now.spin_momentum = find_inertia(body, now) * now.spin;
  }
  if (!any()) return;
  next_ = state.bodies;
  upload(state, 0);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
  set_spins(state);
}

/// Where the velocities of next_ take a body, and the momentum that its turn has.
void RigidStage::move(const State& state, std::size_t index, double dt) {
  const RigidBody& body = model_.rigid.bodies[index];
  const RigidState& now = state.bodies[index];
  RigidState& next = next_[index];
  const Goal goal = find_goal(state, index, dt);
  for (std::size_t k = 0; k < 3; ++k)
    if (body.holds(k)) set(next.velocity, static_cast<int>(k), goal.velocity[k]);
  const Symmetric3<double> inertia = find_inertia(body, now);
  const Vector3<double> q = find_turn(inertia, next.spin_momentum, goal.spin, dt);
  if (holds_spin(body)) {
    const Vector3<double> turned = find_spin_momentum(inertia, q, dt);
    for (int k = 0; k < 3; ++k)
      if (goal.spin.held[k]) set(next.spin_momentum, k, get(turned, k));
  }
  next.spin = (2 / dt) * q;
  next.center = now.center + dt * next.velocity;
  next.orientation = turn(now.orientation, q);
}

/// The bodies between now and next for the kernels.
void RigidStage::upload(const State& state, double dt) {
  const auto steps = Kokkos::create_mirror_view(steps_);
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const RigidState &now = state.bodies[b], &next = next_[b];
    const Matrix3<double> rotation = find_rotation(now.orientation);
    steps(b) = {now.center,    next.center, rotation, dt > 0 ? find_rotation(next.orientation) : rotation,
                next.velocity, next.spin};
  }
  Kokkos::deep_copy(steps_, steps);
}

/// Damps what next_ moves freely of a body. damping: coefficients by entry of the deck.
void RigidStage::damp(const State& state, std::size_t index, const std::vector<double>& damping, double dt_mean) {
  const RigidBody& body = model_.rigid.bodies[index];
  const int entry = model_.damped_bodies[index];
  const double share = entry < 0 ? 0 : find_damped_share(damping[static_cast<std::size_t>(entry)], dt_mean);
  const RigidState& now = state.bodies[index];
  RigidState& next = next_[index];
  Wrench lost{(-0.5 * share * body.mass) * (now.velocity + next.velocity),
              (-0.5 * share) * (now.spin_momentum + next.spin_momentum)};
  for (int k = 0; k < 3; ++k) {
    if (body.holds(static_cast<std::size_t>(k))) set(lost.impulse, k, 0);
    if (body.holds(3 + static_cast<std::size_t>(k))) set(lost.moment, k, 0);
  }
  next.velocity = next.velocity + (1 / body.mass) * lost.impulse;
  next.spin_momentum = next.spin_momentum + lost.moment;
  damping_.push_back(lost);
}

void RigidStage::predict(State& state, double dt, double dt_mean, const std::vector<double>& damping) {
  forces_ = find_forces_(model_, state);
  contact_.clear();
  damping_.clear();
  next_ = state.bodies;
  const auto responses = Kokkos::create_mirror_view(responses_);
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    const double* g = state.gravity.g;
    next_[b].velocity =
        next_[b].velocity + dt_mean * ((1 / body.mass) * forces_[b].impulse + Vector3<double>{g[0], g[1], g[2]});
    next_[b].spin_momentum = next_[b].spin_momentum + dt_mean * forces_[b].moment;
    if (!damping.empty()) damp(state, b, damping, dt_mean);
    move(state, b, dt);
    responses(b) = find_response(body, state.bodies[b]);
  }
  Kokkos::deep_copy(responses_, responses);
  upload(state, dt);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
}

void RigidStage::correct(State& state, const std::vector<Wrench>& contact, double dt) {
  contact_ = contact;
  if (contact.empty()) return;
  for (std::size_t b = 0; b < next_.size(); ++b) {
    next_[b].velocity = next_[b].velocity + (1 / model_.rigid.bodies[b].mass) * contact[b].impulse;
    next_[b].spin_momentum = next_[b].spin_momentum + contact[b].moment;
    move(state, b, dt);
  }
  upload(state, dt);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
}

void RigidStage::set_spins(const State& state) const {
  if (!any() || !model_.has_rotations) return;
  set_rigid_spins(ExecSpace(), model_.rigid.nodes, steps_, state.w);
}

/// Work and moment of the damping of a body; adds its impulse to j.
void RigidStage::book_damping(State& state, std::size_t index, double (&j)[3]) const {
  const Wrench& lost = damping_[index];
  const RigidState &now = state.bodies[index], &next = next_[index];
  const double work = dot(lost.impulse, now.velocity + next.velocity) + dot(lost.moment, now.spin + next.spin);
  state.books.damping_work.add(0.5 * work);
  state.books.damping_work.normalize();
  for (int k = 0; k < 3; ++k) {
    j[k] += get(lost.impulse, k);
    state.books.moment_impulse[k].add(get(lost.moment, k));
  }
}

void RigidStage::book(State& state, double dt, double dt_mean) const {
  if (model_.ranks.rank() != 0) return;
  const double share = model_.gravity_varies ? 0.5 : 1;  // of the step: the other half is of that at n+1
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    const RigidState &now = state.bodies[b], &next = next_[b];
    const Wrench contact = contact_.empty() ? Wrench{} : contact_[b], &force = forces_[b];
    double j[3] = {0, 0, 0}, work = 0;
    for (int k = 0; k < 3; ++k) {
      const auto dof = static_cast<std::size_t>(k);
      const double g = state.gravity.g[k], m = body.mass, p = get(contact.impulse, k), f = get(force.impulse, k);
      const double v0 = get(now.velocity, k), v1 = get(next.velocity, k), change = m * (v1 - v0) - p;
      if (body.holds(dof)) {
        j[k] = change - dt_mean * (f + m * g);
        work += 0.5 * change * (v0 + v1) - dt * v1 * (0.5 * f + share * m * g);
      }
      if (!body.holds(dof + 3)) continue;
      const double w0 = get(now.spin, k), w1 = get(next.spin, k), t = get(force.moment, k);
      const double turned = get(next.spin_momentum, k) - get(now.spin_momentum, k) - get(contact.moment, k);
      state.books.moment_impulse[k].add(turned - dt_mean * t);
      work += 0.5 * turned * (w0 + w1) - 0.5 * dt * w1 * t;
    }
    if (!damping_.empty()) book_damping(state, b, j);
    const double r[3] = {now.center.x - model_.mass_center[0], now.center.y - model_.mass_center[1],
                         now.center.z - model_.mass_center[2]};
    add_impulse(r, j, 0, [&](int k, double value) {
      (k < 3 ? state.books.impulse[k] : state.books.moment_impulse[k - 3]).add(value);
    });
    state.books.external_work.add(work);
  }
  for (ExactSum* sum : {state.books.impulse, state.books.moment_impulse})
    for (int k = 0; k < 3; ++k) sum[k].normalize();
  state.books.external_work.normalize();
}

void RigidStage::place(State& state) {
  if (!any()) return;
  place_rigid_nodes(ExecSpace(), model_.rigid.nodes, steps_, state.x);
  state.bodies = next_;
}

void RigidStage::book_rest(State& state, double dt) {
  if (!is_moved_) return;
  const auto& bodies = model_.rigid.bodies;
  const std::vector<Wrench> forces = find_forces_(model_, state);
  if (model_.ranks.rank() != 0) return;
  const Gravity rest = model_.gravity_varies ? state.gravity : Gravity{};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RigidState& now = state.bodies[b];
    double power = 0;
    const Vector3<double> weight = bodies[b].mass * Vector3<double>{rest.g[0], rest.g[1], rest.g[2]};
    for (int k = 0; k < 3; ++k) {
      const auto dof = static_cast<std::size_t>(k);
      if (bodies[b].holds(dof)) power += get(now.velocity, k) * (get(forces[b].impulse, k) + get(weight, k));
      if (bodies[b].holds(dof + 3)) power += get(now.spin, k) * get(forces[b].moment, k);
    }
    state.books.external_work.add(-0.5 * dt * power);
  }
  state.books.external_work.normalize();
}

double RigidStage::find_step(const State& state, double end) const {
  constexpr double share_of_end = 1e-3, share_of_edge = 0.2, turn_of_step = 0.02;  // rad
  double step = share_of_end * end;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidState& now = state.bodies[b];
    const double spin = norm(now.spin), speed = norm(now.velocity) + spin * model_.rigid.bodies[b].radius;
    if (speed > 0) step = std::min(step, share_of_edge * model_.rigid.least_edge / speed);
    if (spin > 0) step = std::min(step, turn_of_step / spin);
  }
  return step;
}

}  // namespace percuss
