#pragma once
// Gauss points across the thickness of a shell.

#include <Kokkos_Core.hpp>

#include <cmath>
#include <numbers>

namespace percuss {

/// Most points that a shell of one material can have, and most that the plies of a laminate have together.
inline constexpr int most_thickness_points = 16, most_layers = 48;

/// Points unless the deck says: enough for the moment of a section that yields (0.94 of the fully plastic one), or for
/// more than linear stress.
inline constexpr int points_of_plastic_shells = 5, points_of_elastic_shells = 3;

/// Places from -1 (bottom) to 1 (top, along the normal); weights, which add up to 1, and shares of the points in the
/// bending stiffness, which do so too.
struct ThicknessPoints {
  int count = 0;
  double place[most_layers] = {};
  double weight[most_layers] = {};
  double bending[most_layers] = {};
};

/// The Gauss-Legendre rule of 1 to most_thickness_points points, exact for polynomials of degree 2 count - 1 (roots by
/// Newton's method from Tricomi's estimate; Press et al., Numerical Recipes, section 4.6). Ascending, and symmetric to
/// the last bit.
inline ThicknessPoints find_thickness_points(int count) {
  ThicknessPoints points;
  points.count = count;
  for (int i = 0; i < (count + 1) / 2; ++i) {
    double z = 2 * i + 1 == count ? 0 : std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double p = 1, before = 0;  // Legendre polynomials of degree j and j - 1 at z
      for (int j = 0; j < count; ++j) {
        const double next = ((2 * j + 1) * z * p - j * before) / (j + 1);
        before = p;
        p = next;
      }
      slope = count * (z * p - before) / (z * z - 1);
      if (z != 0) z -= p / slope;
    }
    points.place[i] = -z;
    points.place[count - 1 - i] = z;
    points.weight[i] = points.weight[count - 1 - i] = 1 / ((1 - z * z) * slope * slope);
  }
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += points.weight[i] * points.place[i] * points.place[i];
  for (int i = 0; i < count; ++i) {
    points.bending[i] = sum > 0 ? points.weight[i] * points.place[i] * points.place[i] / sum : points.weight[i];
  }
  return points;
}

}  // namespace percuss
