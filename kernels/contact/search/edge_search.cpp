#include "kernels/contact/search/edge_search.hpp"

#include "kernels/core/index_lists.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION double find_extent(const Rows2<const int>& ends, const Rows3<const double>& x, int edge,
                                          int axis) {
  const double d = x(ends(edge, 1), axis) - x(ends(edge, 0), axis);
  return d < 0 ? -d : d;
}

/// The hits of an edge's points that make pairs with it.
struct PairFilter {
  EdgeSurface surface;
  EdgeQuery query;

  /// Whether edge a meets the box of b without its slack.
  KOKKOS_INLINE_FUNCTION bool meets(int a, int b) const {
    const Point3 p = load_row(query.x, surface.ends(a, 0)), q = load_row(query.x, surface.ends(a, 1));
    const double from[3] = {p.x, p.y, p.z}, to[3] = {q.x, q.y, q.z};
    const double slack[3] = {query.slack.x, query.slack.y, query.slack.z};
    for (int k = 0; k < 3; ++k) {
      const double low = from[k] < to[k] ? from[k] : to[k], high = from[k] < to[k] ? to[k] : from[k];
      if (high < query.boxes(b, k) + slack[k] || low > query.boxes(b, k + 3) - slack[k]) return false;
    }
    return true;
  }

  /// Leaves of hits first to last - 1 of edge a those that make pairs, ascending, each once; returns where they end.
  KOKKOS_INLINE_FUNCTION int keep(int a, int first, int last, const Array<int>& hit) const {
    int end = first;
    for (int i = first; i < last; ++i)
      if (meets(a, hit(i))) hit(end++) = hit(i);
    sort_run(hit, first, end);
    int kept = first;
    for (int i = first; i < end; ++i) {
      const int b = hit(i);
      if ((i == first || b != hit(i - 1)) && may_meet(surface, a, b) && !are_joined(surface, a, b)) hit(kept++) = b;
    }
    return kept;
  }
};

void list_paired_edges(const WorkSpace& space, int num_edges, EdgeSearchScratch& scratch, EdgePairs& pairs) {
  reserve(scratch.mark, num_edges);
  reserve(pairs.edges, num_edges);
  const Array<int> mark = scratch.mark, a = pairs.a, b = pairs.b;
  parallel_for(
      "contact::clear_edge_marks", RangeOf(space, 0, num_edges), KOKKOS_LAMBDA(int e) { mark(e) = 0; });
  parallel_for(
      "contact::mark_edges", RangeOf(space, 0, pairs.num_pairs), KOKKOS_LAMBDA(int i) {
        Kokkos::atomic_fetch_or(&mark(a(i)), 1);
        Kokkos::atomic_fetch_or(&mark(b(i)), 1);
      });
  pairs.num_edges = list_where(
      space, num_edges, [mark] KOKKOS_FUNCTION(int e) { return mark(e) != 0; }, pairs.edges);
}

}  // namespace

Point3 find_half_piece(const WorkSpace& space, const EdgePoints& points, const Rows3<const double>& x) {
  const EdgePoints p = points;
  const Rows3<const double> places = x;
  double half[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    parallel_reduce(
        "contact::half_piece", RangeOf(space, 0, static_cast<int>(p.ends.extent(0))),
        KOKKOS_LAMBDA(int e, double& most) {
          const double piece = 0.5 * find_extent(p.ends, places, e, axis) / p.pieces(e);
          most = piece > most ? piece : most;
        },
        Kokkos::Max<double>(half[axis]));
  }
  const auto positive = [](double a) { return a > 0 ? a : 0; };
  return {positive(half[0]), positive(half[1]), positive(half[2])};
}

void place_edge_points(const WorkSpace& space, const EdgePoints& points, const Rows3<const double>& x,
                       const Rows3<double>& places) {
  const EdgePoints p = points;
  const Rows3<const double> ends = x;
  const Rows3<double> out = places;
  parallel_for(
      "contact::edge_points", RangeOf(space, 0, static_cast<int>(p.ends.extent(0))), KOKKOS_LAMBDA(int e) {
        const Point3 first = load_row(ends, p.ends(e, 0)), along = load_row(ends, p.ends(e, 1)) - first;
        for (int k = 0; k < p.pieces(e); ++k)
          store_row(out, p.first_point(e) + k, first + ((k + 0.5) / p.pieces(e)) * along);
      });
}

void bound_edges(const WorkSpace& space, const Rows2<const int>& ends, const SurfaceMotion& motion,
                 const Point3& margin, const Boxes& boxes) {
  const Rows2<const int> list = ends;
  const SurfaceMotion m = motion;
  const Boxes out = boxes;
  const Point3 wider = margin;
  parallel_for(
      "contact::edge_boxes", RangeOf(space, 0, static_cast<int>(list.extent(0))), KOKKOS_LAMBDA(int e) {
        const double reach = find_edge_reach(list, m.x, e);
        bound_edge(list, m, e, wider + Point3{reach, reach, reach}, out);
      });
}

std::int64_t find_edge_pairs(const WorkSpace& space, const EdgeSurface& surface, const EdgeQuery& query,
                             std::int64_t max_pairs, EdgeSearchScratch& scratch, EdgePairs& pairs) {
  ++pairs.list;
  pairs.num_pairs = 0;
  pairs.num_edges = 0;
  const EdgePointNames& points = query.points;
  const PointQuery by_point{query.places, points.points, points.points,
                            query.boxes,  points.edges,  static_cast<int>(points.points.extent(0))};
  const EdgePairRule rule{surface, points.edge_of_point};
  const std::int64_t hits = find_hits(space, by_point, rule, max_pairs, scratch.points, scratch.hits);
  if (hits > max_pairs) return hits;
  const PairFilter filter{surface, query};
  const int num_edges = surface.num_edges;
  reserve(scratch.first, num_edges + 1);
  reserve(scratch.kept, num_edges);
  const Array<int> first = scratch.first, kept = scratch.kept, hit = scratch.hits.face;
  const Array<const int> offset = scratch.hits.offset, first_point = points.first_point;
  parallel_for(
      "contact::keep_edge_pairs", RangeOf(space, 0, num_edges), KOKKOS_LAMBDA(int e) {
        const int from = offset(first_point(e));
        kept(e) = filter.keep(e, from, offset(first_point(e + 1)), hit) - from;
      });
  parallel_scan(
      "contact::count_edge_pairs", RangeOf(space, 0, num_edges),
      KOKKOS_LAMBDA(int e, int& place, bool final_pass) {
        if (final_pass) first(e) = place;
        place += kept(e);
      },
      pairs.num_pairs);
  reserve(pairs.a, pairs.num_pairs);
  reserve(pairs.b, pairs.num_pairs);
  const Array<int> a = pairs.a, b = pairs.b;
  parallel_for(
      "contact::list_edge_pairs", RangeOf(space, 0, num_edges), KOKKOS_LAMBDA(int e) {
        for (int i = 0; i < kept(e); ++i) {
          a(first(e) + i) = e;
          b(first(e) + i) = hit(offset(first_point(e)) + i);
        }
      });
  list_paired_edges(space, num_edges, scratch, pairs);
  return hits;
}

}  // namespace percuss
