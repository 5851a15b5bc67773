#pragma once
// Where the numbers of an element lie. A chunk holds packs of pack_width elements, a lane each; lanes past the last
// element of a chunk repeat it. The scalars of a lane's record are pack_width apart, and so are its corners and works.
//
// The functions take ElementChunks, in kernels, or HostChunks, on the host. c: a chunk; i: a lane of it, which is that
// of the element of this number within the chunk.

#include <cstddef>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/precision.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/element/element_chunks.hpp"

namespace percuss {

/// Elements of a pack.
inline constexpr int pack_width = pack_size<Real>;

/// What is said of chunks, on the host.
struct HostChunks {
  explicit HostChunks(const ElementChunks& chunks)
      : count(chunks.count),
        first_element(to_host(chunks.first_element)),
        first_slot(to_host(chunks.first_slot)),
        first_pack(to_host(chunks.first_pack)),
        record_size(to_host(chunks.record_size)),
        corner_slots(to_host(chunks.corner_slots)),
        first_state(to_host(chunks.first_state)) {}

  int count;
  HostMirror<Array<int>> first_element, first_slot, first_pack, record_size;
  HostMirror<Array<std::uint16_t>> corner_slots;
  HostMirror<Array<std::size_t>> first_state;
};

/// The record of an element: its scalars by number. R: Real, or const Real.
template <class R>
struct LaneRecord {
  R* first;

  KOKKOS_INLINE_FUNCTION R& operator[](int scalar) const { return first[scalar * pack_width]; }
  KOKKOS_INLINE_FUNCTION double get(int scalar) const { return static_cast<double>(first[scalar * pack_width]); }
  /// What begins with this scalar.
  KOKKOS_INLINE_FUNCTION LaneRecord from(int scalar) const { return {first + scalar * pack_width}; }
  KOKKOS_INLINE_FUNCTION operator LaneRecord<const Real>() const { return {first}; }
};

/// The record of an element that is only read.
using ElementRecord = LaneRecord<const Real>;

/// Scalars before the record of a lane, of a chunk with records of this size.
KOKKOS_INLINE_FUNCTION std::size_t find_record_place(int lane, int size) {
  const auto pack = static_cast<std::size_t>(lane / pack_width), width = static_cast<std::size_t>(pack_width);
  return pack * static_cast<std::size_t>(size) * width + static_cast<std::size_t>(lane % pack_width);
}

/// records: State::elements, or a copy of it on the host.
template <class Chunks, class Records>
KOKKOS_INLINE_FUNCTION auto find_record(const Chunks& chunks, const Records& records, int c, int i) {
  auto* const first = &records(chunks.first_state(c));
  return LaneRecord<std::remove_pointer_t<decltype(first)>>{first + find_record_place(i, chunks.record_size(c))};
}

template <class Chunks>
KOKKOS_INLINE_FUNCTION int count_elements(const Chunks& chunks, int c) {
  return chunks.first_element(c + 1) - chunks.first_element(c);
}

template <class Chunks>
KOKKOS_INLINE_FUNCTION int count_lanes(const Chunks& chunks, int c) {
  return (chunks.first_pack(c + 1) - chunks.first_pack(c)) * pack_width;
}

/// The element of the mesh that a lane holds.
template <class Chunks>
KOKKOS_INLINE_FUNCTION int find_element(const Chunks& chunks, int c, int i) {
  const int last = count_elements(chunks, c) - 1;
  return chunks.first_element(c) + (i < last ? i : last);
}

/// Behind the last of the lanes that hold the element of lane i.
template <class Chunks>
KOKKOS_INLINE_FUNCTION int find_lane_end(const Chunks& chunks, int c, int i) {
  return i + 1 < count_elements(chunks, c) ? i + 1 : count_lanes(chunks, c);
}

/// Number of a lane among those of all chunks.
template <class Chunks>
KOKKOS_INLINE_FUNCTION int number_lane(const Chunks& chunks, int c, int i) {
  return chunks.first_pack(c) * pack_width + i;
}

/// Where ElementChunks::corner_slots has a corner, of a chunk whose packs begin with this one.
KOKKOS_INLINE_FUNCTION std::size_t find_corner_place(int first_pack, int lane, int corner) {
  const std::size_t pack = static_cast<std::size_t>(first_pack) + static_cast<std::size_t>(lane / pack_width);
  const auto width = static_cast<std::size_t>(pack_width);
  return (pack * 8 + static_cast<std::size_t>(corner)) * width + static_cast<std::size_t>(lane % pack_width);
}

/// The slot of a corner within its chunk, and among those of all.
template <class Chunks>
KOKKOS_INLINE_FUNCTION int find_corner_slot(const Chunks& chunks, int c, int i, int corner) {
  return chunks.corner_slots(find_corner_place(chunks.first_pack(c), i, corner));
}
template <class Chunks>
KOKKOS_INLINE_FUNCTION int number_corner_slot(const Chunks& chunks, int c, int i, int corner) {
  return chunks.first_slot(c) + find_corner_slot(chunks, c, i, corner);
}

/// Where ElementLives::work has a kind of work of a lane that can fail.
KOKKOS_INLINE_FUNCTION std::size_t find_work_place(std::size_t lane, std::size_t kind) {
  constexpr auto width = static_cast<std::size_t>(pack_width);
  return (lane / width * work_kinds + kind) * width + lane % width;
}

}  // namespace percuss
