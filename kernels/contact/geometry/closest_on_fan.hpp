#pragma once
// The closest points of the four triangles of a face to the origin of the coordinates, all at once: one triangle a
// lane.

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/core/simd.hpp"

namespace percuss {

#if defined(PERCUSS_HAS_SIMD)
/// Four doubles, whatever the width of a register.
using FanPack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 4>>;
PERCUSS_FORCE_INLINE FanPack load_fan(const double* from) { return {from, std::experimental::element_aligned}; }
PERCUSS_FORCE_INLINE void store_fan(double* to, const FanPack& a) { a.copy_to(to, std::experimental::element_aligned); }
inline constexpr int fan_lanes = 4;
#else
using FanPack = double;
PERCUSS_FORCE_INLINE FanPack load_fan(const double* from) { return *from; }
PERCUSS_FORCE_INLINE void store_fan(double* to, const FanPack& a) { *to = a; }
inline constexpr int fan_lanes = 1;
#endif
using FanPoint = Vector3<FanPack>;

PERCUSS_FORCE_INLINE FanPoint spread_to_fan(const Point3& a) { return {FanPack(a.x), FanPack(a.y), FanPack(a.z)}; }

/// As find_closest_on_triangle() of face_geometry.hpp, lane by lane to the same bits: the regions in reverse order,
/// each of which takes over what the later ones found, and one division for all that divide.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_closest_on_triangles(const Vector3<T>& a, const Vector3<T>& b,
                                                          const Vector3<T>& c) {
  const T zero(0), one(1);
  const Vector3<T> ab = b - a, ac = c - a;
  const T d1 = -dot(ab, a), d2 = -dot(ac, a), d3 = -dot(ab, b), d4 = -dot(ac, b), d5 = -dot(ab, c), d6 = -dot(ac, c);
  const T vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  const T sum = va + vb + vc;
  const auto has_area = sum > zero;
  // Inside: (1 - v - w, v, w) with v = vb / sum, w = vc / sum; on the other edges and corners likewise.
  T of_v = select(has_area, vb, zero), of_w = select(has_area, vc, zero), over = select(has_area, sum, one);
  const auto take = [&](const auto& is_here, const T& v, const T& w, const T& by) {
    of_v = select(is_here, v, of_v);
    of_w = select(is_here, w, of_w);
    over = select(is_here, by, over);
  };
  const auto on_bc = va <= zero && d4 - d3 >= zero && d5 - d6 >= zero;
  const auto on_ac = vb <= zero && d2 >= zero && d6 <= zero, at_c = d6 >= zero && d5 <= d6;
  const auto on_ab = vc <= zero && d1 >= zero && d3 <= zero, at_b = d3 >= zero && d4 <= d3;
  const auto at_a = d1 <= zero && d2 <= zero;
  take(on_bc, zero, d4 - d3, (d4 - d3) + (d5 - d6));
  take(on_ac, zero, d2, d2 - d6);
  take(at_c, zero, one, one);
  take(on_ab, d1, zero, d1 - d3);
  take(at_b, one, zero, one);
  take(at_a, zero, zero, one);
  const T v = of_v / over, w = of_w / over;
  const auto is_bc = on_bc && !(on_ac || at_c || on_ab || at_b || at_a);
  return {select(is_bc, zero, one - v - w), select(is_bc, one - w, v), w};
}

/// Candidates of find_closest_point() of face_geometry.hpp: for each triangle (middle, corner k, corner k + 1) the
/// coordinates of its closest point, the vector from that to the origin, and its square.
struct FanClosest {
  double bary[3][4], to_origin[3][4], square[4];
};

PERCUSS_FORCE_INLINE void find_closest_on_fan(const Point3& middle, const Point3 (&corner)[4], FanClosest& closest) {
  double first[3][4], second[3][4];
  for (int k = 0; k < 4; ++k) {
    const Point3 &b = corner[k], &c = corner[(k + 1) % 4];
    first[0][k] = b.x, first[1][k] = b.y, first[2][k] = b.z;
    second[0][k] = c.x, second[1][k] = c.y, second[2][k] = c.z;
  }
  const FanPoint a = spread_to_fan(middle);
  for (int k = 0; k < 4; k += fan_lanes) {
    const FanPoint b = {load_fan(first[0] + k), load_fan(first[1] + k), load_fan(first[2] + k)};
    const FanPoint c = {load_fan(second[0] + k), load_fan(second[1] + k), load_fan(second[2] + k)};
    const FanPoint bary = find_closest_on_triangles(a, b, c);
    const FanPoint place = bary.x * a + (bary.y * b + bary.z * c);
    const FanPoint to_origin = {-place.x, -place.y, -place.z};
    store_fan(closest.bary[0] + k, bary.x);
    store_fan(closest.bary[1] + k, bary.y);
    store_fan(closest.bary[2] + k, bary.z);
    store_fan(closest.to_origin[0] + k, to_origin.x);
    store_fan(closest.to_origin[1] + k, to_origin.y);
    store_fan(closest.to_origin[2] + k, to_origin.z);
    store_fan(closest.square + k, dot(to_origin, to_origin));
  }
}

/// normalize() of four vectors at once; to the same bits.
PERCUSS_FORCE_INLINE void normalize_four(double (&a)[3][4]) {
  for (int k = 0; k < 4; k += fan_lanes) {
    const FanPoint v = {load_fan(a[0] + k), load_fan(a[1] + k), load_fan(a[2] + k)};
    const FanPack length = square_root(dot(v, v));
    const auto has_length = length > FanPack(0);
    const FanPack scale = select(has_length, FanPack(1) / select(has_length, length, FanPack(1)), FanPack(0));
    const FanPoint unit = scale * v;
    store_fan(a[0] + k, unit.x);
    store_fan(a[1] + k, unit.y);
    store_fan(a[2] + k, unit.z);
  }
}

}  // namespace percuss
