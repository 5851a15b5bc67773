#pragma once
// The order of points along an axis: by coordinate, then by global id, so that no two points are equal.
//
// A coordinate is kept as an unsigned integer in the same order as the doubles. A cut is then a key, and "half of the
// points" is exact: coincident points and points on one plane are split by id.

#include <cstdint>
#include <cstring>
#include <limits>

#include "kernels/core/views.hpp"

namespace percuss {

/// The bits of a coordinate as an integer that orders like the coordinate. -0.0 counts as 0.0; NaN comes out beyond
/// one of the infinities.
KOKKOS_INLINE_FUNCTION std::uint64_t order_coordinate(double coordinate) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const double one_zero = coordinate + 0.0;  // -0.0 + 0.0 is 0.0
  std::uint64_t bits = 0;
  memcpy(&bits, &one_zero, sizeof(bits));
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// The coordinate whose order_coordinate() this is.
KOKKOS_INLINE_FUNCTION double restore_coordinate(std::uint64_t ordered) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const std::uint64_t bits = (ordered & sign) != 0 ? ordered & ~sign : ~ordered;
  double coordinate = 0;
  memcpy(&coordinate, &bits, sizeof(coordinate));
  return coordinate;
}

struct CoordinateKey {
  std::uint64_t coordinate = 0;  // order_coordinate()
  std::int64_t id = 0;           // global id of the point

  KOKKOS_INLINE_FUNCTION friend bool operator<(const CoordinateKey& a, const CoordinateKey& b) {
    return a.coordinate < b.coordinate || (a.coordinate == b.coordinate && a.id < b.id);
  }
  KOKKOS_INLINE_FUNCTION friend bool operator==(const CoordinateKey& a, const CoordinateKey& b) {
    return a.coordinate == b.coordinate && a.id == b.id;
  }
};

/// Keys before and after every key of a point.
inline constexpr CoordinateKey first_key{0, std::numeric_limits<std::int64_t>::min()};
inline constexpr CoordinateKey last_key{std::numeric_limits<std::uint64_t>::max(),
                                        std::numeric_limits<std::int64_t>::max()};

}  // namespace percuss
