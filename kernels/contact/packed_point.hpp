#pragma once
// Points in packs, one a lane: for contact, which is in double throughout.

#include "kernels/core/tensor.hpp"

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

/// The same point in all lanes.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint spread_to_pack(const Vector3<double>& a) {
  return {Packed(a.x), Packed(a.y), Packed(a.z)};
}

template <class Mask>
KOKKOS_FORCEINLINE_FUNCTION PackedPoint select_point(const Mask& mask, const PackedPoint& yes, const PackedPoint& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace percuss
