#pragma once
// How far two straight edges are apart.

#include "kernels/contact/geometry/edge_geometry.hpp"

namespace percuss {

KOKKOS_INLINE_FUNCTION double find_distance_from_edge(const Point3& point, const Point3 (&edge)[2]) {
  const Point3 along = edge[1] - edge[0];
  const double square = dot(along, along), place = square > 0 ? dot(point - edge[0], along) / square : 0;
  return norm(point - edge[0] - (place < 0 ? 0 : place > 1 ? 1 : place) * along);
}

/// Distance of two edges; of nearly parallel ones to a millionth of their lengths.
KOKKOS_INLINE_FUNCTION double find_edge_distance(const EdgePair& e) {
  constexpr double least_sine = 1e-6;
  const Crossing crossing = find_crossing(e, least_sine);
  if (crossing.crosses && is_inside(crossing, 0)) return std::fabs(crossing.gap);
  double distance = find_distance_from_edge(e.a[0], e.b);
  distance = smaller(distance, find_distance_from_edge(e.a[1], e.b));
  distance = smaller(distance, find_distance_from_edge(e.b[0], e.a));
  return smaller(distance, find_distance_from_edge(e.b[1], e.a));
}

}  // namespace percuss
