#include "src/step/rigid/rigid_sums.hpp"

#include <cmath>

#include "src/step/rigid/inertia.hpp"

namespace percuss {
namespace {

/// Spins before n and after it, as the moments at n have them: those on held rotations move nothing.
struct SpinPair {
  Vector3<double> before{}, after{};
};

SpinPair find_spins(const RigidBody& body, const RigidState& state, const BodyForces& on, double dt) {
  const Vector3<double> moment = on.force.moment + on.joint.moment;
  const Symmetric3<double> inverse = find_free_inverse(body, state);
  Vector3<double> held_rate{0, 0, 0};
  for (int k = 0; k < 3; ++k)
    if (holds(body, state, 3 + static_cast<std::size_t>(k))) set(held_rate, k, get(state.spin, k));
  const Vector3<double> of_held = find_inertia(body, state) * held_rate;
  return {inverse * (state.spin_momentum - of_held) + held_rate,
          inverse * (state.spin_momentum + dt * moment - of_held) + held_rate};
}

/// Kinetic energy of the rotation. Joints move held ones at their other body, which they move with.
double find_turning_energy(const RigidBody& body, const RigidState& state, const BodyForces& on, double dt) {
  const SpinPair spins = find_spins(body, state, on, dt);
  double of_joints = 0;
  for (int k = 0; k < 3; ++k)
    if (holds(body, state, 3 + static_cast<std::size_t>(k)))
      of_joints += get(state.spin, k) * dt * get(on.joint.moment, k);
  return 0.5 * dot(spins.before, find_inertia(body, state) * spins.after) + 0.5 * of_joints;
}

}  // namespace

std::vector<BodyForces> BodyForceFinder::operator()(const State& state) {
  const std::vector<Wrench> forces = find_forces_(model_, state);
  const std::vector<Wrench> of_joints = find_joint_forces(joints_, model_, state, forces);
  std::vector<BodyForces> found;
  for (std::size_t b = 0; b < forces.size(); ++b)
    found.push_back({forces[b], of_joints.empty() ? Wrench{{0, 0, 0}, {0, 0, 0}} : of_joints[b]});
  return found;
}

RigidSums sum_rigid_body(const Model& model, const State& state, std::size_t index, const BodyForces& on) {
  const RigidBody& body = model.rigid.bodies[index];
  const RigidState& now = state.bodies[index];
  const double dt = state.step == 0 ? 0.0 : state.dt, first_dt = state.step == 0 ? state.next_dt : 0.0;
  const double m = body.mass;
  const Gravity constant = find_constant_gravity(model);
  RigidSums sums;
  for (int k = 0; k < 3; ++k) {
    const double v = get(now.velocity, k), g = state.gravity.g[k], joint = get(on.joint.impulse, k);
    const double f = get(on.force.impulse, k) + m * g + joint;
    const bool is_free = !holds(body, now, static_cast<std::size_t>(k));
    sums.kinetic += 0.5 * v * (m * v + dt * (is_free ? f : joint));
    if (is_free) sums.half_steps += 0.125 / m * (first_dt * f) * (first_dt * f);
    sums.fallen += m * constant.g[k] * (get(now.center, k) - get(body.center, k));
  }
  sums.kinetic += find_turning_energy(body, now, on, dt);
  const Vector3<double> turned = first_dt * (on.force.moment + on.joint.moment);
  sums.half_steps += 0.125 * dot(turned, find_free_inverse(body, now) * turned);
  const Vector3<double> r = now.center - to_vector(model.mass_center);
  sums.momentum = m * now.velocity;
  sums.angular = cross(r, sums.momentum) + now.spin_momentum;
  sums.momentum_size = norm(sums.momentum);
  // As of its nodes, which lie about its radius of gyration from its centre: a body that falls from the scene's own
  // mass centre has no moment to compare with otherwise.
  const double reach = norm(r) + std::sqrt(0.5 * trace(body.inertia) / m);
  sums.angular_size = reach * sums.momentum_size + norm(now.spin_momentum);
  return sums;
}

RigidSums sum_rigid_chunk(const Model& model, const State& state, const RigidChunk& chunk, const BodyForces& on) {
  const auto index = static_cast<std::size_t>(chunk.body);
  const RigidBody& body = model.rigid.bodies[index];
  const RigidState& now = state.bodies[index];
  const double dt = state.step == 0 ? 0.0 : state.dt;
  const Matrix3<double> rotation = find_rotation(now.orientation);
  const Vector3<double> arm = rotation * (chunk.center - body.center);
  const SpinPair spins = find_spins(body, now, on, dt);
  Vector3<double> next = now.velocity;
  for (int k = 0; k < 3; ++k) {
    const bool is_free = !holds(body, now, static_cast<std::size_t>(k));
    const double f =
        (is_free ? get(on.force.impulse, k) + body.mass * state.gravity.g[k] : 0) + get(on.joint.impulse, k);
    set(next, k, get(next, k) + dt * f / body.mass);
  }
  const Vector3<double> before = now.velocity + cross(spins.before, arm), after = next + cross(spins.after, arm);
  const Symmetric3<double> inertia = to_inertia(push_forward(rotation, chunk.second));
  RigidSums sums;
  sums.kinetic = 0.5 * (chunk.mass * dot(before, after) + dot(spins.before, inertia * spins.after));
  sums.momentum = chunk.mass * before;
  return sums;
}

}  // namespace percuss
