#pragma once
// Points in packs, one a lane: for contact, which is in double throughout.

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/core/transpose.hpp"

namespace percuss {

using Packed = Pack<double>;
using PackedPoint = Vector3<Packed>;
inline constexpr int packed_lanes = pack_size<double>;

template <class Values>
KOKKOS_FORCEINLINE_FUNCTION PackedPoint load_point(const Values& values) {
  return {load_pack(values[0]), load_pack(values[1]), load_pack(values[2])};
}

KOKKOS_FORCEINLINE_FUNCTION void store_point(double (&to)[3][packed_lanes], const PackedPoint& a) {
  store_pack(to[0], a.x);
  store_pack(to[1], a.y);
  store_pack(to[2], a.z);
}

/// Puts a point into all lanes.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint spread_to_pack(const Vector3<double>& a) {
  return {Packed(a.x), Packed(a.y), Packed(a.z)};
}

template <class Mask>
KOKKOS_FORCEINLINE_FUNCTION PackedPoint select_point(const Mask& mask, const PackedPoint& yes, const PackedPoint& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// Rows of node data, one a lane.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint load_points(const Rows3<const double>& rows, const int (&row)[packed_lanes]) {
  Packed packs[3];
  load_rows_of_three(rows.data(), row, packs);
  return {packs[0], packs[1], packs[2]};
}

/// One value a lane, to be stored by lane.
struct LaneValues {
  alignas(64) double of[packed_lanes];

  KOKKOS_FORCEINLINE_FUNCTION explicit LaneValues(const Packed& values) { store_pack(of, values); }
  KOKKOS_FORCEINLINE_FUNCTION double operator[](int lane) const { return of[lane]; }
};

struct LanePoints {
  LaneValues x, y, z;

  KOKKOS_FORCEINLINE_FUNCTION explicit LanePoints(const PackedPoint& a) : x(a.x), y(a.y), z(a.z) {}
  KOKKOS_FORCEINLINE_FUNCTION Point3 operator[](int lane) const { return {x[lane], y[lane], z[lane]}; }
};

}  // namespace percuss
