#include <cmath>
#include <cstddef>
#include <numbers>

#include "src/mesh/part_mesh.hpp"

namespace percuss {
namespace {

/// Cosine and sine of index / count of a turn, reduced to the first eighth so that mirrored and quarter-turned points
/// agree to the last bit.
std::array<double, 2> find_direction(long index, long count) {
  if (2 * index > count) {
    const auto [x, y] = find_direction(count - index, count);
    return {x, -y};
  }
  if (4 * index > count) {
    // Half a turn minus the angle, as a share of twice the count when the count is odd.
    const auto [x, y] = find_direction(count - 2 * index, 2 * count);
    return {-x, y};
  }
  if (8 * index > count) {
    const auto [x, y] = find_direction(count - 4 * index, 4 * count);
    return {y, x};
  }
  if (8 * index == count) return {std::sqrt(0.5), std::sqrt(0.5)};
  const double angle = 2 * std::numbers::pi * (double(index) / double(count));
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

PartMesh make_tube(const TubeShape& shape) {
  const auto [wall, around, along] = shape.cells;
  const auto node = [wall = wall, around = around](int i, int j, int k) {
    return i + (wall + 1) * (j % around + around * k);
  };
  PartMesh mesh;
  for (int k = 0; k <= along; ++k) {
    const double z = shape.length * (double(k) / along);
    for (int j = 0; j < around; ++j) {
      const auto [x, y] = find_direction(j, around);
      for (int i = 0; i <= wall; ++i) {
        const double share = double(i) / wall;
        const double r = (1 - share) * shape.inner_radius + share * shape.outer_radius;
        mesh.nodes.push_back({r * x, r * y, z});
      }
    }
  }
  for (int k = 0; k < along; ++k) {
    for (int j = 0; j < around; ++j) {
      for (int i = 0; i < wall; ++i) {
        const int e = static_cast<int>(mesh.elements.size());
        mesh.elements.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),  //
                                 node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                 node(i, j + 1, k + 1)});
        if (k == 0) mesh.side_sets["start"].push_back({e, 4});
        if (k == along - 1) mesh.side_sets["end"].push_back({e, 5});
        if (i == 0) mesh.side_sets["inner"].push_back({e, 3});
        if (i == wall - 1) mesh.side_sets["outer"].push_back({e, 1});
      }
    }
  }
  return mesh;
}

}  // namespace percuss
