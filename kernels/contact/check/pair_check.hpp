#pragma once
// The detailed check of one pair: is this contact node in contact with this face in this step, where, how deep?
//
// Ways into contact: the node is at the face at the end of the step (touching: the closest point at the predicted
// place), goes through it within the step (swept, at any speed), leaves it far behind (held), is beside it after it was
// pushed (kept), or went through it in the last step unseen (passed). A node behind a face that it did not go through
// is not in contact with it. Nothing here depends on what other pairs exist.

#include "kernels/contact/check/end_pack.hpp"
#include "kernels/contact/check/touch.hpp"
#include "kernels/contact/geometry/swept_root.hpp"
#include "kernels/contact/surface/face_pack.hpp"
#include "kernels/contact/surface/offset_faces.hpp"

namespace percuss {

/// How far behind a face a node with a history is looked for: where thickness is between them, beyond the mid-surface
/// too, because the history knows from which side it came.
KOKKOS_INLINE_FUNCTION double find_known_depth(const Touch& touch, double depth) {
  return depth * touch.size + (touch.record >= 0 ? touch.offset : 0);
}

/// Deepest start of a step, and farthest end, at which a node is in contact without going through the face.
KOKKOS_INLINE_FUNCTION double find_deepest_start(const Touch& touch) {
  return find_known_depth(touch, touch.record >= 0 ? contact_limits::history_depth : contact_limits::new_depth);
}
KOKKOS_INLINE_FUNCTION double find_reach(const Touch& touch) {
  return find_known_depth(touch, contact_limits::capture);
}

/// The widest predicted gap of a row. What moves far in a step may be pushed as far.
KOKKOS_INLINE_FUNCTION double find_row_gap(const Touch& touch) {
  const double widest = contact_limits::history_row_gap * touch.size;
  const double gap = contact_limits::row_gap * touch.size + contact_limits::row_gap_ways * touch.way;
  return touch.record >= 0 || gap > widest ? widest : gap;
}

/// Bounds leave this much room for round-off.
inline constexpr double bound_slack = 1.001;

/// When contact begins, from the gaps at both ends of the step.
KOKKOS_INLINE_FUNCTION double find_contact_time(const Touch& touch) {
  if (touch.gap_start <= contact_limits::new_band * touch.size) return 0;
  if (touch.gap_end >= 0) return 1;
  return touch.gap_start / (touch.gap_start - touch.gap_end);
}

/// Distance of the origin from the triangle with this normal along a push direction.
KOKKOS_INLINE_FUNCTION double measure_distance(const FacePoints& face, const Point3& normal, const double weight[4],
                                               const Point3& push) {
  const double cosine = dot(normal, push);
  return -dot(cosine > least_push_cosine ? (1 / cosine) * normal : push, interpolate(face, weight));
}

/// Sets direction and predicted gap of a touch at the point of the face with touch.weight, on the triangle with this
/// normal.
KOKKOS_INLINE_FUNCTION void measure_end(const ContactSurface& surface, const FaceState& faces, const FacePoints& end,
                                        const Point3& normal, Touch& touch) {
  touch.normal = find_push_direction(surface, faces, touch.face, touch.weight);
  touch.gap_end = measure_distance(end, normal, touch.weight, touch.normal);
}

/// The gap at n, which is that of the closest point at n: that of the predicted point would count sliding as depth
/// wherever push direction and face differ by a little. Returns that point.
KOKKOS_INLINE_FUNCTION FacePoint measure_start(const FacePoints& start, Touch& touch) {
  const FacePoint before = find_closest_point(start);
  touch.gap_start = measure_distance(start, before.normal, before.weight, touch.normal);
  touch.owes_start = false;
  return before;
}

/// Whether a node with a history was certainly not too deep behind the face at n, which is all that its gap there
/// decides: the closest point at n is no farther than the point of the touch is there.
KOKKOS_INLINE_FUNCTION bool is_surely_shallow(const FacePoints& start, const Touch& touch) {
  const Point3 place = interpolate(start, touch.weight);
  const double least = least_push_cosine * find_deepest_start(touch);
  return touch.record >= 0 && bound_slack * dot(place, place) <= least * least;
}

/// Whether the closest point of the face at the predicted place is within the reach of the node.
KOKKOS_INLINE_FUNCTION bool is_in_reach(const FacePoint& closest, const Touch& touch) {
  const double band = touch.record >= 0 ? contact_limits::history_band : contact_limits::new_band;
  return !(closest.distance > find_reach(touch)) && !(closest.off > band * touch.size);
}

/// Touching: the closest point of the face at the predicted place, which is in reach. In: normal and gap_end there.
KOKKOS_INLINE_FUNCTION bool check_touching(const FacePoints& start, const FacePoint& closest, Touch& touch) {
  const double h = touch.size;
  const bool known = touch.record >= 0;
  for (int i = 0; i < 4; ++i) touch.weight[i] = closest.weight[i];
  touch.off = closest.off;
  if (touch.gap_end > find_row_gap(touch)) return false;
  touch.owes_start = is_surely_shallow(start, touch);
  if (touch.owes_start) return true;
  const FacePoint before = measure_start(start, touch);
  // Sliding in along the plane of the face is later than going through another one.
  touch.tau = before.off > contact_limits::new_band * h ? 1 : find_contact_time(touch);
  if (touch.gap_start < -find_deepest_start(touch)) return false;
  touch.beside = !known && touch.gap_start < -contact_limits::new_band * h && before.off > contact_limits::overlap * h;
  return true;
}

/// Whether the node can come nearer to the face within the step than `band`: by the box of its corners at both ends.
KOKKOS_INLINE_FUNCTION bool may_meet(const FacePoints& start, const FacePoints& end, double band) {
  Point3 low = start.corner[0], high = low;
  const auto include = [&](const Point3& p) {
    low = {smaller(low.x, p.x), smaller(low.y, p.y), smaller(low.z, p.z)};
    high = {larger(high.x, p.x), larger(high.y, p.y), larger(high.z, p.z)};
  };
  for (int i = 0; i < 4; ++i) {
    include(start.corner[i]);
    include(end.corner[i]);
  }
  return low.x <= band && low.y <= band && low.z <= band && high.x >= -band && high.y >= -band && high.z >= -band;
}

/// Swept: the first time at which the node goes through the face.
KOKKOS_INLINE_FUNCTION bool check_swept(const ContactSurface& surface, const FaceState& faces,
                                        const RelativeFace& relative, const FacePoints& end, Touch& touch) {
  const double h = touch.size;
  if (!may_meet(relative.start, end, bound_slack * contact_limits::new_band * h)) return false;
  const SweptHit hit = sweep_face(relative.start, relative.move, contact_limits::new_band * h);
  if (!hit.hit) return false;
  for (int i = 0; i < 4; ++i) touch.weight[i] = hit.weight[i];
  touch.off = hit.off;
  measure_end(surface, faces, end, find_triangle_normal(end, hit.triangle), touch);
  touch.gap_start =
      measure_distance(relative.start, find_triangle_normal(relative.start, hit.triangle), hit.weight, touch.normal);
  touch.tau = touch.gap_start <= contact_limits::new_band * h ? 0 : hit.tau;
  return touch.gap_end <= find_row_gap(touch) && touch.gap_start >= -contact_limits::new_depth * h;
}

/// Passed: the node went through the face in the last step, where no check saw it going: pushes of that step turned it,
/// or the face. The way back from n is that of the last step for all that was pushed in it.
PERCUSS_NO_INLINE inline bool check_passed(const ContactSurface& surface, const FaceState& faces,
                                           const RelativeFace& relative, const FacePoints& end, Touch& touch) {
  const double h = touch.size;
  FacePoints before;
  for (int i = 0; i < 4; ++i) before.corner[i] = relative.start.corner[i] - relative.move.corner[i];
  if (!may_meet(before, relative.start, bound_slack * contact_limits::new_band * h)) return false;
  const SweptHit hit = sweep_face(before, relative.move, contact_limits::new_band * h);
  if (!hit.hit) return false;
  const double height = -dot(find_triangle_normal(before, hit.triangle), interpolate(before, hit.weight));
  const FacePoint closest = find_closest_point(relative.start);
  if (height <= contact_limits::overlap * h || closest.off > contact_limits::new_band * h) return false;
  for (int i = 0; i < 4; ++i) touch.weight[i] = closest.weight[i];
  touch.off = closest.off;
  touch.tau = 0;
  measure_end(surface, faces, end, find_triangle_normal(end, closest.triangle), touch);
  touch.gap_start = measure_distance(relative.start, closest.normal, closest.weight, touch.normal);
  touch.owes_start = touch.beside = false;
  return touch.gap_end <= find_row_gap(touch) && touch.gap_start >= -contact_limits::history_depth * h;
}

/// Whether a node is certainly not held, by its distance from the closest point at the predicted place: from there to
/// the closest point at n, and from that to its predicted place, no way is longer than what a corner moves.
KOKKOS_INLINE_FUNCTION bool is_surely_not_held(const FacePoints& move, double distance, const Touch& touch) {
  double farthest = 0;
  for (int i = 0; i < 4; ++i) farthest = larger(farthest, dot(move.corner[i], move.corner[i]));
  return bound_slack * (distance + 2 * std::sqrt(farthest)) < least_push_cosine * find_reach(touch);
}

/// Held: at the face at the start of the step and so far behind it at the end that the closest point there says
/// nothing. Only at speeds of the order of a face a step.
PERCUSS_NO_INLINE inline bool check_held(const ContactSurface& surface, const FaceState& faces, const FacePoints& start,
                                         const FacePoints& end, Touch& touch) {
  const double h = touch.size;
  const bool known = touch.record >= 0;
  const FacePoint closest = find_closest_point(start);
  if (closest.distance > find_reach(touch)) return false;
  if (closest.off > (known ? contact_limits::history_band : contact_limits::new_band) * h) return false;
  for (int i = 0; i < 4; ++i) touch.weight[i] = closest.weight[i];
  touch.off = closest.off;
  measure_end(surface, faces, end, find_triangle_normal(end, closest.triangle), touch);
  touch.gap_start = measure_distance(start, closest.normal, closest.weight, touch.normal);
  if (touch.gap_start > contact_limits::new_band * h || touch.gap_end > -find_reach(touch)) return false;
  return touch.gap_start >= -find_deepest_start(touch);
}

/// Kept: the face pushed the node in the last step and the predicted place is beside it. Between two faces that meet in
/// a valley neither may be dropped before the other holds the node, or it is pushed into the one that is.
PERCUSS_NO_INLINE inline bool check_kept(const ContactSurface& surface, const FaceState& faces, const FacePoints& start,
                                         const FacePoints& end, Touch& touch) {
  if (!touch.same_face) return false;
  const double h = touch.size;
  const FacePoint before = find_closest_point(start);
  if (before.distance > find_reach(touch) || before.off > contact_limits::history_band * h) return false;
  for (int i = 0; i < 4; ++i) touch.weight[i] = before.weight[i];
  touch.off = before.off;
  touch.is_kept = true;
  measure_end(surface, faces, end, find_triangle_normal(end, before.triangle), touch);
  touch.gap_start = measure_distance(start, before.normal, before.weight, touch.normal);
  touch.owes_start = false;
  return touch.gap_end <= find_row_gap(touch) && touch.gap_start >= -find_deepest_start(touch);
}

/// A node of pairs: where it is, and what it remembers.
struct PairNode {
  CheckedNode at;
  KnownFaces known;
};

/// Pairs that are checked together; touch is meaningful for those that are found in contact.
struct PairPack {
  FacePack faces;
  Touch touch[FacePack::lanes];
  int node[FacePack::lanes];  // of each pair, among the nodes that are checked together
};

/// Adds the pair of node `number` and a face whose box it meets, unless thickness keeps them apart for certain.
template <Thickness thickness>
KOKKOS_INLINE_FUNCTION void add_pair(const MovingSurface& moving, const PairNode& node, int number, int face,
                                     PairPack& pairs) {
  const ContactSurface& surface = moving.surface;
  const FaceState& faces = moving.faces;
  const double offset = thickness == Thickness::of_shells ? find_offset(surface.offsets, node.at.node, face) : 0;
  const int lane = pairs.faces.count;
  Touch& touch = pairs.touch[lane];
  start_touch(face, faces.size(face), offset, touch);
  pairs.node[lane] = number;
  if (offset > 0) {
    find_record(surface, faces, node.known, touch);
    if (is_off_slab(faces.slab(face), load_row(faces.normal, face), moving.motion, node.at,
                    {offset, contact_limits::history_row_gap * touch.size, find_reach(touch)}))
      return;
  }
  if constexpr (thickness == Thickness::of_shells)
    add_face(faces, face, load_touched_face(moving, node.at.x, node.at.v, face, offset), pairs.faces);
  else
    add_face(moving, node.at, face, pairs.faces);
}

/// How a pair may still be in contact.
enum class PairOutlook { out, swept_only, any };

/// Whether the node is in front of the face at the start, as it must be to go through. Faces that only meet at an edge,
/// as those of bricks in line do, are hit only by going through them for certain.
KOKKOS_INLINE_FUNCTION bool starts_in_front(const FacePack& faces, int lane, double size) {
  return faces.range.most_start[lane] > contact_limits::overlap * size;
}

/// Whether the node may have gone through the face in the last step: it is behind its plane now and was clearly in
/// front, if its motion was the same.
KOKKOS_INLINE_FUNCTION bool may_have_passed(const FacePack& faces, int lane, double size) {
  if (!(faces.range.least[lane] < 0)) return false;
  const Point3 normal{faces.normal[0][lane], faces.normal[1][lane], faces.normal[2][lane]};
  const FacePoints start = faces.start[lane], move = faces.move[lane];
  bool is_behind = false, was_in_front = false;
  for (int i = 0; i < 4; ++i) {
    const double height = -dot(normal, start.corner[i]);
    is_behind = is_behind || height < 0;
    was_in_front = was_in_front || height + dot(normal, move.corner[i]) > contact_limits::overlap * size;
  }
  return is_behind && was_in_front;
}

/// Judges a pair by the plane of the face, and by the normals of node and face. In: FacePack::range.
template <Thickness thickness>
KOKKOS_INLINE_FUNCTION PairOutlook look_at_pair(const MovingSurface& moving, const PairNode& node, int lane,
                                                PairPack& pairs) {
  const ContactSurface& surface = moving.surface;
  const SurfaceMotion& motion = moving.motion;
  const FaceState& faces = moving.faces;
  Touch& touch = pairs.touch[lane];
  const auto& range = pairs.faces.range;
  if (range.least[lane] > contact_limits::history_row_gap * touch.size || range.most[lane] < -find_reach(touch))
    return PairOutlook::out;
  if (!(touch.offset > 0)) find_record(surface, faces, node.known, touch);
  touch.way = pairs.faces.way[lane];
  if (range.least[lane] > find_row_gap(touch)) return PairOutlook::out;
  touch.opposed = thickness == Thickness::of_shells
                      ? looks_against(surface, motion, faces, node.at.node, touch.face)
                      : has_opposed_face(surface, faces, node.at.node, touch.face, contact_limits::opposing);
  if (touch.opposed || touch.same_face) return PairOutlook::any;
  const bool may_cross =
      starts_in_front(pairs.faces, lane, touch.size) || may_have_passed(pairs.faces, lane, touch.size);
  return may_cross ? PairOutlook::swept_only : PairOutlook::out;
}

/// Whether a pair is in contact. closest: at the predicted place, none where it can only be swept; of those in reach
/// normal and gap_end there are known.
KOKKOS_INLINE_FUNCTION bool judge_pair(const ContactSurface& surface, const FaceState& faces, const FacePoint* closest,
                                       int lane, PairPack& pairs) {
  Touch& touch = pairs.touch[lane];
  const RelativeFace relative = pairs.faces.get_relative(lane);
  const FacePoints end = pairs.faces.end[lane];
  // A node that is farther from the face's plane than the band at both ends of the step, and so at any time, goes
  // through nothing.
  const bool may_sweep = starts_in_front(pairs.faces, lane, touch.size) &&
                         pairs.faces.range.least[lane] <= bound_slack * contact_limits::new_band * touch.size;
  const auto has_passed = [&] {
    return may_have_passed(pairs.faces, lane, touch.size) && check_passed(surface, faces, relative, end, touch);
  };
  if (closest == nullptr)
    return (may_sweep && check_swept(surface, faces, relative, end, touch) &&
            touch.gap_start > contact_limits::overlap * touch.size) ||
           has_passed();
  if (is_in_reach(*closest, touch) && check_touching(relative.start, *closest, touch)) return true;
  if (may_sweep && check_swept(surface, faces, relative, end, touch)) return true;
  if (!is_surely_not_held(relative.move, closest->distance, touch) &&
      check_held(surface, faces, relative.start, end, touch))
    return true;
  return touch.record >= 0 ? check_kept(surface, faces, relative.start, end, touch) : has_passed();
}

/// Closest points of the faces that are to be measured, and normal and predicted gap of the touches in reach there.
KOKKOS_INLINE_FUNCTION void measure_ends(const MovingSurface& moving, const PairOutlook (&outlook)[FacePack::lanes],
                                         PairPack& pairs, FacePoint (&points)[FacePack::lanes]) {
  ClosestPack closest;
  find_closest_points(pairs.faces.end, closest);
  EndPack ends;
  bool is_near[FacePack::lanes];
  for (int lane = 0; lane < pairs.faces.count; ++lane) {
    is_near[lane] = false;
    if (outlook[lane] != PairOutlook::any) continue;
    points[lane] = closest[lane];
    is_near[lane] = is_in_reach(points[lane], pairs.touch[lane]);
    if (is_near[lane]) ends.set(moving, pairs.touch[lane].face, points[lane], lane);
  }
  ends.measure(pairs.faces.end, closest);
  for (int lane = 0; lane < pairs.faces.count; ++lane) {
    if (!is_near[lane]) continue;
    pairs.touch[lane].normal = {ends.normal[0][lane], ends.normal[1][lane], ends.normal[2][lane]};
    pairs.touch[lane].gap_end = ends.gap[lane];
  }
}

/// measure_ends() for one face.
KOKKOS_INLINE_FUNCTION FacePoint measure_one_end(const MovingSurface& moving, const FacePoints& end, Touch& touch) {
  const FacePoint closest = find_closest_point(end);
  if (!is_in_reach(closest, touch)) return closest;
  for (int i = 0; i < 4; ++i) touch.weight[i] = closest.weight[i];
  measure_end(moving.surface, moving.faces, end, closest.normal, touch);
  return closest;
}

/// Checks the pairs of a pack, of nodes nodes(number), and calls found(number, touch) for those in contact, in their
/// order.
template <Thickness thickness, class Nodes, class Found>
KOKKOS_INLINE_FUNCTION void check_pairs(const MovingSurface& moving, const Nodes& nodes, PairPack& pairs,
                                        const Found& found) {
  const int count = pairs.faces.count;
  if (count == 0) return;
  if constexpr (thickness == Thickness::none) shift_to_nodes(moving.motion.dt, pairs.faces);
  measure_motion(pairs.faces);
  PairOutlook outlook[FacePack::lanes];
  int measured = 0;
  for (int lane = 0; lane < count; ++lane) {
    outlook[lane] = look_at_pair<thickness>(moving, nodes(pairs.node[lane]), lane, pairs);
    measured += outlook[lane] == PairOutlook::any ? 1 : 0;
  }
  constexpr int worth_a_pack = 2;  // one face is measured faster by its four triangles at once
  FacePoint points[FacePack::lanes];
  if (measured >= worth_a_pack) measure_ends(moving, outlook, pairs, points);
  for (int lane = 0; lane < count; ++lane) {
    if (outlook[lane] == PairOutlook::out) continue;
    const bool is_measured = outlook[lane] == PairOutlook::any;
    if (is_measured && measured < worth_a_pack)
      points[lane] = measure_one_end(moving, pairs.faces.end[lane], pairs.touch[lane]);
    if (judge_pair(moving.surface, moving.faces, is_measured ? &points[lane] : nullptr, lane, pairs))
      found(pairs.node[lane], pairs.touch[lane]);
  }
}

}  // namespace percuss
