#include <cstddef>

#include "src/mesh/shapes/cell_grid.hpp"
#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

// Sides as side_names() lists them: twice the axis, and one more for the upper end.
class BoxSource final : public ShapeSource {
 public:
  explicit BoxSource(const BoxShape& shape) : shape_(shape), grid_{shape.cells} {}

  int node_count() const override { return grid_.node_count(); }
  int element_count() const override { return grid_.cell_count(); }
  Corners corners(int element) const override { return grid_.corners(grid_.find_cell(element)); }

  Vec3 place(int node) const override {
    const CellGrid::Index index = grid_.find_node(node);
    // Dividing first makes the last coordinate the size itself.
    const auto along = [&](std::size_t axis) { return shape_.size[axis] * (double(index[axis]) / shape_.cells[axis]); };
    return {along(0), along(1), along(2)};
  }

  FaceSides face_sides(int element) const override {
    constexpr std::size_t axes[6] = {1, 0, 1, 0, 2, 2};
    constexpr bool upper[6] = {false, true, true, false, false, true};
    const CellGrid::Index cell = grid_.find_cell(element);
    FaceSides sides{};
    for (std::size_t f = 0; f < 6; ++f) {
      const std::size_t axis = axes[f];
      const bool outside = cell[axis] == (upper[f] ? grid_.cells[axis] - 1 : 0);
      sides[f] = outside ? static_cast<int>(2 * axis) + (upper[f] ? 1 : 0) : interior;
    }
    return sides;
  }

  unsigned node_sides(int node) const override {
    const CellGrid::Index index = grid_.find_node(node);
    unsigned sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (index[axis] == 0) sides |= 1U << (2 * axis);
      if (index[axis] == grid_.cells[axis]) sides |= 2U << (2 * axis);
    }
    return sides;
  }

  bool is_odd(int node) const override { return CellGrid::is_odd(grid_.find_node(node)); }

  std::vector<CellBlock> blocks() const override {
    const auto [x, y, z] = grid_.cells;
    return {{0, grid_.cells, {1, x, x * y}, {shape_.size[0] / x, shape_.size[1] / y, shape_.size[2] / z}}};
  }

 private:
  BoxShape shape_;
  CellGrid grid_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_box_source(const BoxShape& shape) { return std::make_unique<BoxSource>(shape); }

}  // namespace percuss
