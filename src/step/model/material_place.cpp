#include "src/step/model/material_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace percuss {
namespace {

using Weights = std::array<double, kernel_corner_count>;

constexpr std::array<std::array<double, 3>, kernel_corner_count> corner_places{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// ShapeFunctions functions, and their derivatives, in so many directions: two of a shell, three of a solid.
struct ShapeFunctions {
  Weights value{};
  std::array<Weights, 3> slope{};

  ShapeFunctions(const Vec3& at, std::size_t directions) {
    const std::size_t corners = directions == 3 ? 8 : 4;
    const double share = 1.0 / static_cast<double>(corners);
    for (std::size_t i = 0; i < corners; ++i) {
      double factor[3] = {1, 1, 1};
      for (std::size_t d = 0; d < directions; ++d) factor[d] = 1 + corner_places[i][d] * at[d];
      value[i] = share * factor[0] * factor[1] * factor[2];
      for (std::size_t d = 0; d < directions; ++d)
        slope[d][i] = share * corner_places[i][d] * factor[(d + 1) % 3] * factor[(d + 2) % 3];
    }
  }
};

Vec3 sum_weighted(const Weights& weights, const ElementCorners& x) {
  Vec3 point{};
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) point[k] += weights[i] * x[i][k];
  return point;
}

/// The change of coordinates that comes nearest to `way` in the sense of least squares: Cramer's rule on the normal
/// equations, with a little on their diagonal for corners that coincide.
Vec3 solve_least_squares(const std::array<Vec3, 3>& along, std::size_t directions, const Vec3& way) {
  constexpr double little = 1e-13;
  std::array<Vec3, 3> a{};
  Vec3 b{};
  double trace = 0;
  for (std::size_t i = 0; i < 3; ++i) trace += dot(along[i], along[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i >= directions) {
      a[i][i] = 1;
      continue;
    }
    for (std::size_t j = 0; j < directions; ++j) a[i][j] = dot(along[i], along[j]);
    a[i][i] += little * trace;
    b[i] = dot(along[i], way);
  }
  const double determinant = triple_product(a[0], a[1], a[2]);
  if (!(std::abs(determinant) > 0)) return {};
  // a is symmetric: its rows are its columns
  return {triple_product(b, a[1], a[2]) / determinant, triple_product(a[0], b, a[2]) / determinant,
          triple_product(a[0], a[1], b) / determinant};
}

}  // namespace

MaterialPlace find_material_place(const ElementCorners& x, bool is_shell, const Vec3& place) {
  constexpr int steps = 40;  // of Gauss and Newton, within the element: a dozen is enough where it is not degenerate
  const std::size_t directions = is_shell ? 2 : 3;
  Vec3 at{};
  for (int step = 0; step < steps; ++step) {
    const ShapeFunctions shape(at, directions);
    const Vec3 way = subtract(place, sum_weighted(shape.value, x));
    std::array<Vec3, 3> along{};
    for (std::size_t d = 0; d < directions; ++d) along[d] = sum_weighted(shape.slope[d], x);
    const Vec3 change = solve_least_squares(along, directions, way);
    for (std::size_t d = 0; d < directions; ++d) at[d] = std::clamp(at[d] + change[d], -1.0, 1.0);
  }
  const ShapeFunctions shape(at, directions);
  return {shape.value, find_distance(place, sum_weighted(shape.value, x))};
}

}  // namespace percuss
