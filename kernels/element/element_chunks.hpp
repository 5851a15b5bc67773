#pragma once
// Chunks of elements as the launchers see them: fixed runs of packs with their own list of nodes.
//
// A slot is one chunk's copy of one of its nodes. Chunks write nodal forces to their own slots only. A node then sums
// its slots in ascending order of chunk id, which fixes the order of every sum for any number of threads.

#include <cstddef>
#include <cstdint>

#include "kernels/core/element_family.hpp"
#include "kernels/core/precision.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"
#include "kernels/element/element_lives.hpp"
#include "kernels/material/point_step.hpp"

namespace percuss {

/// Connectivity of the chunks; const after set-up. W is pack_size<Real>.
struct ElementChunks {
  int count = 0;
  int largest_slot_count = 0;         // nodes of the chunk that has most
  Array<int> first_element;           // [count + 1] elements are numbered by chunk
  Array<int> first_slot;              // [count + 1]
  Array<int> slots_to_nodes;          // [slots] mesh node of a slot
  Array<int> first_pack;              // [count + 1]
  Array<std::uint16_t> corner_slots;  // [packs][8][W] slot within the chunk; lanes past the end repeat the last element
  Array<std::size_t> first_state;     // [count] where the chunk's element state begins, in scalars
  Array<int> parameters;              // [count] row of the parameters of its material
  Array<int> record_size;             // [count] scalars an element's record holds
  Array<int> history;                 // [count] place of the material's history in the record, -1: it has none
  Array<int> points;                  // [count] points of an element with stress and history of their own
  Array<int> rule;                    // [count] of shells: row of the table of rules across the thickness
  Array<int> scalars;                 // [count][history_scalars] place of a named scalar of the first point, -1: none
  Array<ElementFamily> family;        // [count] empty: all are hexahedra
  Array<Real> fold_threshold;         // [count] r0 of fold_resistance.hpp, 0: none; empty: no element resists folding

  /// Where the record of an element of chunk c holds a scalar of its first point. Point p of a hexahedron has it p
  /// places farther, that of a shell a layer's size (find_layer_size() in kernels/shell). -1: the material has none.
  KOKKOS_INLINE_FUNCTION int find_scalar(int c, HistoryScalar name) const {
    return scalars(c * history_scalars + static_cast<int>(name));
  }
};

/// The family of the elements of chunk c.
KOKKOS_INLINE_FUNCTION ElementFamily find_family(const ElementChunks& chunks, int c) {
  return chunks.family.extent(0) > 0 ? chunks.family(c) : ElementFamily::hexahedra;
}
KOKKOS_INLINE_FUNCTION bool is_shell(const ElementChunks& chunks, int c) {
  return find_family(chunks, c) == ElementFamily::shells;
}
KOKKOS_INLINE_FUNCTION bool is_beam(const ElementChunks& chunks, int c) {
  return find_family(chunks, c) == ElementFamily::beams;
}

using WorkRows = Kokkos::View<double* [work_kinds], Kokkos::LayoutRight, MemSpace>;

/// What a step leaves for each chunk.
struct ChunkResults {
  Array<double> stable_step;       // [count] smallest bound of the chunk's elements
  Array<int> controlling_element;  // [count] element that has it
  Array<int> failed_element;       // [count] lowest element with no positive volume or no step, -1: none
  WorkRows work;                   // [count][work_kinds] energy put in since the start
  Array<int> is_settled;           // [count] 1: evaluated at rest, which changed nothing
  Array<std::int64_t> skipped;     // [count] evaluations that were not needed, since the start
  Array<double> resists;           // [count] 1: an element resists folding at n; empty as ElementChunks::fold_threshold
};

/// What evaluating the elements of all chunks reads and writes.
struct ChunkFields {
  Array<Real> state;         // records of the elements, in and out
  Rows3<double> slot_force;  // out: the chunk's share of the force on its nodes (minus the internal force), as it was
                             // where a chunk is skipped
  ChunkResults results;      // out; work is added to
  Rows3<double> slot_moment{};  // out: of moments likewise; of shells only
};

}  // namespace percuss
