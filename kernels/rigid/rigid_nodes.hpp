#pragma once
// The nodes of rigid bodies: they stand where the body puts them and move as it does.

#include <vector>

#include "kernels/core/exact_sum.hpp"
#include "kernels/node/motion.hpp"
#include "kernels/rigid/body_response.hpp"

namespace percuss {

/// The nodes of all bodies that this rank has, copies included; const after set-up.
struct RigidNodes {
  int count = 0;
  Array<int> node;    // [count] mesh node, ascending
  Array<int> body;    // [count]
  Rows3<double> arm;  // [count] from the centre at time 0
};

/// A body over a step, in the places of n and of n+1.
struct BodyStep {
  Vector3<double> center{}, next_center{};
  Matrix3<double> rotation{}, next_rotation{};
  Vector3<double> velocity{}, spin{};  // between both: V and w of rigid_motion.hpp
};

/// v(n+1/2) of the nodes: exactly what takes them from their places at n to those at n+1.
void set_rigid_velocities(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                          const Rows3<double>& v);

/// Places at n+1.
void place_rigid_nodes(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                       const Rows3<double>& x);

/// w(n+1/2) of the nodes: that of the body.
void set_rigid_spins(const ExecSpace& space, const RigidNodes& nodes, const Array<const BodyStep>& bodies,
                     const Rows3<double>& w);

/// The nodes of this rank on which something may act, body after body; const after set-up.
struct RigidLoads {
  Array<int> node;         // [count] mesh node, owned
  std::vector<int> first;  // [bodies + 1]
};

/// Forces on nodes, by slots, and their places at n.
struct NodalForces {
  NodeSlots nodes_to_slots;
  Rows3<const double> force, moment;  // [slots]; moment: empty without rotations of nodes
  Rows3<const double> x;              // [nodes]
};

/// Force and moment about the centre of each body: this rank's share, six exact sums a body.
void sum_rigid_forces(const ExecSpace& space, const RigidLoads& loads, const NodalForces& forces,
                      const std::vector<Vector3<double>>& centers, ExactSums<6>& memory, std::vector<ExactSum>& sums);

/// Force and moment on a body, rounded from the exact sums.
Wrench round_wrench(const std::vector<ExactSum>& sums, std::size_t body);

}  // namespace percuss
