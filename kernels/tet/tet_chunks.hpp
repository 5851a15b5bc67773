#pragma once
// Chunks of tetrahedra as their launchers see them.
//
// They lie in the tables of all chunks (kernels/element/element_chunks.hpp) and write to the same slots. A tetrahedron
// takes the first four of the eight corners there. What the mixed form averages has rows of its own by slot, which
// nodes sum in the order of their forces: for each material of a node one record.

#include <tuple>

#include "kernels/core/common_record.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/tet/tet4.hpp"
#include "kernels/tet/tet_nodes.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of TetState.
struct TetRecord : SolidRecord {
  static constexpr int log_volume = 23, gap = 24, guard = 25, history = 26;
  /// Scalars that a record holds with so many of history.
  static constexpr int find_size(int count) { return history + count; }
};

/// Chunks of one material of tetrahedra, and what a pack of them works with.
template <class M>
struct TetBlock : SolidBlock<M> {
  using Shape = Tet4;
  using State = TetState<Pack<double>, M>;
  using Field = TetCorners<Pack<double>>;
};

template <class List>
struct AllTetBlocks;
template <class... Material>
struct AllTetBlocks<TypeList<Material...>> {
  using type = std::tuple<TetBlock<Material>...>;
};
/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using TetBlocks = AllTetBlocks<CompiledMaterials>::type;

using TetRateRows = Kokkos::View<double * [TetSums::rate_row], Kokkos::LayoutRight, MemSpace>;
using TetStressRows = Kokkos::View<double * [TetSums::stress_row], Kokkos::LayoutRight, MemSpace>;
using TetAverageRows = Kokkos::View<double * [TetSums::average_row], Kokkos::LayoutRight, MemSpace>;

/// What the passes of a step hand to each other; nothing of it lasts.
struct TetPasses {
  // What the third pass reads of an element; its record is not in the cache by then: shear modulus, tangent of the
  // viscosity, modulus of the guard, stiffness of hourglass modes, pressures of guard and viscosity, stress in space
  // axes.
  static constexpr int shear = 0, tangent = 1, guard_modulus = 2, hourglass = 3, guard = 4, viscous_pressure = 5,
                       stress = 6, scalars = 12;
  // Places and velocities of the nodes of chunks [slots of this rank's chunks][8]; behind a place its share.
  Array<double> nodes;
  TetRateRows slot_rates;       // [slots] sums of the chunks, and what other ranks have sent
  TetStressRows slot_stresses;  // likewise
  TetAverageRows rates;         // [records] D
  TetAverageRows stresses;      // [records] stress and moduli
  Array<double> shares;         // [records] mass over the sum of |B|^2 / V
  Array<double> elements;       // [packs][scalars][W]
  // What need not be done again. A chunk whose nodes rest stays as it is while the averages at its nodes do.
  Array<int> rates_rest;     // [records] 1: the rates are 0, with the bits of the step before
  Array<int> stresses_stay;  // [records] 1: the stresses have the bits of the step before
  Array<int> is_left;        // [chunks] 1: the second pass has left the chunk as it was

  /// Whether a list of flags is set at all records of a chunk's nodes.
  KOKKOS_INLINE_FUNCTION static bool are_set(const Array<int>& flags, const int* slots_to_records, int slot_count) {
    for (int s = 0; s < slot_count; ++s)
      if (slots_to_records[s] >= 0 && flags(slots_to_records[s]) == 0) return false;
    return true;
  }
};

/// Nodes and what they have.
struct TetLaunch {
  TetNodes nodes;
  TetPasses passes;
};

/// Makes the rows of passes for these chunks. slot_count: of all slots, those of other ranks among them.
TetPasses make_tet_passes(const TetNodes& nodes, const ElementChunks& chunks, int slot_count);

}  // namespace percuss
