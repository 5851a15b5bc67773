#pragma once
// Faces as slabs along their normals and two axes in them: a node that is out of reach of one stays so for a while.

#include "kernels/contact/surface/listed_faces.hpp"

namespace percuss {

/// By how much node and face can come nearer to the reach of the check, in travels: each by one, and the reach grows
/// with the edges of the face, which grow by two.
inline constexpr double approach_in_travel = 2 * (1 + contact_limits::capture);
/// Room for round-off.
inline constexpr double near_slack = 1e-3;

/// How near a pair can come: not, only where the node has been in contact already, or in any case.
enum Nearness : int { never, once_known, ever };

/// Faces at n as nodes see them, one a lane: their normals and two axes along them.
struct FaceSlabs {
  static constexpr int lanes = packed_lanes, rows = 5;  // of four values in memory
  PackedPoint origin, axis[3];
  Packed low[3], high[3];  // least and greatest height of a corner over the origin, by axis
  Packed capture;          // reach of the check, without thickness
  Packed turn;             // what the sine of the angle that a normal turns by is at most, per travel
};

/// Adds an axis of the slabs: any unit vector, or none.
PERCUSS_FORCE_INLINE void set_axis(const FaceOf<Packed>& face, int k, const PackedPoint& axis, FaceSlabs& slabs) {
  slabs.axis[k] = axis;
  for (int i = 0; i < 4; ++i) {
    const Packed height = dot(axis, face.corner[i]);
    slabs.low[k] = i == 0 ? height : smaller(slabs.low[k], height);
    slabs.high[k] = i == 0 ? height : larger(slabs.high[k], height);
  }
}

/// size: h
PERCUSS_FORCE_INLINE FaceSlabs find_slabs(const FaceOf<Packed>& at, const Packed& size) {
  const FaceOf<Packed> face = find_relative(at);
  const PackedPoint a = face.corner[2] - face.corner[0], b = face.corner[3] - face.corner[1], area = cross(a, b),
                    along = (face.corner[1] - face.corner[0]) + (face.corner[2] - face.corner[3]);
  const PackedPoint normal = normalize(area), first = normalize(along);
  FaceSlabs slabs{};
  slabs.origin = at.corner[0];
  slabs.capture = Packed(contact_limits::capture) * size;
  set_axis(face, 0, normal, slabs);
  set_axis(face, 1, first, slabs);
  set_axis(face, 2, cross(normal, first), slabs);
  // Each diagonal changes by twice the travel at most.
  constexpr double no_bound = 1e300;
  const Packed whole = norm(area), change = Packed(2) * (norm(a) + norm(b));
  slabs.turn = select(whole > Packed(0), change / whole, Packed(no_bound));
  return slabs;
}

/// face: by lane, -1: not to be stored.
PERCUSS_FORCE_INLINE void store_slabs(const FaceSlabs& slabs, const int (&face)[FaceSlabs::lanes],
                                      const Rows4<double>& to) {
  const Packed values[FaceSlabs::rows][4] = {{slabs.origin.x, slabs.origin.y, slabs.origin.z, slabs.capture},
                                             {slabs.axis[0].x, slabs.axis[0].y, slabs.axis[0].z, slabs.turn},
                                             {slabs.axis[1].x, slabs.axis[1].y, slabs.axis[1].z, slabs.low[1]},
                                             {slabs.axis[2].x, slabs.axis[2].y, slabs.axis[2].z, slabs.high[1]},
                                             {slabs.low[0], slabs.high[0], slabs.low[2], slabs.high[2]}};
  for (int r = 0; r < FaceSlabs::rows; ++r) {
    alignas(64) double packs[4][FaceSlabs::lanes];
    int row[FaceSlabs::lanes];
    for (int k = 0; k < 4; ++k) store_pack(packs[k], values[r][k]);
    for (int lane = 0; lane < FaceSlabs::lanes; ++lane)
      row[lane] = face[lane] < 0 ? -1 : FaceSlabs::rows * face[lane] + r;
    store_rows_of_four(packs, row, to.data());
  }
}

PERCUSS_FORCE_INLINE FaceSlabs load_slabs(const Rows4<const double>& from, const int (&face)[FaceSlabs::lanes]) {
  Packed values[FaceSlabs::rows][4];
  for (int r = 0; r < FaceSlabs::rows; ++r) {
    alignas(64) double packs[4][FaceSlabs::lanes];
    int row[FaceSlabs::lanes];
    for (int lane = 0; lane < FaceSlabs::lanes; ++lane) row[lane] = FaceSlabs::rows * face[lane] + r;
    load_rows_of_four(from.data(), row, packs);
    for (int k = 0; k < 4; ++k) values[r][k] = load_pack(packs[k]);
  }
  const auto& [first, normal, along, across, heights] = values;
  return {{first[0], first[1], first[2]},
          {{normal[0], normal[1], normal[2]}, {along[0], along[1], along[2]}, {across[0], across[1], across[2]}},
          {heights[0], along[3], heights[2]},
          {heights[1], across[3], heights[3]},
          first[3],
          normal[3]};
}

/// The sine of the angle that a normal turns by at most in a travel; 1: there is no bound. The square of the travel
/// adds less than a tenth while the first order is below 0.4.
template <class T>
PERCUSS_FORCE_INLINE T bound_turn(const T& turn_rate, const T& travel) {
  const T turn = turn_rate * travel;
  return select(turn < T(0.4), T(1.1) * turn, T(1));
}

/// How near pairs of a node and the faces of the lanes can come while no node goes farther than the travel.
/// offset: the distance that they keep by lane. Without a history, a node is accepted within the capture of the face
/// moved outward by thickness; with one, by the offset farther behind it as well.
PERCUSS_FORCE_INLINE void find_nearness(const FaceSlabs& slabs, const Point3& place, double travel,
                                        const Packed& offset, int (&nearness)[FaceSlabs::lanes]) {
  const PackedPoint from = spread_to_pack(place) - slabs.origin;
  const Packed nearer = slabs.capture + Packed(approach_in_travel * travel);
  const Packed capture = nearer + Packed(near_slack) * (nearer + offset);
  const Packed reach = capture + Packed(1 + longest_mitre) * offset, one(1), zero(0);
  Packed low[3], high[3];  // of the faces over the node
  for (int k = 0; k < 3; ++k) {
    const Packed height = dot(slabs.axis[k], from);
    low[k] = slabs.low[k] - height;
    high[k] = slabs.high[k] - height;
  }
  const auto is_out =
      low[0] > reach || high[0] < -reach || low[1] > reach || high[1] < -reach || low[2] > reach || high[2] < -reach;
  // The moved face is higher by the offset along a normal that turns, and its corners by as much along it at most.
  const Packed turn = bound_turn(slabs.turn, Packed(travel));
  const Packed least = offset * (one - Packed(2) * turn), most = offset * (one + turn);
  const Packed beside = capture + most;
  const auto is_apart = offset > zero && turn < Packed(0.5) &&
                        (low[0] + least > capture || high[0] + most < -capture || low[1] > beside ||
                         high[1] < -beside || low[2] > beside || high[2] < -beside);
  alignas(64) double found[FaceSlabs::lanes];
  const auto spread = [](int value) { return Packed(value); };
  store_pack(found, select(is_out, spread(never), select(is_apart, spread(once_known), spread(ever))));
  for (int lane = 0; lane < FaceSlabs::lanes; ++lane) nearness[lane] = static_cast<int>(found[lane]);
}

}  // namespace percuss
