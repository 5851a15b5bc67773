#pragma once
// Faces moved outward for the thickness of shells.
//
// At a corner the normals of the faces around it on the same side of the surface are added up: those of one smooth
// surface, and those that fall away from the face, so that the moved faces meet at a convex edge too. Moved faces of a
// concave edge go through one another, and a node there is held by both. Where a shell ends they continue beyond it by
// as much as they are moved, so that edges that meet tip to tip do not slip past one another.

#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// Corners of a face, by place(contact node).
template <class Place>
KOKKOS_INLINE_FUNCTION FacePoints find_face_points(const ContactSurface& surface, const Place& place, int face) {
  FacePoints points;
  for (int i = 0; i < 4; ++i) points.corner[i] = place(surface.face_corners(face, i));
  return points;
}

/// A corner of a face with these points.
struct FaceCorner {
  const FacePoints& points;
  int face, corner;
};

/// The direction in which a corner of a face is moved, by an offset of 1. normals: of all faces around it, at the
/// places of `place`. seen(face, normal, whether it counts): called for each of these.
template <class Place, class Seen>
KOKKOS_INLINE_FUNCTION Point3 find_corner_direction(const ContactSurface& surface, const Place& place,
                                                    const Rows3<const double>& normals, const FaceCorner& of,
                                                    const Seen& seen) {
  const SurfaceOffsets& offsets = surface.offsets;
  const auto& [points, face, corner] = of;
  const Point3 point = points.corner[corner], own = load_row(normals, face);
  const bool is_open = offsets.is_open(4 * face + corner) != 0;
  Point3 sum = own, outlook{};
  if (is_open) outlook = normalize(point - find_middle(points));
  for (int j = offsets.ring_first(4 * face + corner); j < offsets.ring_first(4 * face + corner + 1); ++j) {
    const Point3 normal = load_row(normals, offsets.ring(j));
    bool is_taken = dot(normal, own) > contact_limits::smooth;
    if (!is_taken || is_open) {
      const Point3 from_middle = point - find_middle(find_face_points(surface, place, offsets.ring(j)));
      is_taken = is_taken || dot(from_middle, own) > 0;
      if (is_open) outlook = outlook + normalize(from_middle);
    }
    seen(offsets.ring(j), normal, is_taken);
    if (is_taken) sum = sum + normal;
  }
  Point3 along_face = find_mitre(own, sum);
  if (is_open) along_face = along_face + normalize(outlook - dot(outlook, own) * own);
  return find_outward(own, along_face);
}

/// v turned as `from` is to become `to`, both unit vectors, on the shortest way (Rodrigues); v where they are a right
/// angle apart, or one has no length.
KOKKOS_INLINE_FUNCTION Point3 turn_from_to(const Point3& from, const Point3& to, const Point3& v) {
  const Point3 axis = cross(from, to);
  const double cosine = dot(from, to);
  if (!(cosine > 0)) return v;
  return cosine * v + cross(axis, v) + (dot(axis, v) / (1 + cosine)) * axis;
}

/// Directions in which the corners of a face are moved outward: those of the end of the step and at its start these
/// turned back with the face's normal. What else they change by in a step lies along the face. They belong to the face,
/// whichever node looks at it.
KOKKOS_INLINE_FUNCTION OutwardDirections find_outward_directions(const MovingSurface& moving, int face) {
  const ContactSurface& surface = moving.surface;
  const SurfaceMotion& motion = moving.motion;
  const int origin = surface.nodes(surface.face_corners(face, 0));
  const Point3 x = load_row(motion.x, origin), v = load_row(motion.v, origin);
  const auto at_end = [&](int node) {
    const int a = surface.nodes(node);
    return (load_row(motion.x, a) - x) + motion.dt * (load_row(motion.v, a) - v);
  };
  const FacePoints end = find_face_points(surface, at_end, face);
  const Point3 normal = load_row(moving.faces.normal, face), at_start = moving.faces.slab(face).normal_at_start;
  OutwardDirections found;
  for (int i = 0; i < 4; ++i) {
    found.end.of[i] =
        find_corner_direction(surface, at_end, moving.faces.normal, {end, face, i}, [](int, const Point3&, bool) {});
    found.start.of[i] = turn_from_to(normal, at_start, found.end.of[i]);
  }
  return found;
}

/// The face that a node touches, relative to the node: that of the mesh, moved outward where thickness is between them.
KOKKOS_INLINE_FUNCTION RelativeFace load_touched_face(const MovingSurface& moving, const Point3& x, const Point3& v,
                                                      int face, double offset) {
  RelativeFace relative = load_relative_face(moving.surface, moving.motion, x, v, face);
  if (offset == 0) return relative;
  const auto move = [&](const OutwardDirections& outward) {
    for (int i = 0; i < 4; ++i) {
      const Point3& at_start = outward.start.of[i];
      relative.start.corner[i] = relative.start.corner[i] + offset * at_start;
      relative.move.corner[i] = relative.move.corner[i] + offset * (outward.end.of[i] - at_start);
    }
  };
  if (moving.faces.has_prepared(face))
    move(moving.faces.outward(face));
  else
    move(find_outward_directions(moving, face));
  return relative;
}

KOKKOS_INLINE_FUNCTION RelativeFace load_touched_face(const MovingSurface& moving, int node, int face) {
  const int s = moving.surface.nodes(node);
  return load_touched_face(moving, load_row(moving.motion.x, s), load_row(moving.motion.v, s), face,
                           find_offset(moving.surface.offsets, node, face));
}

/// The slab of a face. relative: to its first corner, which is at `origin` and moves by `move`; normal: at the
/// predicted place.
template <class T>
PERCUSS_FORCE_INLINE FaceSlabOf<T> find_slab(const Vector3<T>& origin, const Vector3<T>& move,
                                             const RelativeFaceOf<T>& relative, const Vector3<T>& normal) {
  FaceSlabOf<T> slab;
  slab.origin = origin;
  slab.move = move;
  for (int i = 0; i < 4; ++i) {
    const T start = dot(normal, relative.start.corner[i]);
    const T end = start + dot(normal, relative.move.corner[i]);
    slab.low_start = i == 0 ? start : smaller(slab.low_start, start);
    slab.high_start = i == 0 ? start : larger(slab.high_start, start);
    slab.low_end = i == 0 ? end : smaller(slab.low_end, end);
    slab.high_end = i == 0 ? end : larger(slab.high_end, end);
  }
  const T slack(1e-6);  // room for round-off
  slab.normal_at_start = find_face_normal(relative.start);
  slab.turn = T(longest_mitre) * norm(normal - slab.normal_at_start) + slack;
  return slab;
}

/// A face moved outward by `offset`, and how far in front of it and behind it something is still looked at.
struct SlabReach {
  double offset, beyond, deepest;
};

/// Whether a node stays, over the step, farther than `beyond` in front of the moved face, or farther than `deepest`
/// behind it: moved corners are higher by the offset, along the normal of their time.
KOKKOS_INLINE_FUNCTION bool is_off_slab(const FaceSlab& slab, const Point3& normal, const SurfaceMotion& motion,
                                        const CheckedNode& node, const SlabReach& reach) {
  const Point3 from = node.x - slab.origin;
  const double start = dot(normal, from), end = start + dot(normal, motion.dt * node.v - slab.move);
  const double high = start - slab.low_start > end - slab.low_end ? start - slab.low_start : end - slab.low_end;
  const double low = start - slab.high_start < end - slab.high_end ? start - slab.high_start : end - slab.high_end;
  return low - (1 + slab.turn) * reach.offset > reach.beyond || high - (1 - slab.turn) * reach.offset < -reach.deepest;
}

}  // namespace percuss
