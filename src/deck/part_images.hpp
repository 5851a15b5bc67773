#pragma once
// Turns and mirror images of points.

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "src/deck/mesh_changes.hpp"

namespace percuss {

using TurnMatrix = std::array<Vec3, 3>;

inline Vec3 transform(const TurnMatrix& m, const Vec3& d) {
  Vec3 x{};
  for (std::size_t i = 0; i < 3; ++i) x[i] = m[i][0] * d[0] + m[i][1] * d[1] + m[i][2] * d[2];
  return x;
}

/// Cosine and sine of an angle in degrees, exact at multiples of 90 so that turned meshes stay on their planes.
inline std::pair<double, double> cosine_and_sine(double degrees) {
  const double rest = std::remainder(degrees, 90.0);  // exact, in [-45, 45]
  const double c = std::cos(rest * std::numbers::pi / 180), s = std::sin(rest * std::numbers::pi / 180);
  const double quarter_turns = std::remainder((degrees - rest) / 90, 4.0);  // -2, -1, 0, 1 or 2
  if (quarter_turns == 0) return {c, s};
  if (quarter_turns == 1) return {-s, c};
  if (quarter_turns == -1) return {s, -c};
  return {-c, -s};
}

/// Rodrigues' formula, R = c I + s [k]x + (1 - c) k k^T.
inline TurnMatrix make_rotation(const Vec3& k, double degrees) {
  const auto [c, s] = cosine_and_sine(degrees);
  const double v = 1 - c;
  return {{{c + v * k[0] * k[0], v * k[0] * k[1] - s * k[2], v * k[0] * k[2] + s * k[1]},
           {v * k[1] * k[0] + s * k[2], c + v * k[1] * k[1], v * k[1] * k[2] - s * k[0]},
           {v * k[2] * k[0] - s * k[1], v * k[2] * k[1] + s * k[0], c + v * k[2] * k[2]}}};
}

/// I - 2 n n^T.
inline TurnMatrix make_reflection(const Vec3& n) {
  TurnMatrix m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j ? 1.0 : 0.0) - 2 * n[i] * n[j];
  return m;
}

/// Matrix by which an image maps directions.
inline TurnMatrix find_matrix(const PartImage& image) {
  if (image.kind == PartImage::Kind::mirror) return make_reflection(image.way);
  return make_rotation(image.way, image.kind == PartImage::Kind::turn ? image.degrees : 0);
}

}  // namespace percuss
