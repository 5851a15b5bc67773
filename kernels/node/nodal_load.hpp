#pragma once
// Forces and moments on nodes, each in a fixed direction.

#include "kernels/core/views.hpp"

namespace percuss {

/// Loaded nodes; const after set-up except for `share`. Entry i writes its force and its moment to the slot first_slot
/// + i.
struct NodalLoads {
  Array<int> node;
  Array<int> load;      // which load acts on it
  Array<double> share;  // 0: the node is gone; empty: every node has its load
  int first_slot = 0;
  int count = 0;
};

/// Six numbers a load: the force on each of its nodes, then the moment.
using NodalLoadValues = Kokkos::View<double* [6], Kokkos::LayoutRight, MemSpace>;

/// Sets the loads' slots. slot_moment: empty without shells, then there are no moments.
void apply_nodal_loads(const ExecSpace& space, const NodalLoads& loads, const NodalLoadValues& values,
                       const Rows3<double>& slot_force, const Rows3<double>& slot_moment);

}  // namespace percuss
