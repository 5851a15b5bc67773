#include "src/step/rigid/rigid_forces.hpp"

#include "comm/exact_reduction.hpp"
#include "src/index.hpp"

namespace percuss {

PointForce find_point_force(const Model& model, const BodyLoad& load, const State& state, const RigidState& body,
                            double time) {
  const Vector3<double> arm = find_rotation(body.orientation) * load.arm;
  if (!model.switches.nodal_loads[load.load].is_on(state.happened)) return {arm, {0, 0, 0}, {0, 0, 0}};
  const std::array<Curve, 6>& value = model.nodal_values[load.load];
  return {arm, {value[0](time), value[1](time), value[2](time)}, {value[3](time), value[4](time), value[5](time)}};
}

std::vector<Wrench> RigidForces::operator()(const Model& model, const State& state, double time) {
  std::vector<Wrench> forces = sum_nodes(model, state);
  for (std::size_t b = 0; b < forces.size(); ++b) {
    for (const BodyLoad& load : model.rigid.bodies[b].loads) {
      const PointForce on = find_point_force(model, load, state, state.bodies[b], time);
      forces[b].impulse = forces[b].impulse + on.force;
      forces[b].moment = forces[b].moment + on.moment + cross(on.arm, on.force);
    }
  }
  for (std::size_t s = 0; s < state.turn_springs.size(); ++s) {
    const auto [first, second] = model.turn_springs[s].body;
    forces[at(first)].moment = forces[at(first)].moment - state.turn_springs[s].moment;
    forces[at(second)].moment = forces[at(second)].moment + state.turn_springs[s].moment;
  }
  return forces;
}

std::vector<Wrench> RigidForces::sum_nodes(const Model& model, const State& state) {
  std::vector<Wrench> forces(model.rigid.bodies.size());
  if (!model.rigid.is_loaded) return forces;
  std::vector<Vector3<double>> centers;
  for (const RigidState& body : state.bodies) centers.push_back(body.center);
  sum_rigid_forces(ExecSpace(), model.rigid.loads, {model.nodes_to_slots, state.slot_force, state.slot_moment, state.x},
                   centers, memory_, sums_);
  sum_over_ranks(model.ranks, sums_);
  for (std::size_t b = 0; b < forces.size(); ++b) forces[b] = round_wrench(sums_, b);
  return forces;
}

}  // namespace percuss
