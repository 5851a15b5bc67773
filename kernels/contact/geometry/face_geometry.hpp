#pragma once
// A contact face as a surface in space: a fan of four triangles around the mean of its corners.
//
// The fan is the same from whichever node it is looked at, its outer edges are the straight edges of the element, so
// neighbours leave no crack. All points are relative to an origin near the face, chosen by the caller.

#include "kernels/contact/geometry/closest_on_fan.hpp"

namespace percuss {

/// Corners of a face, or of one face a lane.
template <class T>
struct FaceOf {
  Vector3<T> corner[4]{};
};
using FacePoints = FaceOf<double>;

KOKKOS_INLINE_FUNCTION Point3 find_middle(const FacePoints& face) {
  return 0.25 * ((face.corner[0] + face.corner[1]) + (face.corner[2] + face.corner[3]));
}

/// Outward unit normal: half the cross product of the diagonals, which is the exact area vector of the fan.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_face_normal(const FaceOf<T>& face) {
  return normalize(cross(face.corner[2] - face.corner[0], face.corner[3] - face.corner[1]));
}

KOKKOS_INLINE_FUNCTION bool is_same_point(const Point3& a, const Point3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Shortest edge of a face. A triangle has one corner twice: the edge between both copies does not count.
template <class T>
PERCUSS_FORCE_INLINE T find_shortest_edge(const FaceOf<T>& face) {
  const T zero(0);
  T shortest = zero;
  for (int i = 0; i < 4; ++i) {
    const Vector3<T> edge = face.corner[(i + 1) % 4] - face.corner[i];
    const T square = dot(edge, edge);
    shortest = select(square > zero && (shortest == zero || square < shortest), square, shortest);
  }
  return square_root(shortest);
}

/// A point of a face.
struct FacePoint {
  double weight[4] = {0, 0, 0, 0};  // of the corners; their sum is 1
  int triangle = 0;                 // of the fan
  double distance = 0;              // of the asking point from it
  double off = 0;                   // part of that distance along the face: 0 unless the point lies beside the face
  Point3 normal{};                  // outward unit normal of the triangle
};

/// Barycentric coordinates of the point of triangle (a, b, c) closest to the origin of the coordinates, by the region
/// of the plane that the origin projects to.
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
KOKKOS_INLINE_FUNCTION Point3 find_closest_on_triangle(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a, ac = c - a;
  const double d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const double d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};  // a triangle without area
  const double v = vb / sum, w = vc / sum;
  return {1 - v - w, v, w};
}

/// Weights of the corners for barycentric coordinates in triangle k of the fan: (middle, corner k, corner k + 1).
KOKKOS_INLINE_FUNCTION void set_fan_weights(int k, const Point3& barycentric, double weight[4]) {
  for (int i = 0; i < 4; ++i) weight[i] = 0.25 * barycentric.x;
  weight[k] += barycentric.y;
  weight[(k + 1) % 4] += barycentric.z;
}

/// Length of a vector without its part along a unit normal.
KOKKOS_INLINE_FUNCTION double find_length_in_plane(const Point3& vector, const Point3& normal) {
  return norm(vector - dot(vector, normal) * normal);
}

/// The point of the face closest to the origin of the coordinates; on ties the first triangle of the fan. Where a
/// corner stands twice the fan has a triangle without area, which is none.
KOKKOS_INLINE_FUNCTION FacePoint find_closest_point(const FacePoints& face) {
  const Point3 middle = find_middle(face);
  FanClosest closest;
  find_closest_on_fan(middle, face.corner, closest);
  int k = -1;
  for (int i = 0; i < 4; ++i) {
    if (is_same_point(face.corner[i], face.corner[(i + 1) % 4])) continue;
    if (k < 0 || !(closest.square[k] >= 0 && closest.square[i] >= closest.square[k])) k = i;
  }
  if (k < 0) k = 0;
  const Point3 bary{closest.bary[0][k], closest.bary[1][k], closest.bary[2][k]};
  const Point3 to_origin{closest.to_origin[0][k], closest.to_origin[1][k], closest.to_origin[2][k]};
  FacePoint best;
  best.triangle = k;
  set_fan_weights(k, bary, best.weight);
  best.normal = normalize(cross(face.corner[k] - middle, face.corner[(k + 1) % 4] - middle));
  // Only the outer edge of the fan ends the face.
  best.off = bary.x > 0 ? 0 : find_length_in_plane(to_origin, best.normal);
  best.distance = std::sqrt(closest.square[k]);
  return best;
}

/// Outward unit normal of triangle k of the fan.
KOKKOS_INLINE_FUNCTION Point3 find_triangle_normal(const FacePoints& face, int k) {
  const Point3 middle = find_middle(face);
  return normalize(cross(face.corner[k] - middle, face.corner[(k + 1) % 4] - middle));
}

/// The point of the face with these weights.
KOKKOS_INLINE_FUNCTION Point3 interpolate(const FacePoints& face, const double weight[4]) {
  return (weight[0] * face.corner[0] + weight[1] * face.corner[1]) +
         (weight[2] * face.corner[2] + weight[3] * face.corner[3]);
}

}  // namespace percuss
