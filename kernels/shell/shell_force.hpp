#pragma once
// Launcher of the shells' part of a step: (1.3) to (1.5) of the paper, for all chunks of shells.
//
// They lie in the tables of all chunks (kernels/element/element_chunks.hpp) and write to the same slots, so that nodes
// add up what shells and hexahedra give them in one order. A shell takes the first four of the eight corners there.

#include <tuple>

#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_motion.hpp"
#include "kernels/shell/fabric.hpp"
#include "kernels/shell/hardening_layer.hpp"
#include "kernels/shell/laminate.hpp"
#include "kernels/shell/shell4.hpp"
#include "kernels/shell/shell_record.hpp"

namespace percuss {

/// Chunks of one material of layers.
template <class Layer>
struct ShellBlock {
  Array<int> chunks;                                           // ascending chunk ids
  Kokkos::View<ShellParameters<Layer>*, MemSpace> parameters;  // by ElementChunks::parameters
  bool has_triangles = false;                                  // among their elements
};

/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using ShellBlocks = std::tuple<ShellBlock<ElasticLayer>, ShellBlock<J2Layer>, ShellBlock<HardeningLayer>,
                               ShellBlock<LaminateLayer>, ShellBlock<FabricLayer>>;

/// Advances every shell from n to n+1.
void advance_shells(const ExecSpace& space, const ElementChunks& chunks, const ShellBlocks& blocks,
                    const ElementMotion& motion, const ChunkFields& fields);

}  // namespace percuss
