// The surface of a rectangular profile, open or closed by plates: a tube, a tray or a box of shells.

#include <cstddef>

#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

/// Nodes and elements of the walls come first, around and then along; those of a plate follow along x and then y: of
/// its nodes those that the walls do not have.
class BoxTubeSource final : public ShapeSource {
 public:
  explicit BoxTubeSource(const ShellBoxTubeShape& shape)
      : shape_(shape), around_(2 * (shape.cells[0] + shape.cells[1])) {}

  TopologyKind topology() const override { return TopologyKind::quad4; }
  int node_count() const override { return wall_nodes() + plate_count() * plate_nodes(); }
  int element_count() const override { return wall_elements() + plate_count() * plate_elements(); }

  Corners corners(int element) const override {
    if (element < wall_elements()) {
      const int i = element % around_, j = element / around_;
      return {ring(i, j), ring(i + 1, j), ring(i + 1, j + 1), ring(i, j + 1)};
    }
    const int plate = (element - wall_elements()) / plate_elements();
    const int in_plate = (element - wall_elements()) % plate_elements();
    const int i = in_plate % shape_.cells[0], j = in_plate / shape_.cells[0];
    const auto at = [&](int a, int b) { return plate_node(plate, a, b); };
    if (is_end(plate)) return {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
    return {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)};
  }

  Vec3 place(int node) const override {
    if (node < wall_nodes()) {
      const auto [a, b] = find_on_ring(node % around_);
      return place_at(a, b, node / around_);
    }
    const auto [plate, a, b] = find_in_plate(node);
    return place_at(a, b, is_end(plate) ? shape_.cells[2] : 0);
  }

  FaceSides face_sides(int /*element*/) const override { return name_shell_sides(2, 3); }

  unsigned node_sides(int node) const override {
    constexpr unsigned start = 0b0001, end = 0b0010, surfaces = 0b1100;
    if (node >= wall_nodes()) return surfaces | (is_end(find_in_plate(node)[0]) ? end : start);
    const int layer = node / around_;
    return surfaces | (layer == 0 ? start : 0U) | (layer == shape_.cells[2] ? end : 0U);
  }

  std::vector<CellBlock> blocks() const override {
    const auto [x, y, z] = shape_.cells;
    const double u = shape_.size[0] / x, v = shape_.size[1] / y, w = shape_.length / z;
    const double wall = 2 * (shape_.size[0] + shape_.size[1]) / around_;
    // A third edge as long as the others: compact tiles have the shortest rims then.
    std::vector<CellBlock> blocks{{0, {around_, z, 1}, {1, around_, element_count()}, {wall, w, 0.5 * (wall + w)}}};
    for (int plate = 0; plate < plate_count(); ++plate) {
      const int first = wall_elements() + plate * plate_elements();
      blocks.push_back({first, {x, y, 1}, {1, x, element_count()}, {u, v, 0.5 * (u + v)}});
    }
    return blocks;
  }

 private:
  int plate_count() const { return (shape_.has_start() ? 1 : 0) + (shape_.has_end() ? 1 : 0); }
  bool is_end(int plate) const { return plate == 1 || !shape_.has_start(); }
  int wall_nodes() const { return around_ * (shape_.cells[2] + 1); }
  int wall_elements() const { return around_ * shape_.cells[2]; }
  int plate_nodes() const { return (shape_.cells[0] - 1) * (shape_.cells[1] - 1); }
  int plate_elements() const { return shape_.cells[0] * shape_.cells[1]; }

  int ring(int i, int j) const { return i % around_ + around_ * j; }

  /// Lattice point of a place around, counter-clockwise from the corner of least x and y.
  std::array<int, 2> find_on_ring(int i) const {
    const auto [x, y, z] = shape_.cells;
    if (i < x) return {i, 0};
    if (i < x + y) return {x, i - x};
    if (i < 2 * x + y) return {2 * x + y - i, y};
    return {0, around_ - i};
  }

  /// Node of a plate's lattice point: on its rim that of the walls.
  int plate_node(int plate, int a, int b) const {
    const auto [x, y, z] = shape_.cells;
    const int layer = is_end(plate) ? z : 0;
    if (b == 0) return ring(a, layer);
    if (a == x) return ring(x + b, layer);
    if (b == y) return ring(2 * x + y - a, layer);
    if (a == 0) return ring(around_ - b, layer);
    return wall_nodes() + plate * plate_nodes() + (a - 1) + (x - 1) * (b - 1);
  }

  /// Plate and lattice point of a node that the walls do not have.
  std::array<int, 3> find_in_plate(int node) const {
    const int index = (node - wall_nodes()) % plate_nodes(), x = shape_.cells[0] - 1;
    return {(node - wall_nodes()) / plate_nodes(), 1 + index % x, 1 + index / x};
  }

  Vec3 place_at(int a, int b, int layer) const {
    const auto [x, y, z] = shape_.cells;
    const auto part = [](double size, int k, int cells) {  // both ends to the last bit
      return k == 0 ? -0.5 * size : k == cells ? 0.5 * size : 0.5 * size * (2.0 * k - cells) / cells;
    };
    return {part(shape_.size[0], a, x), part(shape_.size[1], b, y), shape_.length * (double(layer) / z)};
  }

  ShellBoxTubeShape shape_;
  int around_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_shell_source(const ShellBoxTubeShape& shape) {
  return std::make_unique<BoxTubeSource>(shape);
}

}  // namespace percuss
