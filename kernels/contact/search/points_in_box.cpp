#include "kernels/contact/search/points_in_box.hpp"

#include "kernels/core/index_lists.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// A run of one axis' list: places first to last - 1.
struct Run {
  int first = 0, last = 0;
};

struct RankLists {
  Rows3<const double> x;
  Array<const int> points;
  Array<const int> order[3], rank[3];
  int n = 0;

  /// First place whose coordinate is at least (strict: above) the value.
  KOKKOS_INLINE_FUNCTION int search(int axis, double value, bool strict) const {
    int lo = 0, hi = n;
    while (lo < hi) {
      const int middle = lo + (hi - lo) / 2;
      const double c = x(points(order[axis](middle)), axis);
      if (strict ? c <= value : c < value)
        lo = middle + 1;
      else
        hi = middle;
    }
    return lo;
  }
  KOKKOS_INLINE_FUNCTION Run find_run(int axis, const Boxes& boxes, int face) const {
    return {search(axis, boxes(face, axis), false), search(axis, boxes(face, axis + 3), true)};
  }
};

/// Pairs found so far, in no order; sorted afterwards.
struct HitList {
  Array<int> node, face;
  Array<std::int64_t> total;
  int capacity = 0;

  KOKKOS_INLINE_FUNCTION void append(const int* nodes, int count, int hit_face) const {
    const std::int64_t first = Kokkos::atomic_fetch_add(&total(0), static_cast<std::int64_t>(count));
    for (int i = 0; i < count && first + i < capacity; ++i) {
      node(first + i) = nodes[i];
      face(first + i) = hit_face;
    }
  }
};

/// Walks the shortest of the three runs of a box.
template <class Rule>
struct BoxWalk {
  Rule rule;
  Array<const int> point_names, box_names;
  RankLists lists;
  Boxes boxes;
  HitList hits;

  KOKKOS_INLINE_FUNCTION void operator()(int i) const {
    constexpr int buffer_size = 32;
    const int face = box_names(i);
    Run run[3];
    int shortest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      run[axis] = lists.find_run(axis, boxes, i);
      if (run[axis].last - run[axis].first < run[shortest].last - run[shortest].first) shortest = axis;
    }
    const int b = (shortest + 1) % 3, c = (shortest + 2) % 3;
    int buffer[buffer_size], count = 0;
    for (int place = run[shortest].first; place < run[shortest].last; ++place) {
      const int point = lists.order[shortest](place);
      const int rank_b = lists.rank[b](point), rank_c = lists.rank[c](point);
      if (rank_b < run[b].first || rank_b >= run[b].last || rank_c < run[c].first || rank_c >= run[c].last) continue;
      const int node = point_names(point);
      if (!rule(node, face)) continue;
      buffer[count++] = node;
      if (count == buffer_size) {
        hits.append(buffer, count, face);
        count = 0;
      }
    }
    if (count > 0) hits.append(buffer, count, face);
  }
};

RankLists rank_all(const WorkSpace& space, const PointQuery& query, RankedListScratch& scratch) {
  RankLists lists;
  lists.x = query.x;
  lists.points = query.points;
  lists.n = static_cast<int>(query.point_names.extent(0));
  for (int axis = 0; axis < 3; ++axis) {
    reserve(scratch.order[axis], lists.n);
    reserve(scratch.rank[axis], lists.n);
    rank_points(space, {query.x, query.points, lists.n, axis}, scratch.sort, scratch.order[axis], scratch.rank[axis]);
    lists.order[axis] = scratch.order[axis];
    lists.rank[axis] = scratch.rank[axis];
  }
  return lists;
}

/// Walks all boxes, again with more room if the hits do not fit; returns their number.
template <class Rule>
std::int64_t collect_hits(const WorkSpace& space, const PointQuery& query, const Rule& rule, const RankLists& lists,
                          std::int64_t max_pairs, RankedListScratch& scratch) {
  const int num_boxes = static_cast<int>(query.box_names.extent(0));
  const Array<std::int64_t> total = scratch.total;
  for (;;) {
    HitList hits{scratch.hit_node, scratch.hit_face, total, static_cast<int>(scratch.hit_node.extent(0))};
    set_values(space, total, std::int64_t{0});
    parallel_for("contact::points_in_box", RangeOf(space, 0, num_boxes),
                 BoxWalk<Rule>{rule, query.point_names, query.box_names, lists, query.boxes, hits});
    const std::int64_t found = read_value(space, total, 0);
    if (found <= hits.capacity || found > max_pairs) return found;
    reserve(scratch.hit_node, static_cast<int>(found));
    reserve(scratch.hit_face, static_cast<int>(found));
  }
}

}  // namespace

template <class Rule>
std::int64_t find_hits_by_points_in_box(const WorkSpace& space, const PointQuery& query, const Rule& rule,
                                        std::int64_t max_pairs, RankedListScratch& scratch, CandidateList& list) {
  const RankLists lists = rank_all(space, query, scratch);
  const std::int64_t found = collect_hits(space, query, rule, lists, max_pairs, scratch);
  if (found > max_pairs) return found;
  list.num_pairs = static_cast<int>(found);
  reserve(list.offset, query.num_names + 1);
  reserve(list.face, list.num_pairs);
  reserve(scratch.count, query.num_names);
  group_by_key(space, {list.num_pairs, scratch.hit_node, scratch.hit_face, query.num_names},
               {scratch.count, list.offset, list.face});
  return found;
}

template std::int64_t find_hits_by_points_in_box(const WorkSpace&, const PointQuery&, const NodeFaceRule&, std::int64_t,
                                                 RankedListScratch&, CandidateList&);
template std::int64_t find_hits_by_points_in_box(const WorkSpace&, const PointQuery&, const EdgePairRule&, std::int64_t,
                                                 RankedListScratch&, CandidateList&);

}  // namespace percuss
