#include "src/step/rigid/rigid_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/core/view_copy.hpp"
#include "kernels/node/damping.hpp"
#include "kernels/node/motion.hpp"
#include "src/contact/enforcement/contact_report.hpp"
#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/impulses.hpp"
#include "src/step/rigid/rigid_step.hpp"

namespace percuss {

namespace {

double find_kinetic_energy(const Model& model, const std::vector<RigidState>& bodies) {
  double energy = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RigidState& body = bodies[b];
    energy +=
        0.5 * model.rigid.bodies[b].mass * dot(body.velocity, body.velocity) + 0.5 * dot(body.spin_momentum, body.spin);
  }
  return energy;
}

/// Whether the body is held in all directions.
bool is_held(const RigidBody& body, const RigidState& state) {
  bool held = true;
  for (std::size_t k = 0; k < 6; ++k) held = held && holds(body, state, k);
  return held;
}

[[noreturn]] void refuse_step(const Joint& joint, const State& state) {
  throw RunError(
      fmt::format("joint '{}' is torn apart in step {} at t = {:.6g} (what holds or moves its bodies is not what it "
                  "allows, or they turn too far in a step): free them, or reduce time.max_step",
                  joint.name, state.step + 1, state.time));
}

}  // namespace

RigidStage::RigidStage(const Model& model, const std::vector<double>& damping, double end)
    : model_(model), damping_coefficients_(damping), end_(end), joints_(model) {
  for (const RigidBody& body : model.rigid.bodies) {
    for (const int motion : body.motion) is_moved_ = is_moved_ || motion > 0;  // row 0 is rest
    for (const int condition : body.switched_by) is_moved_ = is_moved_ || condition != RigidBody::free;
  }
  const std::size_t count = model.rigid.bodies.size();
  damping_.assign(count, 0);
  growths_.assign(count, 1);
  reactions_.resize(count);
  steps_ = Array<BodyStep>("percuss::body_steps", count);
  responses_ = Array<BodyResponse>("percuss::body_responses", count);
  inputs_ = {static_cast<int>(count), model.rigid.body_of_node, responses_};
}

void RigidStage::set_switches(State& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    for (std::size_t k = 0; k < 6; ++k) {
      if (body.switched_by[k] == RigidBody::free) continue;
      const Switch& of = model_.switches.conditions[static_cast<std::size_t>(body.switched_by[k])];
      state.bodies[b].released[k] = !of.is_on(state.happened);
    }
  }
}

void RigidStage::start(State& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    RigidState& now = state.bodies[b];
    const RigidGoal goal = find_rigid_goal(model_, state, b, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (holds(body, now, k)) set(now.velocity, static_cast<int>(k), goal.velocity[k]);
      if (goal.spin.held[k]) set(now.spin, static_cast<int>(k), goal.spin.rate[k]);
    }
    now.spin_momentum = find_inertia(body, now) * now.spin;
  }
  if (joints_.any()) {
    joints_.begin_step(state, growths_);
    const double before = find_kinetic_energy(model_, state.bodies);
    const int parting = joints_.settle(state, state.bodies);
    if (parting >= 0)
      warn_of_start(model_.rigid.joints[static_cast<std::size_t>(parting)], before,
                    find_kinetic_energy(model_, state.bodies));
  }
  next_ = state.bodies;
  upload(state, 0);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
  set_spins(state);
}

void RigidStage::warn_of_start(const Joint& joint, double before, double after) {
  warnings_.push_back({"joint_start",
                       fmt::format("the bodies of joint '{}' begin with velocities that part them there (a joint lets "
                                   "none do so): they begin with those after an impulse of the joints, by which the "
                                   "kinetic energy of the rigid bodies changes from {:.4g} to {:.4g}; give all that "
                                   "it joins velocities that fit, if this is not meant",
                                   joint.name, before, after),
                       joint.place});
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
  copy_values(steps_, steps);
}

/// Takes the change of prescribed motion in the first step away from the velocities of nodes, whose mirror image at
/// time 0 then has it at rest: its work on what it touches is the mean of the motion before and after, as that of the
/// body.
void RigidStage::leave_out_held_motion(const State& state) {
  const Array<BodyStep> free("percuss::free_steps", steps_.extent(0));
  const auto steps = Kokkos::create_mirror_view(free);
  copy_values(steps, steps_);
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const RigidState& now = state.bodies[b];
    for (int k = 0; k < 3; ++k) {
      const auto dof = static_cast<std::size_t>(k);
      if (holds(model_.rigid.bodies[b], now, dof)) set(steps(b).velocity, k, get(now.velocity, k));
      if (holds(model_.rigid.bodies[b], now, dof + 3)) set(steps(b).spin, k, get(now.spin, k));
    }
  }
  copy_values(free, steps);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, free, state.v);
}

/// The bodies at n-1/2; in the first step, as those of nodes, the mirror image at time 0 of what next_ is undamped.
std::vector<RigidState> RigidStage::find_bodies_before(const State& state) const {
  std::vector<RigidState> before = state.bodies;
  if (state.step > 0) return before;
  for (std::size_t b = 0; b < before.size(); ++b) {
    const RigidState &now = state.bodies[b], &next = next_[b];
    before[b].velocity = 2.0 * now.velocity - next.velocity;
    before[b].spin_momentum = 2.0 * now.spin_momentum - next.spin_momentum;
    before[b].spin = 2.0 * now.spin - next.spin;
  }
  return before;
}

/// Impulse of damping by the velocities of before_ and next_, in directions that are not held.
Wrench RigidStage::find_damping_impulse(const State& state, std::size_t index) const {
  const RigidBody& body = model_.rigid.bodies[index];
  const RigidState &now = state.bodies[index], &before = before_[index], &next = next_[index];
  const double h = damping_[index];
  Wrench lost{(-h * body.mass) * (before.velocity + next.velocity), -h * (before.spin_momentum + next.spin_momentum)};
  for (int k = 0; k < 3; ++k) {
    if (holds(body, now, static_cast<std::size_t>(k))) set(lost.impulse, k, 0);
    if (holds(body, now, 3 + static_cast<std::size_t>(k))) set(lost.moment, k, 0);
  }
  return lost;
}

/// Damps what next_ moves freely of a body: its impulse by velocities without damping is 1 + h times as large.
void RigidStage::damp(const State& state, std::size_t index, double dt_mean) {
  const RigidBody& body = model_.rigid.bodies[index];
  const int entry = is_held(body, state.bodies[index]) ? -1 : model_.damped_bodies[index];
  damping_[index] = entry < 0 ? 0 : find_damping(damping_coefficients_[static_cast<std::size_t>(entry)], dt_mean);
  growths_[index] = 1 + damping_[index];
  give_wrench(body, find_damping_impulse(state, index), growths_[index], next_[index]);
}

void RigidStage::predict(State& state, const StepTimes& times) {
  forces_ = find_forces_(model_, state);
  contact_.clear();
  if (!damping_coefficients_.empty() && state.step > 0) return;
  growths_.assign(state.bodies.size(), 1);
  next_ = predict_momenta(model_, state, forces_, times.dt_mean);
  place_bodies(state, times.dt);
  if (state.step == 0 && is_moved_) leave_out_held_motion(state);
}

void RigidStage::change_velocities(State& state, const StepTimes& times) {
  if (damping_coefficients_.empty()) {
    if (state.step == 0 && is_moved_) set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
    return;
  }
  before_ = find_bodies_before(state);
  next_ = predict_momenta(model_, state, forces_, times.dt_mean);
  for (std::size_t b = 0; b < next_.size(); ++b) damp(state, b, times.dt_mean);
  place_bodies(state, times.dt);
}

/// Places bodies by the momenta of next_, to which nothing is added yet; their velocities go to the nodes.
void RigidStage::place_bodies(State& state, double dt) {
  const auto responses = Kokkos::create_mirror_view(responses_);
  for (std::size_t b = 0; b < next_.size(); ++b)
    responses(b) = find_response(model_.rigid.bodies[b], state.bodies[b], growths_[b]);
  copy_values(responses_, responses);
  if (joints_.any()) joints_.begin_step(state, growths_);
  move_bodies(state, dt);
  upload(state, dt);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
}

/// Bodies at n+1 by the momenta of next_, which get the impulses of joints.
void RigidStage::move_bodies(State& state, double dt) {
  free_ = next_;
  for (std::size_t b = 0; b < next_.size(); ++b) move_body(model_, state, b, dt, next_[b]);
  if (!joints_.any()) return;
  for (const int body : joints_.bodies()) {
    const auto b = static_cast<std::size_t>(body);
    next_[b].velocity = free_[b].velocity;
    next_[b].spin_momentum = free_[b].spin_momentum;
  }
  const int lost = joints_.solve(state, dt, next_);
  if (lost >= 0) refuse_step(model_.rigid.joints[static_cast<std::size_t>(lost)], state);
  const double over_dt = 2 / (state.dt + dt);
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    const Wrench& impulse = joints_.of_joints()[j];
    state.joints[j] = {over_dt * impulse.impulse, over_dt * impulse.moment};
  }
}

double RigidStage::bound_component(const State& state, double /*predicted*/) const {
  return find_largest_component(ExecSpace(), state.v);
}

void RigidStage::follow_contact(State& state, const StepTimes& times, const ContactReport* contact) {
  if (contact != nullptr) correct(state, contact->bodies, times.dt);
  set_spins(state);
}

void RigidStage::correct(State& state, const std::vector<Wrench>& contact, double dt) {
  contact_ = contact;
  if (contact.empty()) return;
  const std::vector<RigidState> predicted = next_;
  for (std::size_t b = 0; b < next_.size(); ++b) {
    if (joints_.any()) {
      next_[b].velocity = free_[b].velocity;
      next_[b].spin_momentum = free_[b].spin_momentum;
    }
    give_wrench(model_.rigid.bodies[b], contact[b], growths_[b], next_[b]);
  }
  move_bodies(state, dt);
  if (joints_.any()) book_joined_contact(state, predicted);
  upload(state, dt);
  set_rigid_velocities(ExecSpace(), model_.rigid.nodes, steps_, state.v);
}

/// Contact counts its work with the velocities that free bodies would have; joints change them.
void RigidStage::book_joined_contact(State& state, const std::vector<RigidState>& predicted) const {
  const auto responses = Kokkos::create_mirror_view(responses_);
  copy_values(responses, responses_);
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const BodyChange free = find_change(responses(b), contact_[b]);
    const Vector3<double> v = next_[b].velocity - predicted[b].velocity - free.velocity,
                          w = next_[b].spin - predicted[b].spin - free.spin;
    state.books.contact_work += 0.5 * (dot(contact_[b].impulse, v) + dot(contact_[b].moment, w));
  }
}

void RigidStage::set_spins(const State& state) const {
  if (!model_.has_rotations) return;
  set_rigid_spins(ExecSpace(), model_.rigid.nodes, steps_, state.w);
}

/// Work and moment of the damping of a body; adds its impulse to j.
void RigidStage::book_damping(State& state, std::size_t index, double (&j)[3]) const {
  const Wrench lost = find_damping_impulse(state, index);
  const RigidState &before = before_[index], &next = next_[index];
  const double work = dot(lost.impulse, before.velocity + next.velocity) + dot(lost.moment, before.spin + next.spin);
  state.books.damping_work.add(0.5 * work);
  state.books.damping_work.normalize();
  for (int k = 0; k < 3; ++k) {
    j[k] += get(lost.impulse, k);
    state.books.moment_impulse[k].add(get(lost.moment, k));
  }
}

/// Impulses and the first half of the work of forces and moments on points of a body.
void RigidStage::book_loads(State& state, std::size_t index, double dt, double dt_mean) const {
  const RigidState &now = state.bodies[index], &next = next_[index];
  for (const BodyLoad& load : model_.rigid.bodies[index].loads) {
    const PointForce on = find_point_force(model_, load, state, now, state.time);
    const Vector3<double> impulse = dt_mean * on.force, arm = now.center + on.arm - to_vector(model_.mass_center);
    const double r[3] = {arm.x, arm.y, arm.z}, j[3] = {impulse.x, impulse.y, impulse.z};
    add_impulse(r, j, 0, [&](int k, double value) {
      (k < 3 ? state.books.impulse[k] : state.books.moment_impulse[k - 3]).add(value);
    });
    for (int k = 0; k < 3; ++k) state.books.moment_impulse[k].add(dt_mean * get(on.moment, k));
    state.books.external_work.add(0.5 * dt * find_power(on, next));
  }
}

/// Impulses of the ground on what is joined to it.
void RigidStage::book_grounded_joints(State& state) const {
  for (std::size_t i = 0; i < model_.rigid.joints.size(); ++i) {
    const Joint& joint = model_.rigid.joints[i];
    if (joint.ends[1].body != Joint::ground) continue;
    const Wrench& impulse = joints_.of_joints()[i];
    const Vector3<double> arm = joints_.frame(i).point - to_vector(model_.mass_center);
    const double r[3] = {arm.x, arm.y, arm.z}, j[3] = {impulse.impulse.x, impulse.impulse.y, impulse.impulse.z};
    add_impulse(r, j, 0, [&](int k, double value) {
      (k < 3 ? state.books.impulse[k] : state.books.moment_impulse[k - 3]).add(value);
    });
    for (int k = 0; k < 3; ++k) state.books.moment_impulse[k].add(get(impulse.moment, k));
  }
}

/// Impulse and moment that contact and joints gave to a body in the step.
Wrench RigidStage::find_given(std::size_t index) const {
  Wrench given = contact_.empty() ? Wrench{} : contact_[index];
  if (!joints_.any()) return given;
  given.impulse = given.impulse + joints_.on_bodies()[index].impulse;
  given.moment = given.moment + joints_.on_bodies()[index].moment;
  return given;
}

/// The result is the same on all ranks.
Wrench RigidStage::find_reaction(const State& state, std::size_t index, double dt_mean) const {
  const RigidBody& body = model_.rigid.bodies[index];
  const RigidState &now = state.bodies[index], &next = next_[index];
  const Wrench given = find_given(index);
  Wrench reaction;
  for (int k = 0; k < 3; ++k) {
    const auto dof = static_cast<std::size_t>(k);
    const double m = body.mass, f = get(forces_[index].impulse, k), t = get(forces_[index].moment, k);
    const double change = m * (get(next.velocity, k) - get(now.velocity, k)) - get(given.impulse, k);
    if (holds(body, now, dof)) set(reaction.impulse, k, change - dt_mean * (f + m * state.gravity.g[k]));
    const double turned = get(next.spin_momentum, k) - get(now.spin_momentum, k) - get(given.moment, k);
    if (holds(body, now, dof + 3)) set(reaction.moment, k, turned - dt_mean * t);
  }
  return reaction;
}

void RigidStage::book_motion(State& state, const StepTimes& times) {
  const double dt = times.dt, dt_mean = times.dt_mean;
  for (std::size_t b = 0; b < next_.size(); ++b) reactions_[b] = find_reaction(state, b, dt_mean);
  if (model_.ranks.rank() != 0) return;
  const double share = model_.gravity_varies ? 0.5 : 1;  // of the step: the other half is of that at n+1
  for (std::size_t b = 0; b < next_.size(); ++b) {
    const RigidBody& body = model_.rigid.bodies[b];
    const RigidState &now = state.bodies[b], &next = next_[b];
    const Wrench given = find_given(b);  // the work of joints on both bodies is none
    const Wrench &force = forces_[b], &reaction = reactions_[b];
    double j[3] = {reaction.impulse.x, reaction.impulse.y, reaction.impulse.z}, work = 0;
    for (int k = 0; k < 3; ++k) {
      const auto dof = static_cast<std::size_t>(k);
      const double g = state.gravity.g[k], m = body.mass, p = get(given.impulse, k), f = get(force.impulse, k);
      const double v0 = get(now.velocity, k), v1 = get(next.velocity, k), change = m * (v1 - v0) - p;
      if (holds(body, now, dof)) work += 0.5 * change * (v0 + v1) - dt * v1 * (0.5 * f + share * m * g);
      if (!holds(body, now, dof + 3)) continue;
      const double w0 = get(now.spin, k), w1 = get(next.spin, k), t = get(force.moment, k);
      const double turned = get(next.spin_momentum, k) - get(now.spin_momentum, k) - get(given.moment, k);
      state.books.moment_impulse[k].add(get(reaction.moment, k));
      work += 0.5 * turned * (w0 + w1) - 0.5 * dt * w1 * t;
    }
    if (!damping_coefficients_.empty()) book_damping(state, b, j);
    book_loads(state, b, dt, dt_mean);
    const double r[3] = {now.center.x - model_.mass_center[0], now.center.y - model_.mass_center[1],
                         now.center.z - model_.mass_center[2]};
    add_impulse(r, j, 0, [&](int k, double value) {
      (k < 3 ? state.books.impulse[k] : state.books.moment_impulse[k - 3]).add(value);
    });
    state.books.external_work.add(work);
  }
  book_grounded_joints(state);
  for (ExactSum* sum : {state.books.impulse, state.books.moment_impulse})
    for (int k = 0; k < 3; ++k) sum[k].normalize();
  state.books.external_work.normalize();
}

void RigidStage::move(State& state, const StepTimes& /*times*/) {
  place_rigid_nodes(ExecSpace(), model_.rigid.nodes, steps_, state.x);
  state.bodies = next_;
}

void RigidStage::book_forces(State& state, double dt, double time, bool takes_gravity) {
  for (std::size_t b = 0; model_.ranks.rank() == 0 && b < state.bodies.size(); ++b) {
    for (const BodyLoad& load : model_.rigid.bodies[b].loads) {
      const PointForce on = find_point_force(model_, load, state, state.bodies[b], time);
      state.books.external_work.add(0.5 * dt * find_power(on, state.bodies[b]));
      state.books.external_work.normalize();
    }
  }
  if (!is_moved_) return;
  const auto& bodies = model_.rigid.bodies;
  const std::vector<Wrench> forces = find_forces_(model_, state, time);
  if (model_.ranks.rank() != 0) return;
  const Gravity rest = model_.gravity_varies || takes_gravity ? state.gravity : Gravity{};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RigidState& now = state.bodies[b];
    double power = 0;
    const Vector3<double> weight = bodies[b].mass * Vector3<double>{rest.g[0], rest.g[1], rest.g[2]};
    for (int k = 0; k < 3; ++k) {
      const auto dof = static_cast<std::size_t>(k);
      if (holds(bodies[b], now, dof)) power += get(now.velocity, k) * (get(forces[b].impulse, k) + get(weight, k));
      if (holds(bodies[b], now, dof + 3)) power += get(now.spin, k) * get(forces[b].moment, k);
    }
    state.books.external_work.add(-0.5 * dt * power);
  }
  state.books.external_work.normalize();
}

double RigidStage::largest_step(const State& state) const {
  if (!model_.rigid.is_all) return std::numeric_limits<double>::infinity();
  constexpr double share_of_end = 1e-3, share_of_edge = 0.2, turn_of_step = 0.02;  // rad
  double step = share_of_end * end_;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidState& now = state.bodies[b];
    const double spin = norm(now.spin), speed = norm(now.velocity) + spin * model_.rigid.bodies[b].radius;
    if (speed > 0) step = std::min(step, share_of_edge * model_.rigid.least_edge / speed);
    if (spin > 0) step = std::min(step, turn_of_step / spin);
  }
  return step;
}

void RigidStage::archive(CheckpointArchive& archive, State& state) {
  archive.each("bodies", state.bodies, [](RigidState& s, const auto& take) {
    take(s.center.x, s.center.y, s.center.z, s.orientation.w, s.orientation.x, s.orientation.y, s.orientation.z);
    for (Vector3<double>* const v : {&s.velocity, &s.spin_momentum, &s.spin}) take(v->x, v->y, v->z);
  });
  archive.each("joints", state.joints, [](JointState& s, const auto& take) {
    take(s.force.x, s.force.y, s.force.z, s.moment.x, s.moment.y, s.moment.z);
  });
}

std::vector<HistoryColumn> RigidStage::list_columns() const {
  std::vector<HistoryColumn> columns = list_body_columns(model_.rigid);
  const std::vector<HistoryColumn> of_joints = list_joint_columns(model_.rigid);
  columns.insert(columns.end(), of_joints.begin(), of_joints.end());
  return columns;
}

void RigidStage::append_values(const State& state, std::vector<double>& row) {
  columns_.append(model_, state, row);
  append_joints(model_, state, row);
}

}  // namespace percuss
