#pragma once
// The detailed check of one pair of edges: do they touch in this step, where, how deep?
//
// Ways into contact as for a node and a face (pair_check.hpp): crossing near one another at the end of the step
// (touching), going through one another within it (swept), or left far behind after touching at its start (held). The
// push direction is square to both edges; a plane square to it must part the two wedges of faces, so that edges that
// only run past each other, as those of bricks in line do, never touch. Ends of edges belong to nodes and faces, nearly
// parallel edges too.

#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/edge_geometry.hpp"
#include "kernels/contact/geometry/swept_root.hpp"
#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/contact/surface/edge_surface.hpp"

namespace percuss {

namespace contact_limits {

/// New pairs may be parted less well than reach_through, by this sine, once they have crossed by crossed_depth. Pairs
/// that only run past each other, as of bricks in line, do not come so deep. Pairs of blunt edges touch from there on,
/// or deeper (find_least_depth).
inline constexpr double wide_reach_through = history_reach_through;
inline constexpr double crossed_depth = 5e-3;

}  // namespace contact_limits

/// Edge A on edge B.
struct EdgeTouch {
  int record = -1;       // history record that this contact continues; -1: new
  float offset = 0;      // distance that the lines keep by the thickness of shells, for limits
  double s = 0, t = 0;   // places on A and on B
  Point3 normal{};       // push direction of A
  double gap_start = 0;  // distance along the normal at n, negative in penetration [length]
  double gap_end = 0;    // gap at the predicted place
  double size = 0;       // h: the lesser of the two edges' sizes
};

/// A pair over the step.
struct MovingPair {
  EdgePair start, move;

  KOKKOS_INLINE_FUNCTION EdgePair at(double tau) const {
    EdgePair e;
    for (int i = 0; i < 2; ++i) {
      e.a[i] = start.a[i] + tau * move.a[i];
      e.b[i] = start.b[i] + tau * move.b[i];
    }
    return e;
  }
};

/// Places and displacements relative to the first end of A.
KOKKOS_INLINE_FUNCTION MovingPair load_moving_pair(const EdgeSurface& surface, const SurfaceMotion& motion, int a,
                                                   int b) {
  const int origin = surface.ends(a, 0);
  const Point3 x = load_row(motion.x, origin), v = load_row(motion.v, origin);
  MovingPair pair;
  for (int i = 0; i < 2; ++i) {
    const int p = surface.ends(a, i), q = surface.ends(b, i);
    pair.start.a[i] = load_row(motion.x, p) - x;
    pair.start.b[i] = load_row(motion.x, q) - x;
    pair.move.a[i] = motion.dt * (load_row(motion.v, p) - v);
    pair.move.b[i] = motion.dt * (load_row(motion.v, q) - v);
  }
  return pair;
}

KOKKOS_INLINE_FUNCTION bool do_boxes_meet(const Boxes& box, int a, int b) {
  for (int axis = 0; axis < 3; ++axis)
    if (box(a, axis) > box(b, axis + 3) || box(b, axis) > box(a, axis + 3)) return false;
  return true;
}

/// An edge with what its faces say: the wedge at the predicted place and the size h at n, the shortest edge of its
/// faces or the thickness of its shells. A beam has its length or its diameter, and a wedge of zeros: every plane
/// parts it.
struct EdgeFaces {
  Wedge wedge;
  double size = 0;
};

KOKKOS_INLINE_FUNCTION EdgeFaces load_edge_faces(const EdgeSurface& surface, const SurfaceMotion& motion, int edge) {
  const int origin = surface.ends(edge, 0);
  const Point3 x = load_row(motion.x, origin), v = load_row(motion.v, origin);
  const auto start = [&](int row) { return load_row(motion.x, row) - x; };
  const auto end = [&](int row) { return start(row) + motion.dt * (load_row(motion.v, row) - v); };
  const Point3 along = start(surface.ends(edge, 1)), along_end = end(surface.ends(edge, 1));
  EdgeFaces found;
  double shortest = dot(along, along);
  const int num_faces = is_beam(surface, edge) ? 0 : 2;
  for (int f = 0; f < num_faces; ++f) {
    const int p = surface.wings(edge, 2 * f), q = surface.wings(edge, 2 * f + 1);
    found.wedge.inward[f] = find_inward(Point3{}, along_end, end(p), end(q));
    const Point3 sides[3] = {start(p), start(q) - along, start(q) - start(p)};
    for (const Point3& side : sides) {
      const double square = dot(side, side);
      if (square > 0 && square < shortest) shortest = square;  // both wings of a triangle are one node
    }
  }
  found.size = std::sqrt(shortest);
  const double thickness = 2 * find_edge_offset(surface, edge);
  if (thickness > 0 && thickness < found.size) found.size = thickness;
  return found;
}

/// A pair to be checked.
struct CheckedEdges {
  const EdgeSurface& surface;
  const SurfaceMotion& motion;
  const Array<EdgeFaces>& faces;  // [edges] load_edge_faces() of all in pairs; empty: it is called for each pair
  int edge[2];                    // A and B
  const Point3* last_normal;      // of the contact that touch.record continues; none if it is new

  KOKKOS_INLINE_FUNCTION EdgeFaces load_faces(int e) const {
    return faces.extent(0) > 0 ? faces(e) : load_edge_faces(surface, motion, e);
  }
};

/// Turns a crossing so that its normal points out of B's wedge and into A's. Returns how far the plane that it is
/// square to is from parting the wedges: find_reach_through(). side: the distance at the start along c.normal of edges
/// with thickness; 0 of edges of solids. Their lines are apart when they touch. If either way parts the wedges, it says
/// which.
KOKKOS_INLINE_FUNCTION double orient(const Wedge& a, const Wedge& b, const Point3* last_normal, double side,
                                     Crossing& c) {
  namespace limits = contact_limits;
  const double reach = find_reach_through(a, b, c.normal), back = find_reach_through(a, b, -c.normal);
  bool flips = back < reach;
  if (side != 0 && reach <= limits::reach_through && back <= limits::reach_through) flips = side < 0;
  if (last_normal != nullptr) flips = dot(*last_normal, c.normal) < 0;
  if (flips) {
    c.normal = -c.normal;
    c.gap = -c.gap;
  }
  return flips ? back : reach;
}

/// How much deeper a new pair may be, share of h: beams slide from one to the next while springs give way.
KOKKOS_INLINE_FUNCTION double find_beam_cushion(const EdgeSurface& surface, int a, int b) {
  return gives_way(surface, a, b) && (is_beam(surface, a) || is_beam(surface, b)) ? contact_limits::spring_cushion : 0;
}

/// The depth, share of h, from which on a pair has crossed for certain, whatever springs of nodes and faces give way.
KOKKOS_INLINE_FUNCTION double find_crossed_depth(const EdgeSurface& surface, int a, int b) {
  return contact_limits::crossed_depth + (gives_way(surface, a, b) ? contact_limits::spring_cushion : 0);
}

/// How far a new pair has crossed before it touches, or overlaps at the start, share of h: 0 without a blunt edge. With
/// one, springs of nodes and faces that give way hold their bodies without it.
KOKKOS_INLINE_FUNCTION double find_least_depth(const EdgeSurface& surface, int a, int b) {
  return is_blunt_pair(surface, a, b) ? find_crossed_depth(surface, a, b) : 0;
}

/// How far the ridge across a warped face lies before the fan of the face at the predicted place: the diagonal through
/// the corners that stand out, over the mean of all four. 0 of other edges. place: 0 to 1; normal: of the push.
KOKKOS_INLINE_FUNCTION double find_dip(const EdgeSurface& surface, const SurfaceMotion& motion, int edge, double place,
                                       const Point3& normal) {
  if (find_bluntness(surface, edge) != warped_ridge) return 0;
  const auto find_end = [&](int row) { return load_row(motion.x, row) + motion.dt * load_row(motion.v, row); };
  const Point3 first = find_end(surface.ends(edge, 0));
  const auto relative = [&](int row) { return find_end(row) - first; };
  const Point3 along = relative(surface.ends(edge, 1));
  const Point3 low = relative(surface.wings(edge, 0)) + relative(surface.wings(edge, 2));
  const double dip = 0.25 * dot(along - low, normal), beside = 2 * place - 1;
  const double share = 1 - (beside < 0 ? -beside : beside);
  return share > 0 ? share * (dip < 0 ? -dip : dip) : 0;
}

/// Whether wedges that a plane parts but for `reach` may push each other. has_crossed: they were in contact, or have
/// crossed.
KOKKOS_INLINE_FUNCTION bool are_parted(double reach, bool has_crossed) {
  namespace limits = contact_limits;
  return reach <= (has_crossed ? limits::wide_reach_through : limits::reach_through);
}

/// Whether two edges may touch by their lines alone, whichever way they push: cheap, and rejects nearly all pairs.
/// known: they were in contact, and may be past an end; offset: the distance that the lines keep, or go beyond one
/// another.
KOKKOS_INLINE_FUNCTION bool may_touch(const MovingPair& pair, const Crossing& start, const Crossing& end, bool known,
                                      double offset) {
  if (!start.crosses || !end.crosses) return false;
  const bool changes_side = start.gap * end.gap <= 0;
  if (known || changes_side) return true;
  if (!is_inside(end, 0) && !is_inside(start, 0)) return false;
  const Point3 u = pair.start.a[1] - pair.start.a[0], v = pair.start.b[1] - pair.start.b[0];
  const double a = dot(u, u), b = dot(v, v), shorter = a < b ? a : b;
  const double s = start.gap * start.gap, e = end.gap * end.gap, nearer = s < e ? s : e;
  if (offset == 0)
    return nearer <= contact_limits::capture * contact_limits::capture * shorter;  // h is at most the shorter edge
  const double farthest = contact_limits::capture * std::sqrt(shorter) + offset;
  return nearer <= farthest * farthest;
}

/// (point s of A - point t of B) . normal.
KOKKOS_INLINE_FUNCTION double measure_edge_gap(const EdgePair& e, double s, double t, const Point3& normal) {
  const Point3 a = (1 - s) * e.a[0] + s * e.a[1], b = (1 - t) * e.b[0] + t * e.b[1];
  return dot(a - b, normal);
}

/// The gap between the lines at n, on the side of `normal`.
KOKKOS_INLINE_FUNCTION double measure_line_gap(const Crossing& start, const Point3& normal) {
  return dot(start.normal, normal) < 0 ? -start.gap : start.gap;
}

/// Whether a pair of solids that is too deep for a new contact entered during the last step, unseen by its check:
/// extrapolated one step back it was shallower, and beside an end or not crossed. This happens where an edge slides
/// from one neighbour to the next. crossed: how far it crosses before it touches.
KOKKOS_INLINE_FUNCTION bool has_just_crossed(const MovingPair& pair, const EdgeTouch& touch, double deepest,
                                             double crossed) {
  if (touch.offset > 0 || touch.gap_start < -contact_limits::history_depth * touch.size) return false;
  const Crossing before = find_crossing(pair.at(-1), contact_limits::least_sine);
  const double gap = measure_line_gap(before, touch.normal);
  return before.crosses && gap >= -deepest && (gap >= -crossed || !is_inside(before, contact_limits::end_band));
}

/// Whether a crossing came to a place on an edge from beyond an end at which one beam continues. before: a step ago.
KOKKOS_INLINE_FUNCTION bool has_passed_joint(const EdgeSurface& surface, int edge, double before) {
  constexpr double band = contact_limits::end_band;
  return (before < band && find_next_node(surface, edge, 0) >= 0) ||
         (before > 1 - band && find_next_node(surface, edge, 1) >= 0);
}

/// Whether a new pair of a beam takes over from the one before along the beam, as deep as that was.
KOKKOS_INLINE_FUNCTION bool takes_over(const EdgeSurface& surface, int a, int b, const MovingPair& pair) {
  if (!is_beam(surface, a) && !is_beam(surface, b)) return false;
  const Crossing before = find_crossing(pair.at(-1), contact_limits::least_sine);
  return before.crosses && (has_passed_joint(surface, a, before.s) || has_passed_joint(surface, b, before.t));
}

/// Share of an edge at each end that is left to nodes and faces. Where edges of solids have crossed at n none is: on
/// edges longer than h their ends are already beside the faces there.
KOKKOS_INLINE_FUNCTION double find_end_band(bool has_crossed) { return has_crossed ? 0 : contact_limits::end_band; }

/// The first time at which the edges go through one another from the side of `normal`; false if they do not.
KOKKOS_INLINE_FUNCTION bool sweep_edges(const MovingPair& pair, bool flips, EdgeTouch& touch) {
  const EdgePair &x = pair.start, &d = pair.move;
  const Point3 w = x.b[0] - x.a[0], dw = d.b[0] - d.a[0];
  Cubic volume = find_plane_cubic(w, w + (x.a[1] - x.a[0]), w + (x.b[1] - x.b[0]), dw, dw + (d.a[1] - d.a[0]),
                                  dw + (d.b[1] - d.b[0]));
  for (double& c : volume.c) c = flips ? -c : c;
  double root[2] = {0, 0};
  const int roots = find_falling_roots(volume, root);
  for (int r = 0; r < roots; ++r) {
    const Crossing hit = find_crossing(pair.at(root[r]), contact_limits::least_sine);
    if (!hit.crosses || !is_inside(hit, contact_limits::end_band)) continue;
    touch.s = hit.s;
    touch.t = hit.t;
    return true;
  }
  return false;
}

/// Whether edges that were in contact still cross, at most a little past their ends, and where: places beyond an end
/// become the end. depth: predicted.
KOKKOS_INLINE_FUNCTION bool keep_on_edges(const EdgePair& e, const Crossing& c, double depth, EdgeTouch& touch) {
  const double past_a = contact_limits::history_end_band + contact_limits::history_bend * depth / norm(e.a[1] - e.a[0]);
  const double past_b = contact_limits::history_end_band + contact_limits::history_bend * depth / norm(e.b[1] - e.b[0]);
  touch.s = c.s < 0 ? 0 : c.s > 1 ? 1 : c.s;
  touch.t = c.t < 0 ? 0 : c.t > 1 ? 1 : c.t;
  return is_inside(c, -past_a, -past_b);
}

/// A pair that may have a row, with its crossings at both ends of the step.
struct PairInReach {
  const MovingPair& pair;
  const Crossing &start, &end;
  double offset;  // what the shells of both edges take of the gap between the lines
  double dip;     // of warped faces: how far their ridges are before them
  double band;    // find_end_band()
  bool known;     // a contact with history
  bool flips;     // the normal is against a x b
};

/// The widest predicted gap of a row.
KOKKOS_INLINE_FUNCTION double find_edge_row_gap(bool known, double size) {
  return (known ? contact_limits::history_row_gap : contact_limits::row_gap) * size;
}

/// Where a pair touches: on the edges at the end of the step, at their ends where it was before, or where it went
/// through. In: touch with its gaps between the lines; false if it does not touch.
KOKKOS_INLINE_FUNCTION bool find_place(const PairInReach& p, EdgeTouch& touch) {
  namespace limits = contact_limits;
  const double reach = limits::capture * touch.size + p.offset + p.dip;
  const bool is_deep = touch.gap_end < -reach;
  if (!is_deep && is_inside(p.end, p.known ? 0 : p.band)) return true;
  const EdgePair end_places = p.pair.at(1);
  const double depth = is_deep ? reach : touch.gap_end < 0 ? -touch.gap_end : 0;
  if (p.known && !is_deep && keep_on_edges(end_places, p.end, depth, touch)) {
    touch.gap_start = measure_edge_gap(p.pair.start, touch.s, touch.t, touch.normal) - p.offset;
  } else {
    touch.s = p.start.s;
    touch.t = p.start.t;
    const double band = (p.known ? limits::history_band : limits::new_band) * touch.size;
    const bool on_edges = p.known ? keep_on_edges(p.pair.start, p.start, depth, touch) : is_inside(p.start, 0);
    const bool at_start = touch.gap_start <= band && on_edges;
    if (at_start ? !is_deep : !sweep_edges(p.pair, p.flips, touch)) return false;
  }
  touch.gap_end = measure_edge_gap(end_places, touch.s, touch.t, touch.normal) - p.offset;
  return touch.gap_end <= find_edge_row_gap(p.known, touch.size);
}

/// Checks one pair over the step; touch is meaningful if the answer is true.
PERCUSS_NO_INLINE inline bool check_edge_pair(const CheckedEdges& edges, const MovingPair& pair, EdgeTouch& touch) {
  const EdgeSurface& surface = edges.surface;
  const auto& [a, b] = edges.edge;
  const Point3* const last_normal = edges.last_normal;
  const bool known = last_normal != nullptr;
  Crossing end = find_crossing(pair.at(1), contact_limits::least_sine);
  if (!end.crosses) return false;  // most pairs are parallel
  const Crossing start = find_crossing(pair.start, contact_limits::least_sine);
  const double offset = find_edge_offset(surface, a) + find_edge_offset(surface, b);
  const double dip =
      find_dip(surface, edges.motion, a, end.s, end.normal) + find_dip(surface, edges.motion, b, end.t, end.normal);
  if (!may_touch(pair, start, end, known, offset + dip)) return false;
  const EdgeFaces of_a = edges.load_faces(a), of_b = edges.load_faces(b);
  const Point3 along_cross = end.normal;
  // Edges that turn over through being parallel are left to the next step.
  if (dot(start.normal, along_cross) < 0) return false;
  const double h = of_a.size < of_b.size ? of_a.size : of_b.size;
  const double reach = orient(of_a.wedge, of_b.wedge, last_normal, offset > 0 ? start.gap : 0, end);
  const bool has_crossed = known || end.gap - offset < -contact_limits::crossed_depth * h;
  const double crossed = find_least_depth(surface, a, b) * h + dip;
  if (!known && crossed > 0 && end.gap - offset >= -crossed) return false;
  if (!are_parted(reach, has_crossed)) return false;
  touch.normal = end.normal;
  touch.gap_end = end.gap - offset;
  touch.gap_start = measure_line_gap(start, end.normal) - offset;
  touch.size = h;
  touch.offset = static_cast<float>(offset);
  touch.s = end.s;
  touch.t = end.t;
  if (touch.gap_end > find_edge_row_gap(known, h)) return false;
  const double cushion =
      crossed > 0 ? crossed - contact_limits::crossed_depth * h : find_beam_cushion(surface, a, b) * h;
  const double deepest =
      known ? contact_limits::history_depth * h + offset + dip : contact_limits::new_depth * h + cushion;
  const bool may_have_come = !known && reach <= contact_limits::reach_through;
  const double held = contact_limits::history_depth * h + offset;
  if (touch.gap_start < -deepest && !(may_have_come && has_just_crossed(pair, touch, deepest, crossed)) &&
      !(!known && touch.gap_start >= -held && takes_over(surface, a, b, pair)))
    return false;
  const double band = find_end_band(!(offset > 0) && touch.gap_start < -find_crossed_depth(surface, a, b) * h);
  return find_place({pair, start, end, offset, dip, band, known, dot(along_cross, end.normal) < 0}, touch);
}

/// How deep two edges are inside one another at the places of a motion with dt = 0; 0 if they are not, or deeper than
/// half of h (with thickness between them, deeper than their lines), where an edge is no longer said to have come from
/// that side. Pairs with a blunt edge are inside one another once they would touch.
PERCUSS_NO_INLINE inline double find_edge_depth(const EdgeSurface& surface, const SurfaceMotion& motion, int a, int b,
                                                EdgeTouch& touch) {
  constexpr double deepest = 0.5;
  Crossing c = find_crossing(load_moving_pair(surface, motion, a, b).start, contact_limits::least_sine);
  if (!c.crosses || !is_inside(c, contact_limits::end_band)) return 0;
  const EdgeFaces of_a = load_edge_faces(surface, motion, a), of_b = load_edge_faces(surface, motion, b);
  const double offset = find_edge_offset(surface, a) + find_edge_offset(surface, b);
  touch.offset = static_cast<float>(offset);
  const double reach = orient(of_a.wedge, of_b.wedge, nullptr, offset > 0 ? c.gap : 0, c);
  if (reach > contact_limits::reach_through) return 0;
  touch.normal = c.normal;
  touch.size = of_a.size < of_b.size ? of_a.size : of_b.size;
  const double gap = c.gap - offset, half = deepest * touch.size;
  const double least = find_least_depth(surface, a, b) * touch.size + find_dip(surface, motion, a, c.s, c.normal) +
                       find_dip(surface, motion, b, c.t, c.normal);
  return gap < -least && gap > -(offset > half ? offset : half) ? -gap : 0;
}

}  // namespace percuss
