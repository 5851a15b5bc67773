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
  for (std::size_t b = 0; b < forces.size(); ++b) {
    double v[6];
    for (std::size_t k = 0; k < 6; ++k) v[k] = sums_[6 * b + k].round();
    forces[b] = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  }
  return forces;
}

}  // namespace percuss
