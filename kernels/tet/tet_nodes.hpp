#pragma once
// The nodes over which the mixed form averages.

#include "kernels/core/views.hpp"

namespace percuss {

/// The records of nodes with tetrahedra, one for each material of theirs; const after set-up.
struct TetNodes {
  int count = 0;
  Array<int> first;             // [count + 1] into slots
  Array<int> slots;             // of each record in the order of its sum, those of other ranks among them
  Array<int> slots_to_records;  // [slots of this rank's chunks] -1: of no tetrahedron
};

}  // namespace percuss
