#pragma once
// Rest: the one rule by which the launchers of all families leave chunks of elements as they are.

#include <cstddef>
#include <cstring>

#include "kernels/core/same_bits.hpp"
#include "kernels/element/element_chunks.hpp"

namespace percuss {

/// A chunk is at rest if no node of it moves: the positions of such nodes are those of the step before. It is settled
/// once an evaluation at rest has changed no bit of its records. Its forces then stay, and it need not be evaluated
/// until a node moves, or until what changes records from outside sets ChunkResults::is_settled to 0.
class ChunkRest {
 public:
  /// may_rest: false if the deck wants every evaluation, or if the material changes at rest. rows: velocities, and
  /// spins if there are any, three numbers a node.
  template <class... Rows>
  KOKKOS_FUNCTION ChunkRest(const ElementChunks& chunks, const ChunkResults& results, int c, bool may_rest,
                            const Rows&... rows)
      : results_(results), c_(c), is_at_rest_(may_rest) {
    const int first = chunks.first_slot(c), end = chunks.first_slot(c + 1);
    for (int s = first; is_at_rest_ && s < end; ++s) {
      const std::size_t n = 3 * static_cast<std::size_t>(chunks.slots_to_nodes(s));
      is_at_rest_ = ((rows.extent(0) == 0 || is_plain_zero(rows.data() + n)) && ...);
    }
  }

  KOKKOS_FUNCTION bool is_at_rest() const { return is_at_rest_; }
  KOKKOS_FUNCTION bool is_settled() const { return is_at_rest_ && results_.is_settled(c_) != 0; }

  /// Whether the chunk is left as it is, which is counted.
  KOKKOS_FUNCTION bool skips() const {
    if (!is_settled()) return false;
    ++results_.skipped(c_);
    return true;
  }

  /// After an evaluation. changed: whether it has changed a bit of the records.
  KOKKOS_FUNCTION void leave(bool changed) const { results_.is_settled(c_) = is_at_rest_ && !changed ? 1 : 0; }

 private:
  const ChunkResults& results_;
  int c_;
  bool is_at_rest_;
};

/// Whether evaluations change a bit of the records of packs, of at most `Largest` numbers each.
template <int Largest, class Scalar = Real>
class RecordWatch {
 public:
  /// is_on: if false, changes are not tracked.
  KOKKOS_FUNCTION explicit RecordWatch(bool is_on) : is_on_(is_on) {}

  PERCUSS_FORCE_INLINE void keep(const Scalar* record, int size) {
    if (is_on_) std::memcpy(before_, record, static_cast<std::size_t>(size) * sizeof(Scalar));
  }
  PERCUSS_FORCE_INLINE void compare(const Scalar* record, int size) {
    if (is_on_) has_changed_ = has_changed_ || !have_same_bits(before_, record, size);
  }
  KOKKOS_FUNCTION bool has_changed() const { return has_changed_; }

 private:
  Scalar before_[Largest];
  bool is_on_, has_changed_ = false;
};

}  // namespace percuss
