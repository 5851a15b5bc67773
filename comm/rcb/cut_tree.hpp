#pragma once
// The P - 1 cuts of a recursive coordinate bisection (Figure 3 of the paper) as every rank holds them: steps (5.3) and
// (5.4).
//
// Ranks [first, last) are divided at middle = first + (last - first) / 2: points before the cut belong to the ranks
// below middle. Cut and middle belong together, so the tree needs no pointers: entry m of the array is the cut whose
// upper ranks begin at m. Everything here runs on the device, for each node or face in parallel.

#include <limits>

#include "comm/rcb/coordinate_key.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// One cut. The upper side has the points whose key along the axis is not before `key`. A cut that was never made, for
/// want of a bisection or of points, leaves all to the lower side.
struct Cut {
  CoordinateKey key = last_key;  // last_key: never made
  int axis = 0;                  // 0, 1, 2
  // No point of the lower side lies above, no point of the upper side below these along the axis [length].
  double lower_end = std::numeric_limits<double>::infinity();
  double upper_begin = std::numeric_limits<double>::infinity();
  // Where the next search begins; the cut that it finds does not depend on these.
  double spacing = 0;  // mean distance of points along the axis, near the cut [length]
  double travel = 0;   // how far the cut has moved lately from one bisection to the next [length]
};

inline bool is_made(const Cut& cut) { return !(cut.key == last_key); }

/// All cuts; const once made. Only the owners of points follow from it; nothing physical may.
struct CutTree {
  int rank_count = 1;
  Array<const Cut> cuts;  // [rank_count] entry m: the cut whose upper ranks begin at m; entry 0 is not used
};

KOKKOS_INLINE_FUNCTION int find_middle_rank(int first, int last) { return first + (last - first) / 2; }

/// The rank that owns a point. position: x, y, z; id: its global id.
template <class Position>
KOKKOS_INLINE_FUNCTION int find_owner(const CutTree& tree, const Position& position, std::int64_t id) {
  int first = 0, last = tree.rank_count;
  while (last - first > 1) {
    const int middle = find_middle_rank(first, last);
    const Cut& cut = tree.cuts(middle);
    const auto axis = static_cast<unsigned>(cut.axis);
    const bool is_lower = CoordinateKey{order_coordinate(position[axis]), id} < cut.key;
    (is_lower ? last : first) = middle;
  }
  return first;
}

/// Calls visit(rank), in ascending order, for every rank whose points a box may contain: step (5.4). A box that touches
/// a side is counted as reaching it. low, high: corners of the box, low[k] <= high[k].
template <class Position, class Visit>
KOKKOS_INLINE_FUNCTION void visit_reached_ranks(const CutTree& tree, const Position& low, const Position& high,
                                                const Visit& visit) {
  int waiting_first[32], waiting_last[32];  // as deep as a tree of 2^31 ranks
  int waiting = 0, first = 0, last = tree.rank_count;
  for (;;) {
    bool reached = true;
    while (reached && last - first > 1) {
      const int middle = find_middle_rank(first, last);
      const Cut& cut = tree.cuts(middle);
      const auto axis = static_cast<unsigned>(cut.axis);
      const bool lower = low[axis] <= cut.lower_end, upper = high[axis] >= cut.upper_begin;
      if (lower && upper) {
        waiting_first[waiting] = middle;
        waiting_last[waiting++] = last;
      }
      reached = lower || upper;
      (lower ? last : first) = middle;
    }
    if (reached) visit(first);
    if (waiting == 0) return;
    first = waiting_first[--waiting];
    last = waiting_last[waiting];
  }
}

/// The owner of each point. positions: [n][3]; ids: [n]; owners: out, [n].
void find_owners(const ExecSpace& space, const CutTree& tree, const Rows3<const double>& positions,
                 const Array<const std::int64_t>& ids, const Array<int>& owners);

}  // namespace percuss
