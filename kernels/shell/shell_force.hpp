#pragma once
// Launcher of the shells' part of a step: (1.3) to (1.5) of the paper, for all chunks of shells.
//
// They lie in the tables of all chunks (kernels/element/element_chunks.hpp) and write to the same slots, so that nodes
// add up what shells and hexahedra give them in one order. A shell takes the first four of the eight corners there.

#include <tuple>

#include "kernels/element/element_chunks.hpp"
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

/// The motion that shells see: positions at n+1, velocities and angular velocities at n+1/2, the step between.
struct ShellMotion {
  Rows3<const double> x;
  Rows3<const double> v;
  Rows3<const double> w;
  double dt = 0;
  bool skips_rest = false;  // as ElementMotion::skips_rest
  FailingChunks failing{};  // as ElementMotion's
  ElementLives lives{};
  Array<double> bound{};  // [elements] out: step bound of each shell, without the deck's scale; empty: nobody asks
};

/// Advances every shell from n to n+1.
void advance_shells(const ExecSpace& space, const ElementChunks& chunks, const ShellBlocks& blocks,
                    const ShellMotion& motion, const ChunkFields& fields);

}  // namespace percuss
