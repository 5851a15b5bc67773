#pragma once
// A rectangular grid of cells and its nodes, both counted along the first direction first.

#include <array>

namespace percuss {

struct CellGrid {
  std::array<int, 3> cells{};

  using Index = std::array<int, 3>;

  int node_count() const { return (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1); }
  int cell_count() const { return cells[0] * cells[1] * cells[2]; }
  int node(int i, int j, int k) const { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); }

  Index find_cell(int cell) const { return split(cell, cells[0], cells[1]); }
  Index find_node(int node) const { return split(node, cells[0] + 1, cells[1] + 1); }

  /// Nodes of a cell, Exodus II HEX8 order.
  std::array<int, 8> corners(const Index& cell) const {
    const auto [i, j, k] = cell;
    return {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
  }

  /// Nodes that an edge joins have other parities.
  static bool is_odd(const Index& index) { return (index[0] + index[1] + index[2]) % 2 != 0; }

  static Index split(int index, int first, int second) {
    return {index % first, index / first % second, index / first / second};
  }
};

}  // namespace percuss
