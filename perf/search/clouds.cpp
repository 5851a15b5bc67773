#include "perf/search/clouds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace percuss::perf {
namespace {

/// A grid of rows x columns nodes that place(i, j) puts somewhere.
template <class Place>
void add_grid(int rows, int columns, const Place& place, Cloud& cloud) {
  const int first = static_cast<int>(cloud.nodes.size());
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) cloud.nodes.push_back(place(i, j));
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const int n = first + i * columns + j;
      cloud.faces.push_back({n, n + 1, n + columns + 1, n + columns});
    }
}

/// Nodes and faces of the surface of a box of elements.
void add_box(const std::array<int, 3>& cells, const std::array<double, 3>& corner, Cloud& cloud) {
  std::map<std::array<int, 3>, int> numbers;
  const auto find = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = numbers.try_emplace(at, static_cast<int>(cloud.nodes.size()));
    if (is_new) cloud.nodes.push_back({corner[0] + at[0], corner[1] + at[1], corner[2] + at[2]});
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (const int side : {0, cells[axis]})
      for (int i = 0; i < cells[b]; ++i)
        for (int j = 0; j < cells[c]; ++j) {
          std::array<int, 4> face{};
          for (int k = 0; k < 4; ++k) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[b] = i + (k == 1 || k == 2 ? 1 : 0);
            at[c] = j + (k >= 2 ? 1 : 0);
            face[static_cast<std::size_t>(side > 0 ? k : 3 - k)] = find(at);
          }
          cloud.faces.push_back(face);
        }
  }
}

Cloud make_sheet(int num_nodes) {
  Cloud cloud;
  const int columns = static_cast<int>(std::sqrt(num_nodes)), fold = std::max(columns / 4, 1);
  add_grid(
      columns, columns,
      [&](int i, int j) {
        const int layer = i / fold, along = i % fold;
        return std::array<double, 3>{static_cast<double>(layer % 2 == 0 ? along : fold - along), static_cast<double>(j),
                                     0.2 * layer};
      },
      cloud);
  return cloud;
}

Cloud make_bricks(int num_nodes) {
  Cloud cloud;
  constexpr int nodes_of_brick = 56;
  const int bricks = num_nodes / nodes_of_brick, side = std::max(static_cast<int>(std::cbrt(bricks)), 1);
  for (int b = 0; b < bricks; ++b) {
    const int layer = b / (side * side);
    add_box({3, 3, 3}, {3.0 * (b % side) + 1.5 * (layer % 2), 3.0 * (b / side % side), 3.0 * layer}, cloud);
  }
  return cloud;
}

Cloud make_crumple(int num_nodes) {
  constexpr int waves = 12;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const int columns = static_cast<int>(std::sqrt(num_nodes));
  double direction[waves][3], wave[waves][2], phase[waves];
  for (int w = 0; w < waves; ++w) {
    for (double& d : direction[w]) d = number(random);
    for (double& k : wave[w]) k = 40 * number(random) / columns;
    phase[w] = 3 * number(random);
  }
  Cloud cloud;
  add_grid(
      columns, columns,
      [&](int i, int j) {
        std::array<double, 3> x{0.2 * i, 0.2 * j, 0};
        for (int w = 0; w < waves; ++w)
          for (std::size_t axis = 0; axis < 3; ++axis)
            x[axis] += 0.025 * columns * direction[w][axis] * std::sin(wave[w][0] * i + wave[w][1] * j + phase[w]);
        return x;
      },
      cloud);
  return cloud;
}

Cloud make_rod(int num_nodes) {
  Cloud cloud;
  constexpr int width = 8;
  add_box({num_nodes / (4 * width), width, width}, {0, 0, 0}, cloud);
  return cloud;
}

}  // namespace

const std::vector<std::string>& cloud_names() {
  static const std::vector<std::string> names = {"sheet", "bricks", "crumple", "rod"};
  return names;
}

Cloud make_cloud(const std::string& name, int num_nodes) {
  if (name == "sheet") return make_sheet(num_nodes);
  if (name == "bricks") return make_bricks(num_nodes);
  if (name == "crumple") return make_crumple(num_nodes);
  return make_rod(num_nodes);
}

}  // namespace percuss::perf
