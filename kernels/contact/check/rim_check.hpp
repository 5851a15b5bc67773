#pragma once
// The detailed check of an end of an edge before the rim of a shell.
//
// A corner that meets a rim from its front comes in between the two sides of the shell: it goes through no face, and
// none of its edges crosses the rim away from the corner. A rim is therefore round before its line, by half the
// thickness: the corner is pushed from the closest point of the rim. Further on, beside the shell, it belongs to the
// faces, and edges that cross the rim to edge_check.hpp.
//
// A beam is a rim that is round on all sides: ends of edges that lie along it, of other beams above all, keep its
// radius.

#include "kernels/contact/check/edge_check.hpp"

namespace percuss {

namespace contact_limits {

/// An end is before a rim if the way to it goes outward by at least this cosine ...
inline constexpr double rim_front = 0.3;
/// ... or, with history, by this one.
inline constexpr double history_rim_front = 0.05;
/// Beyond the ends of a rim by this share of it it still pushes, with history by twice as much.
inline constexpr double rim_end_band = 0.02;
/// Beyond its ends a beam is round, as far as this cosine between its axis and the way from there: the next beam of a
/// line continues, or lies in between. A free end is round all over for another free end.
inline constexpr double round_end = 0.7071;
/// Where one beam continues, the two are one round bar: the joint pushes square to both, or from outside their bend,
/// but for this sine.
inline constexpr double joint_reach = 0.1;

}  // namespace contact_limits

/// Where a point is closest to a rim.
struct RimPoint {
  double t = 0;     // on the rim, 0 to 1
  double past = 0;  // beyond its ends, share of the rim
  Point3 away{};    // from there to the point
};

KOKKOS_INLINE_FUNCTION RimPoint find_rim_point(const Point3 rim[2], const Point3& point) {
  const Point3 along = rim[1] - rim[0];
  const double square = dot(along, along), t = square > 0 ? dot(point - rim[0], along) / square : 0;
  RimPoint found;
  found.t = t < 0 ? 0 : t > 1 ? 1 : t;
  found.past = t < found.t ? found.t - t : t - found.t;
  found.away = point - ((1 - found.t) * rim[0] + found.t * rim[1]);
  return found;
}

/// A rim: an edge with one face as both of its sides, or a beam.
KOKKOS_INLINE_FUNCTION bool is_rim(const EdgeSurface& surface, int edge) {
  if (!(find_edge_offset(surface, edge) > 0)) return false;
  return is_beam(surface, edge) ||
         (surface.wings(edge, 0) == surface.wings(edge, 2) && surface.wings(edge, 1) == surface.wings(edge, 3));
}

/// An end of one edge before the other one, over the step.
struct EndBeforeRim {
  bool is_of_b = false;  // an end of edge B before rim A
  RimPoint from, to;     // at n and at the end of the step
  Point3 along{};        // from the end to the other end of its edge, at the end of the step
  Point3 rim_along{};    // from one end of the rim to the other, at the end of the step
  Point3 next{};         // from the end along the only beam that continues there, at the end of the step; zero: none
  Point3 rim_next{};     // likewise from the end of the rim that is the closest point
  double offset = 0;     // that both keep by thickness
  double cushion = 0;    // find_beam_cushion()
  bool is_beam_rim = false,
       are_free = false;  // the rim is a beam; the end is a free one, and so is that of the rim there
};

/// place: 0 or 1, which end.
KOKKOS_INLINE_FUNCTION EndBeforeRim load_end(const EdgePair& from, const EdgePair& to, bool is_of_b, int place) {
  EndBeforeRim found;
  found.is_of_b = is_of_b;
  found.from = find_rim_point(is_of_b ? from.a : from.b, is_of_b ? from.b[place] : from.a[place]);
  found.to = find_rim_point(is_of_b ? to.a : to.b, is_of_b ? to.b[place] : to.a[place]);
  found.along = is_of_b ? to.b[1 - place] - to.b[place] : to.a[1 - place] - to.a[place];
  found.rim_along = is_of_b ? to.a[1] - to.a[0] : to.b[1] - to.b[0];
  return found;
}

/// Whether an end may come as near to the rim in the step as a row has it, by their distances alone.
KOKKOS_INLINE_FUNCTION bool may_reach(const EndBeforeRim& e, double widest) {
  const Point3 &from = e.from.away, &to = e.to.away;
  return dot(from, to) <= 0 || dot(from, from) <= widest * widest || dot(to, to) <= widest * widest;
}

/// Whether a rim may push an end this way: forward, and the edge of the end and its faces lie away from the rim.
KOKKOS_INLINE_FUNCTION bool is_before_rim(const EndBeforeRim& e, const EdgeFaces faces[2], const Point3& push,
                                          bool known) {
  namespace limits = contact_limits;
  const Wedge &rim = faces[e.is_of_b ? 0 : 1].wedge, &edge = faces[e.is_of_b ? 1 : 0].wedge;
  const double slack = known ? limits::history_reach_through : limits::reach_through;
  const bool is_round = e.is_beam_rim;
  if (!is_round && -dot(push, rim.inward[0]) < (known ? limits::history_rim_front : limits::rim_front)) return false;
  return dot(push, e.along) >= -slack * norm(e.along) && dot(push, edge.inward[0]) >= -slack &&
         dot(push, edge.inward[1]) >= -slack;
}

/// Turns a push away from a joint, of which `on` continues, so that it does not push into `on`; false if it does by
/// more than a little.
KOKKOS_INLINE_FUNCTION bool turn_from(const Point3& on, Point3& push) {
  const double square = dot(on, on), along = dot(push, on);
  if (!(along < 0)) return true;
  if (along * along > contact_limits::joint_reach * contact_limits::joint_reach * square) return false;
  push = normalize(push - (along / square) * on);
  return true;
}

/// Turns the push of an end so that neither it nor the rim catches by the caps of a joint.
KOKKOS_INLINE_FUNCTION bool smooth_joints(const EndBeforeRim& e, Point3& push) {
  const bool has_next = dot(e.next, e.next) > 0, has_rim_next = dot(e.rim_next, e.rim_next) > 0;
  if (has_next && !(turn_from(e.along, push) && turn_from(e.next, push))) return false;
  if (!has_rim_next) return true;
  Point3 back = -push;
  if (!turn_from(e.rim_next, back)) return false;
  push = -back;
  return true;
}

/// last_push: of the end, if it was in contact. In: touch.size; out: t, normal (push direction of the
/// end) and gaps.
KOKKOS_INLINE_FUNCTION bool check_end(const EndBeforeRim& e, const EdgeFaces faces[2], const Point3* last_push,
                                      EdgeTouch& touch) {
  namespace limits = contact_limits;
  const bool known = last_push != nullptr;
  const double offset = e.offset, h = touch.size;
  const Point3& before = known ? *last_push : e.from.away;
  Point3 push = normalize(e.to.away);
  const bool has_turned = !(dot(push, before) > 0);  // it would go through the line
  if (has_turned) push = normalize(before);
  const Point3 round = push;
  if (!smooth_joints(e, push)) return false;
  const bool is_smoothed = round.x != push.x || round.y != push.y || round.z != push.z;
  const double start = is_smoothed ? std::fabs(dot(e.from.away, push)) : norm(e.from.away);
  touch.gap_start = (dot(e.from.away, push) < 0 ? -start : start) - offset;
  touch.gap_end = dot(e.to.away, push) - offset;
  touch.t = has_turned ? e.from.t : e.to.t;
  touch.normal = push;
  const double deepest = known ? limits::history_depth * h + offset : (limits::new_depth + e.cushion) * h;
  return touch.gap_start >= -deepest && touch.gap_end <= find_edge_row_gap(known, h) &&
         is_before_rim(e, faces, push, known);
}

/// The nearer of two touches of ends; place: 0 or 1, which end.
KOKKOS_INLINE_FUNCTION void take_nearer(const EdgeTouch& end, bool is_of_b, double place, bool is_first,
                                        EdgeTouch& touch) {
  if (!is_first && !(end.gap_end < touch.gap_end)) return;
  touch = end;
  touch.s = is_of_b ? end.t : place;
  touch.t = is_of_b ? place : end.t;
  if (is_of_b) touch.normal = -end.normal;
}

/// The faces of both edges.
KOKKOS_INLINE_FUNCTION void load_both_faces(const CheckedEdges& p, EdgeFaces faces[2]) {
  for (int i = 0; i < 2; ++i) faces[i] = p.load_faces(p.edge[i]);
}

/// Whether is_before_rim() is certainly false of an end without history: it is pushed along the way from the rim at
/// either end of the step, and both run beside the shell, as those of shells in a stack do.
KOKKOS_INLINE_FUNCTION bool is_surely_beside(const EndBeforeRim& e, const EdgeFaces faces[2]) {
  constexpr double less = 0.99 * contact_limits::rim_front;  // room for round-off
  if (e.is_beam_rim) return false;
  const Point3& inward = faces[e.is_of_b ? 0 : 1].wedge.inward[0];
  const auto is_beside = [&](const Point3& away) {
    const double front = -dot(away, inward);
    return front <= 0 || front * front < less * less * dot(away, away);
  };
  return is_beside(e.from.away) && is_beside(e.to.away);
}

/// Whether the end of a beam that is closest to a point is round there.
KOKKOS_INLINE_FUNCTION bool is_round_there(const EndBeforeRim& e, const RimPoint& point) {
  if (e.are_free) return true;
  const double along = dot(point.away, e.rim_along), most = contact_limits::round_end;
  return along * along <= most * most * dot(point.away, point.away) * dot(e.rim_along, e.rim_along);
}

/// Whether an end is so near its rim that the faces of both decide.
KOKKOS_INLINE_FUNCTION bool is_near_rim(const EndBeforeRim& e, double shorter, bool known) {
  const double past = e.from.past < e.to.past ? e.from.past : e.to.past;
  if (past > (known ? 2 : 1) * contact_limits::rim_end_band &&
      !(e.is_beam_rim && (is_round_there(e, e.to) || is_round_there(e, e.from))))
    return false;
  return may_reach(e, contact_limits::history_row_gap * shorter + e.offset);
}

/// Vector from an end of an edge along the only beam that continues there, at the end of the step; zero: none does.
KOKKOS_INLINE_FUNCTION Point3 find_next_along(const EdgeSurface& surface, const SurfaceMotion& motion, int edge,
                                              int end) {
  const int next = find_next_node(surface, edge, end), own = surface.ends(edge, end);
  if (next < 0) return {};
  return (load_row(motion.x, next) - load_row(motion.x, own)) +
         motion.dt * (load_row(motion.v, next) - load_row(motion.v, own));
}

/// End i of a pair, 0 and 1 of A, 2 and 3 of B, before the rim of the other edge.
KOKKOS_INLINE_FUNCTION EndBeforeRim load_end_of(const CheckedEdges& p, const EdgePair& from, const EdgePair& to,
                                                int i) {
  const EdgeSurface& surface = p.surface;
  const auto& [a, b] = p.edge;
  const bool is_of_b = i >= 2;
  const int rim = is_of_b ? a : b, edge = is_of_b ? b : a;
  EndBeforeRim e = load_end(from, to, is_of_b, i % 2);
  e.offset = find_edge_offset(surface, a) + find_edge_offset(surface, b);
  e.cushion = find_beam_cushion(surface, a, b);
  e.is_beam_rim = is_beam(surface, rim);
  e.next = find_next_along(surface, p.motion, edge, i % 2);
  if (e.to.past > 0) e.rim_next = find_next_along(surface, p.motion, rim, e.to.t < 0.5 ? 0 : 1);
  e.are_free = is_free_end(surface, edge, i % 2) && is_free_end(surface, rim, e.to.t < 0.5 ? 0 : 1);
  return e;
}

/// Checks the ends of one edge of a pair before the other one; touch is meaningful if the answer is true.
PERCUSS_NO_INLINE inline bool check_rim_pair(const CheckedEdges& p, const MovingPair& pair, EdgeTouch& touch) {
  const auto& [a, b] = p.edge;
  const bool is_rim_of[2] = {is_rim(p.surface, a), is_rim(p.surface, b)};
  if (!is_rim_of[0] && !is_rim_of[1]) return false;
  const bool known = p.last_normal != nullptr;
  const EdgePair from = pair.start, to = pair.at(1);
  const double of_a = norm(from.a[1] - from.a[0]), of_b = norm(from.b[1] - from.b[0]);
  EdgeFaces faces[2];
  bool has_faces = false, found = false;
  for (int i = 0; i < 4; ++i) {
    const bool is_of_b = i >= 2;
    if (!is_rim_of[is_of_b ? 0 : 1]) continue;
    const EndBeforeRim e = load_end_of(p, from, to, i);
    if (!is_near_rim(e, of_a < of_b ? of_a : of_b, known)) continue;
    if (!has_faces) load_both_faces(p, faces);
    has_faces = true;
    if (!known && is_surely_beside(e, faces)) continue;
    EdgeTouch end = touch;
    end.size = faces[0].size < faces[1].size ? faces[0].size : faces[1].size;
    end.offset = static_cast<float>(e.offset);
    const Point3 last = !known ? Point3{} : is_of_b ? -*p.last_normal : *p.last_normal;
    if (!check_end(e, faces, known ? &last : nullptr, end)) continue;
    take_nearer(end, is_of_b, i % 2, !found, touch);
    found = true;
  }
  return found;
}

/// How deep the ends of two edges are inside a beam of the pair at the places of a motion with dt = 0, where their
/// lines do not cross: find_edge_depth().
PERCUSS_NO_INLINE inline double find_beam_depth(const EdgeSurface& surface, const SurfaceMotion& motion, int a, int b,
                                                EdgeTouch& touch) {
  if (!is_beam(surface, a) && !is_beam(surface, b)) return 0;
  const EdgePair at = load_moving_pair(surface, motion, a, b).start;
  const Array<EdgeFaces> none;
  const CheckedEdges checked{surface, motion, none, {a, b}, nullptr};
  EdgeFaces faces[2];
  load_both_faces(checked, faces);
  touch.size = faces[0].size < faces[1].size ? faces[0].size : faces[1].size;
  double depth = 0;
  for (int i = 0; i < 4; ++i) {
    const EndBeforeRim e = load_end_of(checked, at, at, i);
    const double distance = norm(e.to.away);
    if (!e.is_beam_rim || !(distance > 0) || e.offset - distance <= depth || !is_near_rim(e, touch.size, false))
      continue;
    const Point3 push = normalize(e.to.away);
    if (!is_before_rim(e, faces, push, false)) continue;
    depth = e.offset - distance;
    touch.offset = static_cast<float>(e.offset);
    touch.normal = e.is_of_b ? -push : push;
  }
  return depth;
}

}  // namespace percuss
