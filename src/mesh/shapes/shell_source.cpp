// Surfaces of shells: plates, cylinders and cones, balls.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "src/mesh/shapes/cube_boundary.hpp"
#include "src/mesh/shapes/rounded_lattice.hpp"
#include "src/mesh/shapes/shape_source.hpp"
#include "src/mesh/shapes/turn_direction.hpp"

namespace percuss {
namespace {

/// A grid of cells along two directions, the first of which may close on itself. Side numbers are those of
/// side_names(): both ends of the second direction, of the first if it is open, then the surfaces.
template <class Shape>
class GridSource : public ShapeSource {
 public:
  GridSource(const Shape& shape, std::array<int, 2> cells, bool closed)
      : shape_(shape), cells_(cells), closed_(closed), lines_(cells[0] + (closed ? 0 : 1)) {}

  TopologyKind topology() const override { return TopologyKind::quad4; }
  int node_count() const override { return lines_ * (cells_[1] + 1); }
  int element_count() const override { return cells_[0] * cells_[1]; }

  Corners corners(int element) const override {
    const int i = element % cells_[0], j = element / cells_[0];
    return {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
  }

  FaceSides face_sides(int /*element*/) const override {
    const int first = closed_ ? 2 : 4;
    return name_shell_sides(first, first + 1);
  }

  unsigned node_sides(int node) const override {
    const auto [i, j] = find_node(node);
    unsigned sides = closed_ ? 0b1100U : 0b110000U;
    const auto [along_first, along_second] = end_sides();
    if (j == 0) sides |= 1U << along_second;
    if (j == cells_[1]) sides |= 2U << along_second;
    if (!closed_ && i == 0) sides |= 1U << along_first;
    if (!closed_ && i == cells_[0]) sides |= 2U << along_first;
    return sides;
  }

  std::vector<CellBlock> blocks() const override {
    const auto [u, v] = find_edges();
    // A third edge as long as the others: compact tiles have the shortest rims then.
    return {{0, {cells_[0], cells_[1], 1}, {1, cells_[0], element_count()}, {u, v, 0.5 * (u + v)}}};
  }

 protected:
  /// Place along the two directions.
  std::array<int, 2> find_node(int node) const { return {node % lines_, node / lines_}; }
  /// First side of the ends of each direction.
  virtual std::array<int, 2> end_sides() const { return {2, 0}; }
  /// Mean length of an element's edges.
  virtual std::array<double, 2> find_edges() const = 0;

  Shape shape_;
  std::array<int, 2> cells_;

 private:
  int node(int i, int j) const { return (closed_ ? i % lines_ : i) + lines_ * j; }

  bool closed_;
  int lines_;  // of nodes along the first direction
};

class PlateSource final : public GridSource<ShellPlateShape> {
 public:
  explicit PlateSource(const ShellPlateShape& shape) : GridSource(shape, shape.cells, false) {}

  Vec3 place(int node) const override {
    const auto [i, j] = find_node(node);
    return {shape_.size[0] * (double(i) / cells_[0]), shape_.size[1] * (double(j) / cells_[1]), 0};
  }

 private:
  std::array<int, 2> end_sides() const override { return {0, 2}; }
  std::array<double, 2> find_edges() const override { return {shape_.size[0] / cells_[0], shape_.size[1] / cells_[1]}; }
};

class TubeSurface final : public GridSource<ShellTubeShape> {
 public:
  explicit TubeSurface(const ShellTubeShape& shape) : GridSource(shape, shape.cells, shape.arc == full_turn) {}

  Vec3 place(int node) const override {
    const auto [i, j] = find_node(node);
    const auto [x, y] = find_turn_direction(shape_.arc * i, full_turn * cells_[0]);
    const double share = double(j) / cells_[1];
    const double r = (1 - share) * shape_.radius + share * shape_.end_radius.value_or(shape_.radius);
    return {r * x, r * y, shape_.length * share};
  }

 private:
  std::array<double, 2> find_edges() const override {
    const double end = shape_.end_radius.value_or(shape_.radius), middle = 0.5 * (shape_.radius + end);
    return {middle * shape_.arc * std::numbers::pi / (0.5 * full_turn * cells_[0]),
            std::hypot(shape_.length, end - shape_.radius) / cells_[1]};
  }
};

/// Elements count as CubeBoundary::find_face() does.
class SphereSurface final : public ShapeSource {
 public:
  explicit SphereSurface(const ShellSphereShape& shape)
      : shape_(shape), boundary_(shape.cells), lattice_(shape.radius, RoundSplit{shape.cells, 1}) {}

  TopologyKind topology() const override { return TopologyKind::quad4; }
  int node_count() const override { return boundary_.count(); }
  int element_count() const override { return boundary_.face_count(); }

  Corners corners(int element) const override {
    const auto points = boundary_.find_face(element);
    std::array<int, 4> nodes{};
    for (std::size_t c = 0; c < 4; ++c) nodes[c] = boundary_.find_place(points[c]);
    return nodes;
  }

  Vec3 place(int node) const override { return lattice_(boundary_.find_point(node), 1); }
  FaceSides face_sides(int /*element*/) const override { return name_shell_sides(0, 1); }
  unsigned node_sides(int /*node*/) const override { return 0b11; }

  std::vector<CellBlock> blocks() const override {
    const int cells = shape_.cells;
    const double edge = shape_.radius * std::numbers::pi / (2 * cells);
    std::vector<CellBlock> blocks;
    blocks.reserve(6);
    for (int face = 0; face < 6; ++face) {
      blocks.push_back({face, {cells, cells, 1}, {6, 6 * cells, element_count()}, {edge, edge, edge}});
    }
    return blocks;
  }

 private:
  ShellSphereShape shape_;
  CubeBoundary boundary_;
  RoundedLattice<3> lattice_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_shell_source(const ShellPlateShape& shape) {
  return std::make_unique<PlateSource>(shape);
}
std::unique_ptr<ShapeSource> make_shell_source(const ShellTubeShape& shape) {
  return std::make_unique<TubeSurface>(shape);
}
std::unique_ptr<ShapeSource> make_shell_source(const ShellSphereShape& shape) {
  return std::make_unique<SphereSurface>(shape);
}

}  // namespace percuss
