#pragma once
// Pairs of a node and a candidate face, one a lane: what the detailed check measures on every pair, before it judges
// them one by one. Each lane has the bits of the functions of one face (face_geometry.hpp), so that it does not matter
// which pairs come together.

#include "kernels/contact/geometry/packed_point.hpp"
#include "kernels/contact/surface/contact_state.hpp"

namespace percuss {

/// Signed distances of the node (the origin) from the corners of a face along its normal, positive in front.
template <class T>
struct PlaneRange {
  T least, most;  // over the corners and both ends of the step, and so at any time between
  T most_start;   // over the corners at the start
};

template <class T>
PERCUSS_FORCE_INLINE PlaneRange<T> find_plane_range(const Vector3<T> (&start)[4], const Vector3<T> (&end)[4],
                                                    const Vector3<T>& normal) {
  PlaneRange<T> range{};
  for (int i = 0; i < 4; ++i) {
    const T before = -dot(normal, start[i]), after = -dot(normal, end[i]);
    const auto comes_nearer = after < before;
    const T low = select(comes_nearer, after, before), high = select(comes_nearer, before, after);
    range.least = i == 0 ? low : select(low < range.least, low, range.least);
    range.most = i == 0 ? high : select(high > range.most, high, range.most);
    range.most_start = i == 0 ? before : select(before > range.most_start, before, range.most_start);
  }
  return range;
}

KOKKOS_INLINE_FUNCTION void set_lane(int lane, const Point3& a, double (&to)[3][packed_lanes]) {
  to[0][lane] = a.x;
  to[1][lane] = a.y;
  to[2][lane] = a.z;
}

/// Corners by number, component and lane, relative to the node. A lane without a face is one of no size.
struct alignas(64) CornerPack {
  static constexpr int lanes = packed_lanes;
  double of[4][3][lanes];

  KOKKOS_INLINE_FUNCTION FacePoints operator[](int lane) const {
    FacePoints points;
    for (int i = 0; i < 4; ++i) points.corner[i] = {of[i][0][lane], of[i][1][lane], of[i][2][lane]};
    return points;
  }
  KOKKOS_INLINE_FUNCTION void set(int lane, int corner, const Point3& a) { set_lane(lane, a, of[corner]); }
};

struct alignas(64) FacePack {
  static constexpr int lanes = packed_lanes;
  int count = 0;
  CornerPack start{}, move{};  // at n, and by how much over the step
  double normal[3][lanes] = {};
  double origin[3][lanes] = {}, velocity[3][lanes] = {};  // of the node, for shift_to_nodes()
  CornerPack end;                                         // at the predicted place
  PlaneRange<double[lanes]> range;
  double way[lanes];  // longest way of a corner

  KOKKOS_INLINE_FUNCTION RelativeFace get_relative(int lane) const { return {start[lane], move[lane]}; }
};

/// Adds a face that lies as `relative`.
KOKKOS_INLINE_FUNCTION void add_face(const FaceState& faces, int face, const RelativeFace& relative, FacePack& pack) {
  const int lane = pack.count++;
  for (int i = 0; i < 4; ++i) {
    pack.start.set(lane, i, relative.start.corner[i]);
    pack.move.set(lane, i, relative.move.corner[i]);
  }
  for (int axis = 0; axis < 3; ++axis) pack.normal[axis][lane] = faces.normal(face, axis);
}

/// Adds a face by place and velocity of its corners and of the node, for shift_to_nodes().
KOKKOS_INLINE_FUNCTION void add_face(const MovingSurface& moving, const CheckedNode& node, int face, FacePack& pack) {
  const auto& [surface, motion, faces] = moving;
  const int lane = pack.count++;
  for (int i = 0; i < 4; ++i) {
    const int a = surface.nodes(surface.face_corners(face, i));
    pack.start.set(lane, i, load_row(motion.x, a));
    pack.move.set(lane, i, load_row(motion.v, a));
  }
  for (int axis = 0; axis < 3; ++axis) pack.normal[axis][lane] = faces.normal(face, axis);
  set_lane(lane, node.x, pack.origin);
  set_lane(lane, node.v, pack.velocity);
}

/// Converts places and velocities to what load_relative_face() gives.
KOKKOS_FORCEINLINE_FUNCTION void shift_to_nodes(double dt, FacePack& pack) {
  const PackedPoint origin = load_point(pack.origin), velocity = load_point(pack.velocity);
  for (int i = 0; i < 4; ++i) {
    store_point(pack.start.of[i], load_point(pack.start.of[i]) - origin);
    store_point(pack.move.of[i], Packed(dt) * (load_point(pack.move.of[i]) - velocity));
  }
}

/// Finds end, range and way of all lanes.
KOKKOS_FORCEINLINE_FUNCTION void measure_motion(FacePack& pack) {
  PackedPoint start[4], end[4];
  Packed longest(0);
  for (int i = 0; i < 4; ++i) {
    const PackedPoint move = load_point(pack.move.of[i]);
    start[i] = load_point(pack.start.of[i]);
    end[i] = start[i] + move;
    longest = larger(longest, dot(move, move));
    store_point(pack.end.of[i], end[i]);
  }
  store_pack(pack.way, square_root(longest));
  const PlaneRange<Packed> range = find_plane_range(start, end, load_point(pack.normal));
  store_pack(pack.range.least, range.least);
  store_pack(pack.range.most, range.most);
  store_pack(pack.range.most_start, range.most_start);
}

/// Closest points by lane, as FacePoint has them.
struct alignas(64) ClosestPack {
  static constexpr int lanes = packed_lanes;
  double weight[4][lanes], normal[3][lanes];
  double distance[lanes], off[lanes], triangle[lanes];

  KOKKOS_INLINE_FUNCTION FacePoint operator[](int lane) const {
    FacePoint point;
    for (int i = 0; i < 4; ++i) point.weight[i] = weight[i][lane];
    point.triangle = static_cast<int>(triangle[lane]);
    point.distance = distance[lane];
    point.off = off[lane];
    point.normal = {normal[0][lane], normal[1][lane], normal[2][lane]};
    return point;
  }
};

/// find_closest_point() of the face of each lane.
PERCUSS_NO_INLINE inline void find_closest_points(const CornerPack& face, ClosestPack& closest) {
  const Packed zero(0), one(1), quarter(0.25);
  const auto load = [&face](int i) { return load_point(face.of[i]); };
  const PackedPoint middle = quarter * ((load(0) + load(1)) + (load(2) + load(3)));
  PackedPoint bary{}, to_origin{}, first{}, second{};
  Packed square = zero, key = zero, triangle = zero;  // key: the square to beat, -1 where there is none
  for (int k = 0; k < 4; ++k) {
    const PackedPoint b = load(k), c = load((k + 1) % 4);
    const PackedPoint here = find_closest_on_triangles(middle, b, c);
    const PackedPoint place = here.x * middle + (here.y * b + here.z * c);
    const PackedPoint back{-place.x, -place.y, -place.z};
    const Packed square_here = dot(back, back);
    const auto is_line = b.x == c.x && b.y == c.y && b.z == c.z;
    if (k == 0) {
      bary = here, to_origin = back, first = b, second = c, square = square_here;
      key = select(is_line, -one, square_here);
      continue;
    }
    const auto is_better = !is_line && !(key >= zero && square_here >= key);
    bary = select_point(is_better, here, bary);
    to_origin = select_point(is_better, back, to_origin);
    first = select_point(is_better, b, first);
    second = select_point(is_better, c, second);
    square = select(is_better, square_here, square);
    key = select(is_better, square_here, key);
    triangle = select(is_better, Packed(k), triangle);
  }
  for (int i = 0; i < 4; ++i) {
    Packed weight = quarter * bary.x;
    weight = select(triangle == Packed(i), weight + bary.y, weight);
    weight = select(triangle == Packed((i + 3) % 4), weight + bary.z, weight);
    store_pack(closest.weight[i], weight);
  }
  const PackedPoint area = cross(first - middle, second - middle);
  const Packed length = norm(area);
  const auto has_length = length > zero;
  const Packed scale = one / select(has_length, length, one);
  const PackedPoint normal = select_point(has_length, scale * area, PackedPoint{zero, zero, zero});
  store_point(closest.normal, normal);
  store_pack(closest.off, select(bary.x > zero, zero, norm(to_origin - dot(to_origin, normal) * normal)));
  store_pack(closest.distance, square_root(square));
  store_pack(closest.triangle, triangle);
}

}  // namespace percuss
