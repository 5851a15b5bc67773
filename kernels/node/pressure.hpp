#pragma once
// Pressure on faces: a follower load on the current area, or a dead load on the area at the start.

#include "kernels/core/views.hpp"

namespace percuss {

/// Loaded faces; const after set-up. Face f writes its four corner shares to the slots first_slot + 4 f + corner.
struct PressureFaces {
  Rows4<int> nodes;          // corners, outward by the right-hand rule
  Array<int> load;           // which pressure acts on the face
  Rows3<double> dead_share;  // of a dead load: what unit pressure puts on each corner [area]; 0: the load follows
  Array<double> share;       // 0: no load any more; empty: every face has its load
  Array<int> first_of_run;   // [runs + 1] faces of an entry of the deck on a chunk, which are the same on any ranks
  int first_slot = 0;
  int count = 0;
  int run_count = 0;
};

/// What the faces of a run amount to. Old forces: those in the slots before.
struct PressureSum {
  enum : int { force, moment = force + 3, old_power = moment + 3, power, count };
};
using PressureSums = Kokkos::View<double * [PressureSum::count], Kokkos::LayoutRight, MemSpace>;

/// Places and velocities of the corners, and the point about which moments are taken.
struct PressedNodes {
  Rows3<const double> x, v;
  double center[3];
};

/// A follower load is -p int N_i n dA over the bilinear face, exactly: the gradient of the volume behind it; of a
/// triangle (a corner stands twice) a third of the load for each node. Dead loads: p times their share on each corner.
/// pressure: by load [stress]. sums: out, [runs], with the faces of a run in their order.
void apply_pressure(const ExecSpace& space, const PressureFaces& faces, const Array<const double>& pressure,
                    const PressedNodes& nodes, const Rows3<double>& slot_force, const PressureSums& sums);

}  // namespace percuss
