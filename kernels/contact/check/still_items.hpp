#pragma once
// What lies still is not looked at again.
//
// What the detailed check finds of a node or of two edges follows from places and velocities of nodes around them and
// from what they remember. Where all of these are at rest, to the bit, and have been so in the check before, at the
// same places, it finds what it found then.

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

/// Items, faces or edges, of which each check notes where their nodes lie at rest. A copy, as kernels make, shares what
/// is noted of the check that has begun; the next one begins with the original.
template <int most_nodes>
class StillItems {
 public:
  /// Begins a check of at most `items` items; without `is_wanted` nothing is noted, and all items count as moved.
  void begin(bool is_wanted, int items) {
    ++check_;
    is_watched_ = is_wanted && turns_to_pass_ == 0;
    if (turns_to_pass_ > 0) --turns_to_pass_;
    watched_in_a_row_ = is_watched_ ? watched_in_a_row_ + 1 : 0;
    if (!is_watched_ || static_cast<int>(last_checks_.extent(0)) >= items) return;
    reserve(last_checks_, items);
    reserve(moved_, items);
    reserve(places_, items);
    set_values(last_checks_, std::int64_t{-1});
    set_values(moved_, 1);
  }

  /// Takes how many items of a check were still. If these are few, the next checks do not look for still items.
  void count_still(int still, int items) {
    constexpr int pause = 15, worth_it = 8;  // checks; one item in so many
    if (watched_in_a_row_ > 1 && worth_it * still < items) turns_to_pass_ = pause;
  }

  /// Earlier checks count no more: items are others now, or what was found of them is lost.
  void forget() {
    check_ += 2;
    watched_in_a_row_ = 0;
  }

  bool is_watched() const { return is_watched_; }
  /// Marks what is found in this check, and what was found in the one before.
  std::int64_t now() const { return check_; }
  std::int64_t before() const { return check_ - 1; }

  KOKKOS_INLINE_FUNCTION bool has_moved(int item) const { return moved_(item) != 0; }

  /// Notes item with nodes row(0) to row(count - 1), rows of the motion. Returns whether all of them lie at rest where
  /// they lay at rest in the check before. count: the same as then, or the item counts as moved.
  template <class Row>
  KOKKOS_INLINE_FUNCTION bool look(const SurfaceMotion& motion, int item, int count, const Row& row) const {
    for (int k = 0; k < count; ++k) {
      if (is_plain_zero(&motion.v(row(k), 0))) continue;
      last_checks_(item) = -1;
      moved_(item) = 1;
      return false;
    }
    bool is_same = last_checks_(item) == (most_nodes + 1) * (check_ - 1) + count;
    for (int k = 0; k < count; ++k) {
      const double* const place = &motion.x(row(k), 0);
      if (is_same && have_same_bits(place, &places_(item, 3 * k))) continue;
      is_same = false;
      for (int c = 0; c < 3; ++c) places_(item, 3 * k + c) = place[c];
    }
    last_checks_(item) = (most_nodes + 1) * check_ + count;
    moved_(item) = is_same ? 0 : 1;
    return is_same;
  }

 private:
  using Places = Kokkos::View<double * [3 * most_nodes], Kokkos::LayoutRight, MemSpace>;

  bool is_watched_ = false;
  std::int64_t check_ = 1;
  int turns_to_pass_ = 0;
  int watched_in_a_row_ = 0;  // checks; the first of them finds nothing to compare with
  // [items] check and count of nodes; -1: moved then
  Array<std::int64_t> last_checks_ = Array<std::int64_t>("contact::last_checks", 0);
  Array<int> moved_ = Array<int>("contact::moved_items", 0);  // [items] of the last check that looked
  Places places_ = Places("contact::still_places", 0);        // [items] of their nodes when seen at rest
};

/// Faces by their corners and, of those that are boxed, the nodes behind.
using StillFaces = StillItems<8>;
/// Edges by their ends and wings.
using StillEdges = StillItems<6>;

}  // namespace percuss
