#pragma once
// Launcher of the element part of a step: (1.3) to (1.5) of the paper, for all chunks.

#include <tuple>

#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_motion.hpp"
#include "kernels/element/hex8/thick_shell.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"

namespace percuss {

/// Chunks of one compiled-in material of solids, or of CalledMaterial, for all others.
template <class M>
struct SolidBlock {
  using Material = M;
  Array<int> chunks;                                       // ascending chunk ids
  Kokkos::View<SolidParameters<M>*, MemSpace> parameters;  // by ElementChunks::parameters
};

/// One compiled variant of the hexahedron.
template <class Material, HexKind Kind>
struct HexBlock : SolidBlock<Material> {};

/// The materials that the element is compiled for: those that say so, and one that calls all others.
using CompiledMaterials = TypeList<Elastic, J2Plasticity, CalledMaterial>;

template <class List>
struct AllHexBlocks;
template <class... Material>
struct AllHexBlocks<TypeList<Material...>> {
  using type = std::tuple<HexBlock<Material, HexKind::assumed_strain>..., HexBlock<Material, HexKind::stiffness>...,
                          HexBlock<Material, HexKind::viscous>..., HexBlock<Material, HexKind::full>...,
                          HexBlock<Material, HexKind::thick3>..., HexBlock<Material, HexKind::thick5>...>;
};
/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using HexBlocks = AllHexBlocks<CompiledMaterials>::type;

/// Advances every element from n to n+1.
void advance_elements(const ExecSpace& space, const ElementChunks& chunks, const HexBlocks& blocks,
                      const ElementMotion& motion, const ChunkFields& fields);

/// Advances the elements of one variant; compiled in a file for each material.
template <class Material, HexKind Kind>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const HexBlock<Material, Kind>& block,
                   const ElementMotion& motion, const ChunkFields& fields);

}  // namespace percuss
