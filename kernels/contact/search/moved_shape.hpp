#pragma once
// Faces moved outward for the thickness of shells, and how much of their shape stays while nodes travel: a node that
// has no history is in contact with a face only where it comes near to the face as it is moved.

#include "kernels/contact/search/face_slabs.hpp"
#include "kernels/contact/surface/offset_faces.hpp"

namespace percuss {

/// The chord of the angle that a normal turns by, in what bound_turn() begins with.
inline constexpr double chord_of_turn = 1.15;

/// The angle whose cosine is contact_limits::smooth.
inline constexpr double smooth_angle = 0.45102681179626236;

/// Faces at places of the contact nodes.
struct PlacedFaces {
  ContactSurface surface;
  Rows3<const double> places;  // [contact nodes]
  Rows3<const double> normal;  // [faces]
  Array<const double> turn;    // [faces] FaceSlabs::turn

  KOKKOS_INLINE_FUNCTION Point3 operator()(int node) const { return load_row(places, node); }
};

/// The directions in which the corners of a face are moved by an offset of 1.
struct OutwardBound {
  CornerDirections along;
  double turn = 0;   // of the normal at most, per travel of the nodes around
  double mitre = 0;  // change of the part along the face at most, per travel
  double share = 0;  // of what that part is divided by and loses at most, per travel
  double most = 0;   // the travel up to which this holds

  /// How far one of them changes at most.
  KOKKOS_INLINE_FUNCTION double find_sway(double travel) const {
    return travel * (turn + mitre / (1 - share * travel));
  }
};

/// Follows what the direction of a corner is made of.
struct CornerWatch {
  const PlacedFaces& faces;
  Point3 point, own;
  double own_turn;
  Point3 sum = own;
  double turns = own_turn, most = 1e300;  // of the normals in the sum; travel up to which the sum has the same normals

  /// A normal counts if it is smooth or falls away: one that does both holds until neither is certain.
  KOKKOS_INLINE_FUNCTION void operator()(int other, const Point3& normal, bool is_taken) {
    const double turn = faces.turn(other), cosine = smaller(1.0, larger(-1.0, dot(normal, own)));
    const Point3 from_middle = point - find_middle(find_face_points(faces.surface, faces, other));
    const double away = dot(from_middle, own);
    // The corner and the middle go by one travel each; the third has the square of it.
    const double by_side = std::fabs(away) / (3 + chord_of_turn * own_turn * norm(from_middle));
    const double by_angle = std::fabs(std::acos(cosine) - smooth_angle) / (chord_of_turn * (own_turn + turn));
    const bool is_smooth = cosine > contact_limits::smooth, falls_away = away > 0;
    double holds = is_smooth ? by_angle : by_side;
    if (is_smooth == falls_away) holds = is_smooth ? larger(by_angle, by_side) : smaller(by_angle, by_side);
    most = smaller(most, holds);
    if (!is_taken) return;
    sum = sum + normal;
    turns += turn;
  }
};

/// Bounds the change of one direction of a face.
KOKKOS_INLINE_FUNCTION void bound_corner(const CornerWatch& watch, const Point3& direction, OutwardBound& bound) {
  constexpr double largest_share = 0.5;
  const double along = dot(watch.sum, watch.own), across = norm(watch.sum - along * watch.own);
  const double share = chord_of_turn * (watch.turns + norm(watch.sum) * watch.own_turn) / larger(along, across);
  bound.most = smaller(bound.most, smaller(watch.most, largest_share / share));
  bound.share = larger(bound.share, share);
  bound.mitre = larger(bound.mitre, (1 + norm(direction - watch.own)) * share);
}

KOKKOS_INLINE_FUNCTION OutwardBound find_outward_bound(const PlacedFaces& faces, int face) {
  constexpr double least_bound = 0.4;  // bound_turn() of this and more has none
  const SurfaceOffsets& offsets = faces.surface.offsets;
  OutwardBound bound;
  bound.most = least_bound / faces.turn(face);
  bound.turn = chord_of_turn * faces.turn(face);
  const FacePoints points = find_face_points(faces.surface, faces, face);
  for (int i = 0; i < 4; ++i) {
    if (offsets.is_open(4 * face + i) != 0) bound.most = -1;
    CornerWatch watch{faces, points.corner[i], load_row(faces.normal, face), faces.turn(face)};
    bound.along.of[i] = find_corner_direction(faces.surface, faces, faces.normal, {points, face, i},
                                              [&](int other, const Point3& normal, bool is_taken) {
                                                bound.most = smaller(bound.most, least_bound / faces.turn(other));
                                                watch(other, normal, is_taken);
                                              });
    bound_corner(watch, bound.along.of[i], bound);
  }
  return bound;
}

/// The sine of the angle between the triangles of a face and its normal `own` of now, at most, while the corners travel
/// and the normal turns by `turn`; 1: there is no bound.
KOKKOS_INLINE_FUNCTION double bound_tilt(const FacePoints& face, const Point3& own, double turn, double travel) {
  const Point3 middle = find_middle(face);
  double most = 0;
  for (int k = 0; k < 4; ++k) {
    if (is_same_point(face.corner[k], face.corner[(k + 1) % 4])) continue;
    const Point3 a = face.corner[k] - middle, b = face.corner[(k + 1) % 4] - middle, area = cross(a, b);
    const double whole = norm(area);
    if (!(whole > 0) || !(dot(area, own) > 0)) return 1;
    most = larger(most, norm(cross(area, own)) / whole + bound_turn(2 * (norm(a) + norm(b)) / whole, travel));
  }
  return most + turn < 1 ? most + turn : 1;
}

/// A pair of a node and a face, by the corners of the face relative to the node.
struct PlacedPair {
  int face = 0;
  FacePoints corners;
  double offset = 0;                             // that both keep by thickness
  double size = 0;                               // h of the face, or more
  bool may_be_new = true, may_be_known = false;  // whether it may be accepted as a contact that is new, or goes on
};

/// A face as it is moved outward, relative to a node, and how far its corners go while nodes travel.
struct MovedFace {
  FacePoints corners;
  double travel, of_corner, size, tilt;

  KOKKOS_INLINE_FUNCTION MovedFace(const PlacedFaces& faces, const OutwardBound& bound, const PlacedPair& pair,
                                   double node_travel)
      : corners(pair.corners),
        travel(node_travel),
        of_corner(node_travel + pair.offset * bound.find_sway(node_travel)),
        size(pair.size + 2 * node_travel) {
    for (int i = 0; i < 4; ++i) corners.corner[i] = corners.corner[i] + pair.offset * bound.along.of[i];
    tilt = bound_tilt(corners, load_row(faces.normal, pair.face), chord_of_turn * faces.turn(pair.face) * travel,
                      of_corner);
  }
};

/// Up to this tilt faces are level.
inline constexpr double most_tilt = 0.3;

/// Whether a contact cannot begin. One that does has been nearer to the moved face, within the step or the one before,
/// than its gap or its depth, of which both are at most 0.02 h: over a level face the distance is little more than
/// that. Over others it is within the capture.
KOKKOS_INLINE_FUNCTION bool cannot_begin(const MovedFace& moved) {
  constexpr double level = 1.3 * (contact_limits::row_gap + contact_limits::new_band);
  const double left = (1 - near_slack) * find_closest_point(moved.corners).distance - (moved.travel + moved.of_corner);
  return left > (moved.tilt <= most_tilt ? level : contact_limits::capture) * moved.size;
}

/// Whether a contact cannot go on: the node is beside the moved face, in the plane of the face of the mesh, or farther
/// from it than the reach of a node with a history.
KOKKOS_INLINE_FUNCTION bool cannot_go_on(const MovedFace& moved, const FacePoints& face, const Point3& own,
                                         double offset) {
  constexpr double beside = 1.05 * contact_limits::history_band, of_tilt = 1.1;
  const Point3 along = normalize((face.corner[1] - face.corner[0]) + (face.corner[2] - face.corner[3]));
  const Point3 axis[3] = {own, along, cross(own, along)};
  const double reach = contact_limits::capture * moved.size + offset;
  const double both = (1 + near_slack) * (moved.travel + moved.of_corner);
  const double wide = moved.tilt <= most_tilt ? beside * moved.size + of_tilt * reach * moved.tilt : reach;
  bool is_out = false;
  for (int a = 0; a < 3; ++a) {
    double low = 0, high = 0;
    for (int i = 0; i < 4; ++i) {
      const double height = dot(axis[a], moved.corners.corner[i]);
      low = i == 0 ? height : smaller(low, height);
      high = i == 0 ? height : larger(high, height);
    }
    const double most = (a == 0 ? reach : smaller(wide, reach)) + both + near_slack * near_slack * reach;
    is_out = is_out || low > most || -high > most;
  }
  return is_out;
}

/// Whether a pair is certainly not in contact before some node has gone farther than the travel (bound.most < 0:
/// nothing is known of how the face is moved).
KOKKOS_INLINE_FUNCTION bool stays_apart(const PlacedFaces& faces, const OutwardBound& bound, const PlacedPair& pair,
                                        double travel) {
  if (!(travel <= bound.most)) return false;
  const MovedFace moved(faces, bound, pair, travel);
  if (pair.may_be_known && !cannot_go_on(moved, pair.corners, load_row(faces.normal, pair.face), pair.offset))
    return false;
  return !pair.may_be_new || cannot_begin(moved);
}

}  // namespace percuss
