#pragma once
// The boundary of a cube's lattice: its points and its faces.

#include <array>
#include <cstddef>

#include "src/mesh/mesh.hpp"
#include "src/mesh/shapes/cell_grid.hpp"

namespace percuss {

/// The points of a cube's lattice that lie on its boundary, counted along x first.
class CubeBoundary {
 public:
  explicit CubeBoundary(int cells) : cells_(cells), layer_((cells + 1) * (cells + 1)) {}

  int count() const { return 2 * layer_ + (cells_ - 1) * 4 * cells_; }

  /// Place among the boundary's points of one of them.
  int find_place(const CellGrid::Index& point) const {
    const auto [i, j, k] = point;
    if (k == 0) return i + (cells_ + 1) * j;
    const int below = layer_ + (k - 1) * 4 * cells_;
    if (k == cells_) return below + i + (cells_ + 1) * j;
    if (j == 0) return below + i;
    const int rows = below + (cells_ + 1) + 2 * (j - 1);
    return j == cells_ ? rows + i : rows + (i == 0 ? 0 : 1);
  }

  CellGrid::Index find_point(int place) const {
    if (place < layer_) return {place % (cells_ + 1), place / (cells_ + 1), 0};
    const int k = 1 + (place - layer_) / (4 * cells_);
    if (k >= cells_) {
      const int in_layer = place - layer_ - (cells_ - 1) * 4 * cells_;
      return {in_layer % (cells_ + 1), in_layer / (cells_ + 1), cells_};
    }
    const int in_layer = (place - layer_) % (4 * cells_);
    if (in_layer <= cells_) return {in_layer, 0, k};
    const int rest = in_layer - (cells_ + 1);
    if (rest < 2 * (cells_ - 1)) return {rest % 2 == 0 ? 0 : cells_, 1 + rest / 2, k};
    return {rest - 2 * (cells_ - 1), cells_, k};
  }

  int face_count() const { return 6 * cells_ * cells_; }

  /// Lattice points of one of the boundary's faces, outward by the right-hand rule. Faces count along one direction,
  /// along the other, the six faces of the cube in turn.
  std::array<CellGrid::Index, 4> find_face(int index) const {
    constexpr int offsets[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const int face = index % 6, a = index / 6 % cells_, b = index / 6 / cells_, last = cells_ - 1;
    const CellGrid::Index cells[6] = {{a, 0, b}, {last, a, b}, {a, last, b}, {0, a, b}, {a, b, 0}, {a, b, last}};
    std::array<CellGrid::Index, 4> points{};
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t d = 0; d < 3; ++d) {
        const int corner = hex8_topology.face_table[static_cast<std::size_t>(face)].four[c];
        points[c][d] = cells[face][d] + offsets[corner][d];
      }
    }
    return points;
  }

 private:
  int cells_, layer_;
};

}  // namespace percuss
