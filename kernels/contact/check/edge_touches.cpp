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

/// Place of the first record that does not come before those of edge `a`.
KOKKOS_INLINE_FUNCTION int find_first_record(const EdgeHistory& records, std::int64_t a) {
  int lo = 0, hi = records.count;
  while (lo < hi) {
    const int middle = lo + (hi - lo) / 2;
    if (records.a(middle) < a)
      lo = middle + 1;
    else
      hi = middle;
  }
  return lo;
}

/// The record of pair (a, b), -1 if there is none. first: [edges] find_first_record().
KOKKOS_INLINE_FUNCTION int find_edge_record(const EdgeHistory& records, const Array<const std::int64_t>& numbers,
                                            const Array<const int>& first, int a, int b) {
  if (records.count == 0) return -1;
  const std::int64_t number = numbers(a), other = numbers(b);
  for (int r = first(a); r < records.count && records.a(r) == number && records.b(r) <= other; ++r)
    if (records.b(r) == other) return records.holds(r) != 0 ? r : -1;
  return -1;
}

/// Finds where the records of the edges in pairs begin: for each edge once, since most pairs have none.
void find_first_records(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& pairs,
                        EdgeTouchTable& table) {
  if (inputs.history.count == 0) return;
  reserve(table.first_record, inputs.surface.num_edges);
  const Array<const std::int64_t> numbers = inputs.surface.numbers;
  const EdgeHistory past = inputs.history;
  const Array<const int> list = pairs.edges;
  const Array<int> first = table.first_record;
  parallel_for(
      "contact::first_edge_records", RangeOf(space, 0, pairs.num_edges),
      KOKKOS_LAMBDA(int i) { first(list(i)) = find_first_record(past, numbers(list(i))); });
}

}  // namespace

void update_edges(const WorkSpace& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                  const EdgePairs& pairs, StillEdges& still, const EdgeState& state) {
  const EdgeSurface s = surface;
  const SurfaceMotion m = motion;
  const EdgeState out = state;
  const StillEdges resting = still;
  const bool is_watched = still.is_watched(), has_faces = state.faces.extent(0) > 0;
  const Array<const int> list = pairs.edges;
  int num_still = 0;
  parallel_reduce(
      "contact::update_edges", RangeOf(space, 0, pairs.num_edges),
      KOKKOS_LAMBDA(int i, int& count) {
        const int e = list(i);
        if (is_watched && resting.look(m, e, 6, [&](int k) { return find_edge_node(s, e, k); })) {
          ++count;
          return;
        }
        // The size h of two edges is at most the mean of their lengths.
        const double reach = 0.5 * find_edge_reach(s.ends, m.x, e) + find_edge_offset(s, e);
        bound_edge(s.ends, m, e, {reach, reach, reach}, out.boxes);
        if (has_faces) out.faces(e) = load_edge_faces(s, m, e);
      },
      num_still);
  if (is_watched) still.count_still(num_still, pairs.num_edges);
}

void find_edge_touches(const WorkSpace& space, const EdgeCheckInputs& inputs, const EdgePairs& pairs,
                       const StillEdges& still, EdgeTouchTable& table) {
  const StillEdges resting = still;
  const bool is_watched = still.is_watched() && table.list_of_pairs == pairs.list;
  table.list_of_pairs = pairs.list;
  reserve(table.by_pair, pairs.num_pairs);
  reserve(table.touches, pairs.num_pairs);
  reserve(table.list, pairs.num_pairs);
  find_first_records(space, inputs, pairs, table);
  const EdgeSurface s = inputs.surface;
  const SurfaceMotion m = inputs.motion;
  const EdgeState edges = inputs.state;
  const Array<const int> first_record = table.first_record;
  const EdgeHistory past = inputs.history;
  const Array<const int> a = pairs.a, b = pairs.b;
  const Array<EdgeTouch> out = table.by_pair;
  const Array<int> touches = table.touches;
  parallel_reduce(
      "contact::check_edges", RangeOf(space, 0, pairs.num_pairs),
      KOKKOS_LAMBDA(int i, int& found) {
        const bool is_still = is_watched && !resting.has_moved(a(i)) && !resting.has_moved(b(i));
        if (!do_boxes_meet(edges.boxes, a(i), b(i))) {
          touches(i) = 0;
          return;
        }
        EdgeTouch touch;
        Point3 last{};
        touch.record = find_edge_record(past, s.numbers, first_record, a(i), b(i));
        if (is_still && touch.record < 0 && (touches(i) & remembered) == 0) return;
        const bool has_touched = is_still && (touches(i) & touching) != 0;
        touches(i) = touch.record >= 0 ? remembered : 0;
        if (touch.record >= 0) last = load_row(past.normal, touch.record);
        const CheckedEdges checked{s, m, edges.faces, {a(i), b(i)}, touch.record >= 0 ? &last : nullptr};
        const MovingPair pair = load_moving_pair(s, m, a(i), b(i));
        if (!check_edge_pair(checked, pair, touch) && !check_rim_pair(checked, pair, touch)) return;
        touches(i) |= touching;
        found += has_touched && is_same_touch(touch, out(i)) ? 0 : 1;
        out(i) = touch;
      },
      table.num_new);
  table.count = list_where(
      space, pairs.num_pairs, [touches] KOKKOS_FUNCTION(int i) { return (touches(i) & touching) != 0; }, table.list);
}

void find_edge_depths(const WorkSpace& space, const EdgeSurface& surface, const SurfaceMotion& motion,
                      const EdgePairs& pairs, EdgeTouchTable& table) {
  reserve(table.by_pair, pairs.num_pairs);
  reserve(table.touches, pairs.num_pairs);
  reserve(table.list, pairs.num_pairs);
  const EdgeSurface s = surface;
  const SurfaceMotion m = motion;
  const Array<const int> a = pairs.a, b = pairs.b;
  const Array<EdgeTouch> out = table.by_pair;
  const Array<int> touches = table.touches;
  parallel_for(
      "contact::edge_depths", RangeOf(space, 0, pairs.num_pairs), KOKKOS_LAMBDA(int i) {
        EdgeTouch touch;
        double depth = find_edge_depth(s, m, a(i), b(i), touch);
        if (!(depth > 0)) depth = find_beam_depth(s, m, a(i), b(i), touch);
        touch.gap_start = -depth;
        touches(i) = depth > 0 ? touching : 0;
        out(i) = touch;
      });
  table.count = list_where(
      space, pairs.num_pairs, [touches] KOKKOS_FUNCTION(int i) { return touches(i) != 0; }, table.list);
}

}  // namespace percuss
