#pragma once
// Chunks of hexahedra as the launchers see them: fixed runs of packs with their own list of nodes.
//
// A slot is one chunk's copy of one of its nodes. Chunks write nodal forces to their own slots only; a node then sums
// its slots in ascending order of chunk id, which fixes the order of every sum whatever the number of threads.

#include <cstddef>
#include <cstdint>

#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"
#include "kernels/element/hex8.hpp"

namespace percuss {

/// Connectivity of the chunks; const after set-up. W is pack_size<double>.
struct HexChunks {
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
};

/// What a step leaves for each chunk.
struct ChunkResults {
  Array<double> stable_step;       // [count] smallest bound of the chunk's elements
  Array<int> controlling_element;  // [count] element that has it
  Array<int> failed_element;       // [count] lowest element with no positive volume or no step, -1: none
  Rows3<double> work;              // [count][3] internal, hourglass, viscous energy put in since the start
};

/// Scalars that one element's record holds: mass, q, R (9), V (6), stress (6), then hourglass forces, then history.
template <class Material, HourglassKind Kind>
inline constexpr int hex_record_size = 23 + (Kind == HourglassKind::stiffness ? 12 : 0) + Material::history_count;

/// Where things lie in a record, in scalars of one lane.
struct HexRecord {
  static constexpr int mass = 0, viscous_pressure = 1, rotation = 2, stretch = 11, stress = 17, hourglass = 23;
  template <HourglassKind Kind>
  static constexpr int history = Kind == HourglassKind::stiffness ? 35 : 23;
};

}  // namespace percuss
