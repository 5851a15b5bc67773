#pragma once
// Points as the bisection sees them, and as one axis orders them.

#include "comm/rcb/coordinate_key.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// This rank's share of the points: contact nodes and the centres of contact faces. Any rank may hold any of them.
struct RcbPoints {
  Rows3<const double> positions;  // [n][3] finite [length]
  Array<const std::int64_t> ids;  // [n] global ids, unique over all ranks
  Array<const int> weights;       // [n] at least 1; or [0]: every point weighs 1
  int count() const { return static_cast<int>(positions.extent(0)); }
};

/// Points by their keys along one axis.
struct AxisPoints {
  RcbPoints points;
  int axis = 0;
  KOKKOS_INLINE_FUNCTION std::uint64_t coordinate(int i) const { return order_coordinate(points.positions(i, axis)); }
  KOKKOS_INLINE_FUNCTION std::int64_t id(int i) const { return points.ids(i); }
  KOKKOS_INLINE_FUNCTION CoordinateKey key(int i) const { return {coordinate(i), id(i)}; }
  KOKKOS_INLINE_FUNCTION int weight(int i) const { return points.weights.extent(0) == 0 ? 1 : points.weights(i); }
};

/// Keys taken out of the points: those that may still be the cut.
struct CandidateKeys {
  Array<CoordinateKey> keys;
  Array<int> weights;
  KOKKOS_INLINE_FUNCTION std::uint64_t coordinate(int i) const { return keys(i).coordinate; }
  KOKKOS_INLINE_FUNCTION std::int64_t id(int i) const { return keys(i).id; }
  KOKKOS_INLINE_FUNCTION CoordinateKey key(int i) const { return keys(i); }
  KOKKOS_INLINE_FUNCTION int weight(int i) const { return weights(i); }
};

}  // namespace percuss
