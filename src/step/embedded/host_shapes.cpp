#include "src/step/embedded/host_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Shape functions of the corners at natural coordinates, and their slopes.
struct Shapes {
  std::array<double, most_corners> value{};
  std::array<Vec3, most_corners> slope{};
};

constexpr std::array<std::array<double, 2>, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// r: from -1 to 1.
Shapes find_hex_shapes(const Vec3& r) {
  Shapes s;
  for (std::size_t i = 0; i < 8; ++i) {
    const double a = square[i % 4][0], b = square[i % 4][1], c = i < 4 ? -1 : 1;
    const double x = 1 + a * r[0], y = 1 + b * r[1], z = 1 + c * r[2];
    s.value[i] = 0.125 * x * y * z;
    s.slope[i] = {0.125 * a * y * z, 0.125 * b * x * z, 0.125 * c * x * y};
  }
  return s;
}

/// r: two area coordinates, and from -1 at the first triangle to 1 at the other.
Shapes find_wedge_shapes(const Vec3& r) {
  Shapes s;
  const double area[] = {1 - r[0] - r[1], r[0], r[1]};
  constexpr double slope[][2] = {{-1, -1}, {1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 6; ++i) {
    const double c = i < 3 ? -1 : 1, z = 0.5 * (1 + c * r[2]);
    s.value[i] = area[i % 3] * z;
    s.slope[i] = {slope[i % 3][0] * z, slope[i % 3][1] * z, 0.5 * c * area[i % 3]};
  }
  return s;
}

/// r: from -1 to 1, the last up to the apex.
Shapes find_pyramid_shapes(const Vec3& r) {
  Shapes s;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = square[i][0], b = square[i][1];
    const double x = 1 + a * r[0], y = 1 + b * r[1], z = 1 - r[2];
    s.value[i] = 0.125 * x * y * z;
    s.slope[i] = {0.125 * a * y * z, 0.125 * b * x * z, -0.125 * x * y};
  }
  s.value[4] = 0.5 * (1 + r[2]);
  s.slope[4] = {0, 0, 0.5};
  return s;
}

/// r: three volume coordinates.
Shapes find_tet_shapes(const Vec3& r) {
  Shapes s;
  s.value = {1 - r[0] - r[1] - r[2], r[0], r[1], r[2]};
  s.slope = {{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return s;
}

/// Shape functions of a kind of solid, their coordinates in its middle, and how far others are outside.
struct HostKind {
  Shapes (*find_shapes)(const Vec3&);
  Vec3 middle;
  double (*find_outside)(const Vec3&);
};

double find_outside_of_cube(const Vec3& r) {
  return 0.5 * (std::max({std::abs(r[0]), std::abs(r[1]), std::abs(r[2])}) - 1);
}
double find_outside_of_wedge(const Vec3& r) {
  return std::max({-r[0], -r[1], r[0] + r[1] - 1, 0.5 * (std::abs(r[2]) - 1)});
}
double find_outside_of_tet(const Vec3& r) { return std::max({-r[0], -r[1], -r[2], r[0] + r[1] + r[2] - 1}); }

HostKind find_kind(TopologyKind kind) {
  switch (kind) {
    case TopologyKind::wedge6:
      return {find_wedge_shapes, {1. / 3, 1. / 3, 0}, find_outside_of_wedge};
    case TopologyKind::pyramid5:
      return {find_pyramid_shapes, {0, 0, -0.5}, find_outside_of_cube};
    case TopologyKind::tet4:
      return {find_tet_shapes, {0.25, 0.25, 0.25}, find_outside_of_tet};
    default:
      return {find_hex_shapes, {0, 0, 0}, find_outside_of_cube};
  }
}

/// The step of Newton's method by which the point with these shapes comes to where `missing` is zero.
std::optional<Vec3> find_step(const Shapes& shapes, std::span<const Vec3> corners, const Vec3& missing, double size) {
  std::array<Vec3, 3> along{};  // derivatives of the place
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) along[j][k] += shapes.slope[i][j] * subtract(corners[i], corners[0])[k];
  const double volume = triple_product(along[0], along[1], along[2]);
  if (!(volume > 1e-12 * size * size * size)) return std::nullopt;
  return Vec3{triple_product(missing, along[1], along[2]) / volume,
              triple_product(along[0], missing, along[2]) / volume,
              triple_product(along[0], along[1], missing) / volume};
}

/// Vector from where the shapes put the point to where it is.
Vec3 find_missing(const Shapes& shapes, std::span<const Vec3> corners, const Vec3& place) {
  Vec3 missing = subtract(place, corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) missing[k] -= shapes.value[i] * subtract(corners[i], corners[0])[k];
  return missing;
}

}  // namespace

std::optional<HostPoint> find_host_point(TopologyKind kind, std::span<const Vec3> corners, const Vec3& place) {
  constexpr double same_place = 1e-12, settled = 1e-15, tolerated = 1e-10, far = 4;
  constexpr int most_turns = 40;
  double size = 0;
  for (const Vec3& corner : corners) size = std::max(size, find_distance(corner, corners[0]));
  HostPoint found;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (find_distance(corners[i], place) > same_place * size) continue;
    found.weights[i] = 1;
    return found;
  }
  const HostKind host = find_kind(kind);
  Vec3 r = host.middle;
  double distance = 0;
  for (int turn = 0; turn < most_turns; ++turn) {
    const Shapes shapes = host.find_shapes(r);
    found.weights = shapes.value;
    const Vec3 missing = find_missing(shapes, corners, place);
    distance = std::sqrt(dot(missing, missing));
    if (distance <= settled * size) break;
    const std::optional<Vec3> step = find_step(shapes, corners, missing, size);
    if (!step) break;
    r = add(r, *step);
    if (std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2]) > far) return std::nullopt;
  }
  if (!(distance <= tolerated * size)) return std::nullopt;
  found.outside = host.find_outside(r);
  return found;
}

}  // namespace percuss
