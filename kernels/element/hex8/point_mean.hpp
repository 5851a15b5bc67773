#pragma once
// The points of a hexahedron across its thickness, and the mean of what its points hold.

#include <Kokkos_Core.hpp>

namespace percuss {

/// Gauss points across the thickness; weights add up to 2.
template <int N>
struct LayerRule;
template <>
struct LayerRule<3> {
  static constexpr double place[3] = {-0.77459666924148337704, 0, 0.77459666924148337704};
  static constexpr double weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
};
template <>
struct LayerRule<5> {
  static constexpr double place[5] = {-0.90617984593866399280, -0.53846931010568309104, 0, 0.53846931010568309104,
                                      0.90617984593866399280};
  static constexpr double weight[5] = {0.23692688505618908751, 0.47862867049936646804, 128.0 / 225,
                                       0.47862867049936646804, 0.23692688505618908751};
};

/// Share of a point in the mean of an element with 1, 2x2x2 or, as thick shell, four times 3 or 5 points, of which four
/// lie in a layer.
KOKKOS_INLINE_FUNCTION double find_point_share(int points, int point) {
  constexpr double three[2] = {LayerRule<3>::weight[1] / 8, LayerRule<3>::weight[0] / 8},
                   five[3] = {LayerRule<5>::weight[2] / 8, LayerRule<5>::weight[1] / 8, LayerRule<5>::weight[0] / 8};
  const int middle = points / 8, layer = point / 4, from_middle = layer < middle ? middle - layer : layer - middle;
  if (points == 12) return three[from_middle];
  if (points == 20) return five[from_middle];
  return 1.0 / points;
}

/// Mean over the points of an element; value(point).
template <class Value>
KOKKOS_INLINE_FUNCTION double find_point_mean(int points, const Value& value) {
  if (points == 1) return value(0);
  double mean = 0;
  for (int p = 0; p < points; ++p) mean += find_point_share(points, p) * value(p);
  return mean;
}

}  // namespace percuss
