#pragma once
// How fast a unit impulse makes nodes: what springs and glue ask of the step depends on it.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Rigid body of each of `count` nodes that connections name, from its owner; -1: none. owned_node, owned_place: as in
/// ConnectedNodes. Collective.
inline std::vector<int> share_bodies(const Model& model, std::size_t count, const Array<const int>& owned_node,
                                     const Array<const int>& owned_place) {
  std::vector<int> bodies(count, -1);
  if (!model.rigid.any()) return bodies;
  const auto nodes = to_host(owned_node), places = to_host(owned_place);
  const auto body_of_node = to_host(model.rigid.body_of_node);
  for (std::size_t i = 0; i < nodes.extent(0); ++i) bodies[at(places(i))] = body_of_node(nodes(i));
  all_reduce(model.ranks, Reduce::largest, bodies);
  return bodies;
}

/// Bound on the speed that a unit impulse on a node of a body gives to the node.
inline double bound_mobility(const RigidBody& body, const RigidState& state, const Vector3<double>& place) {
  const bool is_fixed = body.always_holds(0) && body.always_holds(1) && body.always_holds(2);
  const Vector3<double> arm = place - state.center;
  return (is_fixed ? 0 : 1 / body.mass) + dot(arm, arm) * trace(find_free_inverse(body, state));
}

/// A node and its largest inverse mass in a direction; below 0: the node is gone.
struct MobileNode {
  Vector3<double> place;
  double inverse_mass = 0;
};

/// The inverse mass, or the mobility of the rigid body, -1: none, that the node belongs to.
inline double find_mobility(const Model& model, const State& state, int body, const MobileNode& node) {
  return body < 0 ? std::max(node.inverse_mass, 0.0)
                  : bound_mobility(model.rigid.bodies[at(body)], state.bodies[at(body)], node.place);
}

}  // namespace percuss
