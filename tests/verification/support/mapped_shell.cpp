#include "tests/verification/support/mapped_shell.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "tests/random.hpp"

namespace percuss::test {

using testing_mesh::WrittenBlock;
using testing_mesh::WrittenMesh;
using testing_mesh::WrittenSet;

WrittenMesh make_mapped_shell(const std::array<int, 2>& cells, const std::function<Vec3(double, double)>& place) {
  WrittenMesh mesh;
  for (int j = 0; j <= cells[1]; ++j) {
    for (int i = 0; i <= cells[0]; ++i) mesh.nodes.push_back(place(double(i) / cells[0], double(j) / cells[1]));
  }
  WrittenBlock block{1, "surface", "SHELL4", 4, {}};
  const int row = cells[0] + 1;
  for (int j = 0; j < cells[1]; ++j) {
    for (int i = 0; i < cells[0]; ++i) {
      const std::int64_t low = 1 + i + std::int64_t{row} * j;
      block.corners.insert(block.corners.end(), {low, low + 1, low + 1 + row, low + row});
    }
  }
  mesh.blocks.push_back(block);
  return mesh;
}

std::function<Vec3(double, double)> distort(const std::array<int, 2>& cells, double share,
                                            const std::function<Vec3(double, double)>& place) {
  return [=, random = RandomIndex()](double u, double v) mutable {
    const auto move = [&](double at, int count) {
      const double by = 2 * static_cast<double>(random.below(1000001)) / 1e6 - 1;
      return at + share * by / count;
    };
    const bool is_inside = u > 0 && u < 1 && v > 0 && v < 1;
    if (!is_inside) return place(u, v);
    const double moved_u = move(u, cells[0]), moved_v = move(v, cells[1]);
    return place(moved_u, moved_v);
  };
}

WrittenMesh make_quarter_disc(int n, const std::function<Vec3(double, double)>& place) {
  constexpr double core = 0.5, bulge = 0.85;  // half the core's edge; its corner as a share of that of a square
  WrittenMesh mesh;
  std::map<std::array<int, 3>, std::int64_t> ids;  // by ring (0: core), place
  std::vector<std::array<double, 2>> flat;
  const auto add = [&](const std::array<int, 3>& key, double x, double y) {
    flat.push_back({x, y});
    mesh.nodes.push_back(place(x, y));
    ids[key] = static_cast<std::int64_t>(mesh.nodes.size());
  };
  const auto core_place = [&](double a, double b) {  // of the unit square
    const double shrink = 1 - (1 - bulge) * a * b;
    return std::array{core * a * shrink, core * b * shrink};
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const auto [x, y] = core_place(double(i) / n, double(j) / n);
      add({0, i, j}, x, y);
    }
  const auto border = [n](int k) { return k <= n ? std::array{0, n, k} : std::array{0, 2 * n - k, n}; };
  for (int ring = 1; ring <= n; ++ring)
    for (int k = 0; k <= 2 * n; ++k) {
      const auto start = flat[static_cast<std::size_t>(ids.at(border(k)) - 1)];
      const double angle = 0.5 * std::numbers::pi * k / (2 * n), s = double(ring) / n;
      add({ring, k, 0}, (1 - s) * start[0] + s * std::cos(angle), (1 - s) * start[1] + s * std::sin(angle));
    }
  const auto ring_node = [&](int ring, int k) { return ids.at(ring == 0 ? border(k) : std::array{ring, k, 0}); };
  WrittenBlock block{1, "surface", "SHELL4", 4, {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      block.corners.insert(block.corners.end(), {ids.at({0, i, j}), ids.at({0, i + 1, j}), ids.at({0, i + 1, j + 1}),
                                                 ids.at({0, i, j + 1})});
  for (int ring = 0; ring < n; ++ring)
    for (int k = 0; k < 2 * n; ++k)
      block.corners.insert(block.corners.end(), {ring_node(ring, k), ring_node(ring + 1, k), ring_node(ring + 1, k + 1),
                                                 ring_node(ring, k + 1)});
  mesh.blocks.push_back(block);
  const auto add_set = [&](std::int64_t id, const char* name, const auto& belongs) {
    WrittenSet set;
    set.id = id;
    set.name = name;
    for (std::size_t i = 0; i < flat.size(); ++i)
      if (belongs(flat[i])) set.entries.push_back(static_cast<std::int64_t>(i) + 1);
    mesh.node_sets.push_back(set);
  };
  constexpr double round_off = 1e-12;
  add_set(1, "x_min", [](const auto& p) { return p[0] < round_off; });
  add_set(2, "y_min", [](const auto& p) { return p[1] < round_off; });
  add_set(3, "rim", [](const auto& p) { return std::hypot(p[0], p[1]) > 1 - round_off; });
  return mesh;
}

void halve(int row, Halving halving, WrittenMesh& mesh) {
  WrittenBlock& block = mesh.blocks.front();
  const std::vector<std::int64_t> quads = block.corners;
  block.corners.clear();
  const bool mixed = halving == Halving::every_other;
  for (std::size_t e = 0; e < quads.size() / 4; ++e) {
    const auto i = static_cast<int>(e) % row, j = static_cast<int>(e) / row;
    const std::int64_t* q = &quads[4 * e];
    if (mixed && (i + j) % 2 == 0) {
      block.corners.insert(block.corners.end(), q, q + 4);
      continue;
    }
    const bool turned = mixed ? i % 2 == 0 : halving == Halving::alternating && (i + j) % 2 == 0;
    const std::array<std::array<int, 3>, 2> halves = turned ? std::array{std::array{0, 1, 3}, std::array{1, 2, 3}}
                                                            : std::array{std::array{0, 1, 2}, std::array{0, 2, 3}};
    for (std::size_t h = 0; h < 2; ++h) {
      for (int c = 0; c < 3; ++c) {
        block.corners.push_back(q[halves[h][static_cast<std::size_t>(c)]]);
        if (mixed && c == (i + static_cast<int>(h)) % 3) block.corners.push_back(block.corners.back());
      }
    }
  }
  if (mixed) return;
  block.topology = "TRI3";
  block.nodes_per_element = 3;
}

void add_edge_sets(const std::array<int, 2>& cells, WrittenMesh& mesh) {
  const int row = cells[0] + 1;
  const auto add = [&](std::int64_t id, const char* name, int count, int first, int stride) {
    WrittenSet set;
    set.id = id;
    set.name = name;
    for (int k = 0; k < count; ++k) set.entries.push_back(1 + first + k * stride);
    mesh.node_sets.push_back(set);
  };
  add(1, "u_min", cells[1] + 1, 0, row);
  add(2, "u_max", cells[1] + 1, cells[0], row);
  add(3, "v_min", row, 0, 1);
  add(4, "v_max", row, row * cells[1], 1);
}

}  // namespace percuss::test
