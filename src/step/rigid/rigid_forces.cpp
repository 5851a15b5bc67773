#include "src/step/rigid/rigid_forces.hpp"

#include "comm/exact_reduction.hpp"

namespace percuss {

std::vector<Wrench> RigidForces::operator()(const Model& model, const State& state) {
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
