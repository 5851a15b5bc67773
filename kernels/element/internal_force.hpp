#pragma once
// Launchers of the element part of a step: (1.3) to (1.5) of the paper's Figure 1 for all chunks of one variant.

#include "kernels/element/hex_chunks.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/j2_plasticity.hpp"

namespace percuss {

/// The motion that the elements see: positions at n+1, velocities at n+1/2, the step between n and n+1.
struct ElementMotion {
  Rows3<const double> x;
  Rows3<const double> v;
  double dt = 0;
};

/// One compiled variant of the element: a material and an hourglass control, with the chunks that use it.
template <class Material, HourglassKind Kind>
struct HexBlock {
  Array<int> chunks;                                                       // ascending chunk ids
  Kokkos::View<HexParameters<Material>*, MemSpace> parameters;             // by HexChunks::parameters
};

/// Advances every element of the block's chunks from n to n+1. state: element records, in and out. slot_force: out,
/// the chunk's share of the internal force of its nodes. results: out, work is added to.
template <class Material, HourglassKind Kind>
void advance_elements(const ExecSpace& space, const HexChunks& chunks, const HexBlock<Material, Kind>& block,
                      const ElementMotion& motion, const Array<double>& state, const Rows3<double>& slot_force,
                      const ChunkResults& results);

extern template void advance_elements(const ExecSpace&, const HexChunks&, const HexBlock<Elastic, HourglassKind::stiffness>&,
                                      const ElementMotion&, const Array<double>&, const Rows3<double>&, const ChunkResults&);
extern template void advance_elements(const ExecSpace&, const HexChunks&, const HexBlock<Elastic, HourglassKind::viscous>&,
                                      const ElementMotion&, const Array<double>&, const Rows3<double>&, const ChunkResults&);
extern template void advance_elements(const ExecSpace&, const HexChunks&,
                                      const HexBlock<J2Plasticity, HourglassKind::stiffness>&, const ElementMotion&,
                                      const Array<double>&, const Rows3<double>&, const ChunkResults&);
extern template void advance_elements(const ExecSpace&, const HexChunks&,
                                      const HexBlock<J2Plasticity, HourglassKind::viscous>&, const ElementMotion&,
                                      const Array<double>&, const Rows3<double>&, const ChunkResults&);

}  // namespace percuss
