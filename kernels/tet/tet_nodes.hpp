#pragma once
// The nodes over which the mixed form averages.

#include <cstdint>

#include "kernels/core/views.hpp"

namespace percuss {

/// The records of nodes with tetrahedra, one for each material of theirs; const after set-up.
struct TetNodes {
  int count = 0;
  Array<int> first;             // [count + 1] into slots
  Array<int> slots;             // of each record in the order of its sum, those of other ranks among them
  Array<int> slots_to_records;  // [slots of this rank's chunks] -1: of no tetrahedron
  // Slots of a chunk in groups of group_size that have about as many corners of elements: sums of a group do not wait
  // for each other.
  static constexpr int group_size = 4;
  Array<int> first_group;            // [chunks + 1]
  Array<std::uint16_t> group_slots;  // [groups][group_size] slot within the chunk, no_slot: none
  Array<int> first_corner;           // [groups + 1] rows of corners
  Array<std::uint16_t> corners;      // [rows][group_size] 8 i + k for the slot's corner k of element i of the chunk, in
                                     // ascending order; past its last one the element past the lanes of the chunk
  static constexpr int no_slot = 65535;
  Array<double> deviator_share;  // [chunks] share of the averaged deviator that their material takes
  int largest_lane_count = 0;    // lanes of the packs of the chunk that has most
};

}  // namespace percuss
