#pragma once
// Directions around an axis that agree to the last bit under the symmetries of a circle.

#include <array>
#include <cmath>
#include <numbers>

namespace percuss {

inline constexpr double full_turn = 360;  // degrees

/// Cosine and sine of index / count of a turn, reduced to the first eighth so that mirrored and quarter-turned points
/// agree to the last bit. Whole numbers stay exact, as far as doubles hold them.
inline std::array<double, 2> find_turn_direction(double index, double count) {
  if (2 * index > count) {
    const auto [x, y] = find_turn_direction(count - index, count);
    return {x, -y};
  }
  if (4 * index > count) {
    // Half a turn minus the angle, as a share of twice the count when the count is odd.
    const auto [x, y] = find_turn_direction(count - 2 * index, 2 * count);
    return {-x, y};
  }
  if (8 * index > count) {
    const auto [x, y] = find_turn_direction(count - 4 * index, 4 * count);
    return {y, x};
  }
  if (8 * index == count) return {std::sqrt(0.5), std::sqrt(0.5)};
  const double angle = 2 * std::numbers::pi * (index / count);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace percuss
