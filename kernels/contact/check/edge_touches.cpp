#include "kernels/contact/check/edge_touches.hpp"

#include "kernels/contact/check/rim_check.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

/// EdgeTouchTable::touches: the pair touches; it continues a record.
constexpr int touching = 1, remembered = 2;

/// Whether two checks of a pair found the same, to the bit.
KOKKOS_INLINE_FUNCTION bool is_same_touch(const EdgeTouch& a, const EdgeTouch& b) {
  const double of_a[3] = {a.s, a.t, a.gap_start}, of_b[3] = {b.s, b.t, b.gap_start};
  const double end_a[3] = {a.gap_end, a.size, 0}, end_b[3] = {b.gap_end, b.size, 0};
  return a.record == b.record && have_same_bits(&a.normal.x, &b.normal.x) && have_same_bits(of_a, of_b) &&
         have_same_bits(end_a, end_b);
}

/// The record of a pair, -1 if there is none.
KOKKOS_INLINE_FUNCTION int find_edge_record(const EdgeHistory& records, std::int64_t a, std::int64_t b) {
  int lo = 0, hi = records.count;
  while (lo < hi) {
    const int middle = lo + (hi - lo) / 2;
    if (records.a(middle) < a || (records.a(middle) == a && records.b(middle) < b))
      lo = middle + 1;
    else
      hi = middle;
  }
  const bool found = lo < records.count && records.a(lo) == a && records.b(lo) == b && records.holds(lo) != 0;
  return found ? lo : -1;
}

}  // namespace

template <class Space>
void update_edge_boxes(const Space& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                       const EdgePairs& pairs, StillEdges& still, const Boxes& boxes) {
  const EdgeSurface s = surface;
  const SurfaceMotion m = motion;
  const Boxes out = boxes;
  const StillEdges seen = still;
  const bool is_watched = still.is_watched();
  const Array<const int> list = pairs.edges;
  int num_still = 0;
  Kokkos::parallel_reduce(
      "contact::update_edge_boxes", RangeOf<Space>(space, 0, pairs.num_edges),
      KOKKOS_LAMBDA(int i, int& count) {
        const int e = list(i);
        if (is_watched && seen.look(m, e, 6, [&](int k) { return find_edge_node(s, e, k); })) {
          ++count;
          return;
        }
        // The size h of two edges is at most the mean of their lengths.
        const double reach = 0.5 * find_edge_reach(s.ends, m.x, e) + find_edge_offset(s, e);
        bound_edge(s.ends, m, e, {reach, reach, reach}, out);
      },
      num_still);
  if (is_watched) still.count_still(num_still, pairs.num_edges);
}

template <class Space>
void find_edge_touches(const Space& space, const EdgeCheckInputs& inputs, const EdgePairs& pairs,
                       const StillEdges& still, EdgeTouchTable& table) {
  const StillEdges seen = still;
  const bool is_watched = still.is_watched() && table.list_of_pairs == pairs.list;
  table.list_of_pairs = pairs.list;
  reserve(table.by_pair, pairs.num_pairs);
  reserve(table.touches, pairs.num_pairs);
  reserve(table.list, pairs.num_pairs);
  const EdgeSurface s = inputs.surface;
  const SurfaceMotion m = inputs.motion;
  const Boxes box = inputs.boxes;
  const EdgeHistory past = inputs.history;
  const Array<const int> a = pairs.a, b = pairs.b;
  const Array<EdgeTouch> out = table.by_pair;
  const Array<int> touches = table.touches;
  Kokkos::parallel_reduce(
      "contact::check_edges", RangeOf<Space>(space, 0, pairs.num_pairs),
      KOKKOS_LAMBDA(int i, int& found) {
        const bool is_still = is_watched && !seen.has_moved(a(i)) && !seen.has_moved(b(i));
        if (!do_boxes_meet(box, a(i), b(i))) {
          touches(i) = 0;
          return;
        }
        EdgeTouch touch;
        Point3 last{};
        touch.record = past.count == 0 ? -1 : find_edge_record(past, s.numbers(a(i)), s.numbers(b(i)));
        if (is_still && touch.record < 0 && (touches(i) & remembered) == 0) return;
        const bool has_touched = is_still && (touches(i) & touching) != 0;
        touches(i) = touch.record >= 0 ? remembered : 0;
        if (touch.record >= 0) last = load_row(past.normal, touch.record);
        const Point3* const last_normal = touch.record >= 0 ? &last : nullptr;
        if (!check_edge_pair(s, m, a(i), b(i), last_normal, touch) &&
            !check_rim_pair({s, m, a(i), b(i), last_normal}, touch))
          return;
        touches(i) |= touching;
        found += has_touched && is_same_touch(touch, out(i)) ? 0 : 1;
        out(i) = touch;
      },
      table.num_new);
  table.count = list_where<Space>(
      space, pairs.num_pairs, [touches] KOKKOS_FUNCTION(int i) { return (touches(i) & touching) != 0; }, table.list);
}

template <class Space>
void find_edge_depths(const Space& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                      const EdgePairs& pairs, EdgeTouchTable& table) {
  reserve(table.by_pair, pairs.num_pairs);
  reserve(table.touches, pairs.num_pairs);
  reserve(table.list, pairs.num_pairs);
  const EdgeSurface s = surface;
  const SurfaceMotion m = motion;
  const Array<const int> a = pairs.a, b = pairs.b;
  const Array<EdgeTouch> out = table.by_pair;
  const Array<int> touches = table.touches;
  Kokkos::parallel_for(
      "contact::edge_depths", RangeOf<Space>(space, 0, pairs.num_pairs), KOKKOS_LAMBDA(int i) {
        EdgeTouch touch;
        double depth = find_edge_depth(s, m, a(i), b(i), touch);
        if (!(depth > 0)) depth = find_beam_depth(s, m, a(i), b(i), touch);
        touch.gap_start = -depth;
        touches(i) = depth > 0 ? touching : 0;
        out(i) = touch;
      });
  table.count = list_where<Space>(
      space, pairs.num_pairs, [touches] KOKKOS_FUNCTION(int i) { return touches(i) != 0; }, table.list);
}

#define PERCUSS_INSTANTIATE(Space)                                                                           \
  template void update_edge_boxes(const Space&, const EdgeSurface&, const SurfaceMotion&, const EdgePairs&,  \
                                  StillEdges&, const Boxes&);                                                \
  template void find_edge_touches(const Space&, const EdgeCheckInputs&, const EdgePairs&, const StillEdges&, \
                                  EdgeTouchTable&);                                                          \
  template void find_edge_depths(const Space&, const EdgeSurface&, const SurfaceMotion&, const EdgePairs&,   \
                                 EdgeTouchTable&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
