#pragma once
// A box of hexahedra in chunks, made without a deck and without a library: what the benchmark of a device needs.
//
// Nothing here calls the mathematical library, so that any two machines start from the same bits.

#include "kernels/element/advance_by_threads.hpp"
#include "kernels/node/motion.hpp"

namespace percuss {

/// Parameters of a box.
struct BoxPlan {
  int cells = 8;        // along each edge of length 1
  int chunk_cells = 8;  // likewise of a chunk; divides cells
  int lanes = 1;        // elements whose numbers lie side by side
  int record_size = 0;  // scalars of an element
  double density = 7850;
};

/// A box between two steps, distorted a little; it spins, and its corners fly apart.
struct Box {
  int node_count = 0, element_count = 0;
  ElementChunks chunks;
  SlotCorners slot_corners;
  NodeSlots nodes_to_slots;
  Rows3<double> inverse_mass, x, v;
  ChunkFields fields;
};

Box make_box(const BoxPlan& plan);

}  // namespace percuss
