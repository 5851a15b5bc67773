#include <cstddef>
#include <numbers>

#include "src/mesh/shapes/cell_grid.hpp"
#include "src/mesh/shapes/shape_source.hpp"
#include "src/mesh/shapes/turn_direction.hpp"

namespace percuss {
namespace {

/// A grid through the wall, around and along; the lines of nodes at both ends of a full turn are one.
class TubeSource final : public ShapeSource {
 public:
  // Sides as side_names() lists them.
  enum Side : int { start, end, inner, outer, first, last };

  explicit TubeSource(const TubeShape& shape)
      : shape_(shape),
        grid_{shape.cells},
        closed_(shape.arc == full_turn),
        lines_(shape.cells[1] + (closed_ ? 0 : 1)),
        section_(lines_ * (shape.cells[0] + 1)) {}

  int node_count() const override { return section_ * (grid_.cells[2] + 1); }
  int element_count() const override { return grid_.cell_count(); }

  Corners corners(int element) const override {
    const auto [i, j, k] = grid_.find_cell(element);
    return {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
  }

  Vec3 place(int node) const override {
    const auto [i, j, k] = find_node(node);
    const auto [x, y] = find_turn_direction(shape_.arc * j, full_turn * grid_.cells[1]);
    const double share = double(i) / grid_.cells[0];
    const double r = (1 - share) * shape_.inner_radius + share * shape_.outer_radius;
    return {r * x, r * y, shape_.length * (double(k) / grid_.cells[2])};
  }

  FaceSides face_sides(int element) const override {
    const auto [i, j, k] = grid_.find_cell(element);
    const auto [wall, around, along] = grid_.cells;
    const auto side_if = [](bool outside, Side side) { return outside ? int{side} : interior; };
    return {side_if(!closed_ && j == 0, first),
            side_if(i == wall - 1, outer),
            side_if(!closed_ && j == around - 1, last),
            side_if(i == 0, inner),
            side_if(k == 0, start),
            side_if(k == along - 1, end)};
  }

  unsigned node_sides(int node) const override {
    const auto [i, j, k] = find_node(node);
    unsigned sides = 0;
    const auto add_if = [&](bool outside, Side side) { sides |= outside ? 1U << side : 0U; };
    add_if(k == 0, start);
    add_if(k == grid_.cells[2], end);
    add_if(i == 0, inner);
    add_if(i == grid_.cells[0], outer);
    add_if(!closed_ && j == 0, first);
    add_if(!closed_ && j == grid_.cells[1], last);
    return sides;
  }

  bool is_odd(int node) const override { return CellGrid::is_odd(find_node(node)); }

  std::vector<CellBlock> blocks() const override {
    const auto [wall, around, along] = grid_.cells;
    const double middle = 0.5 * (shape_.inner_radius + shape_.outer_radius);
    return {{0,
             grid_.cells,
             {1, wall, wall * around},
             {(shape_.outer_radius - shape_.inner_radius) / wall,
              middle * shape_.arc * std::numbers::pi / (0.5 * full_turn * around), shape_.length / along}}};
  }

 private:
  int node(int i, int j, int k) const { return i + (grid_.cells[0] + 1) * (closed_ ? j % lines_ : j) + section_ * k; }
  CellGrid::Index find_node(int node) const { return CellGrid::split(node, grid_.cells[0] + 1, lines_); }

  TubeShape shape_;
  CellGrid grid_;
  bool closed_;
  int lines_;    // of nodes around
  int section_;  // nodes of a section
};

}  // namespace

std::unique_ptr<ShapeSource> make_tube_source(const TubeShape& shape) { return std::make_unique<TubeSource>(shape); }

}  // namespace percuss
