#pragma once
// The node part of a step: (1.2) and (1.6) of the paper, and the assembly that feeds it.

#include "kernels/core/views.hpp"

namespace percuss {

/// Slots that a node sums, in their fixed order; const after set-up.
struct NodeSlots {
  Array<int> first;  // [nodes + 1]
  Array<int> slots;  // ascending: chunk by chunk, then pressure faces
};

/// Constant acceleration of every free direction [length / time^2].
struct Gravity {
  double g[3] = {0, 0, 0};
};

/// Force of each node: its slots summed in ascending order. Shape [nodes][3].
void assemble_slots(const ExecSpace& space, const NodeSlots& nodes_to_slots, const Rows3<const double>& slot_force,
                    const Rows3<double>& force);

/// Forces and masses of the nodes at n.
struct NodeForces {
  NodeSlots nodes_to_slots;
  Rows3<const double> slot_force;
  Rows3<const double> inverse_mass;  // 0 in fixed directions
  Gravity gravity;
  // [nodes] those of inertia 0 stay as they are, and so do their force and v_before; empty: all nodes have inertia.
  Array<const double> inertia{};
};

/// v(n+1/2) = v(n-1/2) + dt_mean (f / m + g) in each direction with a finite mass; fixed directions keep their
/// velocity. force, v_before: out, f(n) as assemble_slots gives it and v(n-1/2), for what acts on nodes besides.
void predict_velocities(const ExecSpace& space, const NodeForces& forces, double dt_mean, const Rows3<double>& force,
                        const Rows3<double>& v_before, const Rows3<double>& v);

/// Predicts as above, and returns the largest magnitude of a component of v(n+1/2).
double predict_and_measure(const ExecSpace& space, const NodeForces& forces, double dt_mean, const Rows3<double>& force,
                           const Rows3<double>& v_before, const Rows3<double>& v);

/// predict_velocities() and move_nodes() in one pass, for nodes on which nothing else acts; to the same bits.
void advance_free_nodes(const ExecSpace& space, const NodeForces& forces, double dt_mean, double dt,
                        const Rows3<double>& v, const Rows3<double>& x);

/// v(-1/2) = 2 v(0) - v*(1/2), the velocity from which the forces at 0 lead over v(0) to v*(1/2): with it the work of
/// the impulses of the first step is that of any other. v_before: in v(0), out v(-1/2).
void mirror_velocities(const ExecSpace& space, const Rows3<const double>& v, const Rows3<double>& v_before);

/// x(n+1) = x(n) + dt v(n+1/2).
void move_nodes(const ExecSpace& space, const Rows3<const double>& v, double dt, const Rows3<double>& x);

/// Moves as above, and returns the largest magnitude of a component of v.
double move_and_measure(const ExecSpace& space, const Rows3<const double>& v, double dt, const Rows3<double>& x);

/// The largest magnitude of a component of the velocities of all nodes, or of `count` nodes in a list.
double find_largest_component(const ExecSpace& space, const Rows3<const double>& v);
double find_largest_component(const ExecSpace& space, const Array<const int>& nodes, int count,
                              const Rows3<const double>& v);

}  // namespace percuss
