#include "src/step/rigid/rigid_sums.hpp"

namespace percuss {
namespace {

/// Kinetic energy of the rotation: forces on held ones move nothing.
double find_turning_energy(const RigidBody& body, const RigidState& state, const Vector3<double>& moment, double dt) {
  const Symmetric3<double> inertia = find_inertia(body, state);
  const Symmetric3<double> inverse = find_free_inverse(body, state);
  Vector3<double> held_rate{0, 0, 0};
  for (int k = 0; k < 3; ++k)
    if (body.holds(3 + static_cast<std::size_t>(k))) set(held_rate, k, get(state.spin, k));
  const Vector3<double> of_held = inertia * held_rate;
  const Vector3<double> before = inverse * (state.spin_momentum - of_held) + held_rate;
  const Vector3<double> after = inverse * (state.spin_momentum + dt * moment - of_held) + held_rate;
  return 0.5 * dot(before, inertia * after);
}

}  // namespace

RigidSums sum_rigid_body(const Model& model, const State& state, std::size_t index, const Wrench& force) {
  const RigidBody& body = model.rigid.bodies[index];
  const RigidState& now = state.bodies[index];
  const double dt = state.step == 0 ? 0.0 : state.dt, first_dt = state.step == 0 ? state.next_dt : 0.0;
  const double m = body.mass;
  const Gravity constant = find_constant_gravity(model);
  RigidSums sums;
  for (int k = 0; k < 3; ++k) {
    const double v = get(now.velocity, k), g = state.gravity.g[k], f = get(force.impulse, k) + m * g;
    const bool is_free = !body.holds(static_cast<std::size_t>(k));
    sums.kinetic += 0.5 * v * (m * v + (is_free ? dt * f : 0));
    if (is_free) sums.half_steps += 0.125 / m * (first_dt * f) * (first_dt * f);
    sums.fallen += m * constant.g[k] * (get(now.center, k) - get(body.center, k));
  }
  sums.kinetic += find_turning_energy(body, now, force.moment, dt);
  const Vector3<double> turned = first_dt * force.moment;
  sums.half_steps += 0.125 * dot(turned, find_free_inverse(body, now) * turned);
  const Vector3<double> r = now.center - to_vector(model.mass_center);
  sums.momentum = m * now.velocity;
  sums.angular = cross(r, sums.momentum) + now.spin_momentum;
  sums.momentum_size = norm(sums.momentum);
  sums.angular_size = norm(r) * sums.momentum_size + norm(now.spin_momentum);
  return sums;
}

}  // namespace percuss
