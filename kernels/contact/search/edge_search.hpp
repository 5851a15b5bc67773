#pragma once
// Pairs of feature edges that come near each other: the location phase of edge pairs.
//
// Points-in-box again: an edge is seen as points, the middles of equal pieces, and captures in a box. Pieces are of
// about the same length on all edges of a scene, so that one long edge does not widen the boxes of all others.

#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/contact/search/pair_search.hpp"

namespace percuss {

/// The points of edges: piece k of an edge with n has its middle at (k + 1/2) / n of it.
struct EdgePoints {
  int num_points = 0;
  Rows2<const int> ends;         // [edges][2] rows of the motion
  Array<const int> pieces;       // [edges] >= 1
  Array<const int> first_point;  // [edges] ascending
};

/// The points as points-in-box knows them.
struct EdgePointNames {
  Array<const int> edge_of_point;  // [points] ascending
  Array<const int> first_point;    // [edges + 1]
  Array<const int> points, edges;  // 0, 1, 2, ...
};

/// Largest extent of a piece along each axis, halved: no place on an edge is farther from one of its points.
Point3 find_half_piece(const WorkSpace& space, const EdgePoints& points, const Rows3<const double>& x);

/// Places of the points: out, [num_points][3].
void place_edge_points(const WorkSpace& space, const EdgePoints& points, const Rows3<const double>& x,
                       const Rows3<double>& places);

/// How far beyond an edge its capture box reaches besides the reach of the check: half a piece, the margin of the
/// faces' boxes by a third more, because the pieces may grow too while pairs are used again, and the thickest shell.
KOKKOS_INLINE_FUNCTION Point3 find_edge_margin(const Point3& half_piece, double margin, double thickness) {
  const double wider = 4 * margin / 3 + thickness;
  return half_piece + Point3{wider, wider, wider};
}

/// EdgeQuery::slack of these boxes: half a piece, and what is for the growth of pieces.
KOKKOS_INLINE_FUNCTION Point3 find_edge_slack(const Point3& half_piece, double margin) {
  const double wider = margin / 3;
  return half_piece + Point3{wider, wider, wider};
}

/// Capture box of each edge. ends: [edges][2] rows of the motion; boxes: out, [edges].
void bound_edges(const WorkSpace& space, const Rows2<const int>& ends, const SurfaceMotion& motion,
                 const Point3& margin, const Boxes& boxes);

/// Memory of the search for edge pairs, kept between searches.
struct EdgeSearchScratch {
  SearchScratch points;
  CandidateList hits;  // by point
  Array<int> first = Array<int>("contact::edge_first_pair", 0);
  Array<int> kept = Array<int>("contact::edge_kept_hits", 0);
  Array<int> mark = Array<int>("contact::edge_mark", 0);
};

/// Inputs of a search for edge pairs.
struct EdgeQuery {
  EdgePointNames points;
  Rows3<const double> places;  // [points]
  Rows3<const double> x;       // rows of EdgeSurface::ends
  Boxes boxes;                 // [edges] capture boxes
  Point3 slack{};  // by which they are wider than is needed to meet the edge itself rather than a point of it
};

/// Finds all pairs (a, b), a before b in number, for which a point of a lies in the box of b and a meets that box
/// without its slack. Returns the number of hits of points in boxes; if that is above max_pairs, no pairs are filled
/// in.
std::int64_t find_edge_pairs(const WorkSpace& space, const EdgeSurface& surface, const EdgeQuery& query,
                             std::int64_t max_pairs, EdgeSearchScratch& scratch, EdgePairs& pairs);

}  // namespace percuss
