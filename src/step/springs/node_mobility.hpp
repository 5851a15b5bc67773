#pragma once
// How fast a unit impulse makes nodes: what springs and glue ask of the step depends on it.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "src/index.hpp"
#include "src/step/springs/gathered_rows.hpp"

namespace percuss {

/// Bound on the speed that a unit impulse on a node of a body gives to the node.
inline double bound_mobility(const RigidBody& body, const RigidState& state, const Vector3<double>& place) {
  const bool is_fixed = body.always_holds(0) && body.always_holds(1) && body.always_holds(2);
  const Vector3<double> arm = place - state.center;
  return (is_fixed ? 0 : 1 / body.mass) + dot(arm, arm) * trace(find_free_inverse(body, state));
}

/// Mobility by node: the largest inverse mass in a direction, or the mobility of its rigid body there. body_of_node: of
/// share_bodies().
template <class Row>
std::vector<double> find_mobilities(const Model& model, const State& state, const std::vector<int>& body_of_node,
                                    const GatheredRows<Row>& nodes) {
  std::vector<double> mobilities;
  for (std::size_t n = 0; n < body_of_node.size(); ++n) {
    const int body = body_of_node[n];
    mobilities.push_back(
        body < 0 ? std::max(nodes.value(n, Row::mobility), 0.0)  // a node that is gone has none
                 : bound_mobility(model.rigid.bodies[at(body)], state.bodies[at(body)], nodes.vector(n, Row::place)));
  }
  return mobilities;
}

}  // namespace percuss
