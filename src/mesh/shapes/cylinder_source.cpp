#include <cstddef>
#include <numbers>

#include "src/mesh/shapes/cell_grid.hpp"
#include "src/mesh/shapes/rounded_lattice.hpp"
#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

/// Sections one above the other. A section counts its core along x first, then ring after ring, each counter-clockwise
/// from the core's lowest corner. The edge 1-2 of a ring's quadrilaterals looks outside.
class CylinderSource final : public ShapeSource {
 public:
  // Sides as side_names() lists them.
  enum Side : int { start, end, side };

  explicit CylinderSource(const CylinderShape& shape)
      : shape_(shape),
        split_(split_round(shape.across)),
        lattice_(shape.radius, split_),
        around_(4 * split_.core),
        core_nodes_((split_.core + 1) * (split_.core + 1)),
        core_quads_(split_.core * split_.core) {}

  int node_count() const override { return section_nodes() * (shape_.along + 1); }
  int element_count() const override { return section_quads() * shape_.along; }

  Corners corners(int element) const override {
    const std::array<int, 4> q = find_quad(element % section_quads());
    const int low = element / section_quads() * section_nodes(), high = low + section_nodes();
    return {low + q[0], low + q[1], low + q[2], low + q[3], high + q[0], high + q[1], high + q[2], high + q[3]};
  }

  Vec3 place(int node) const override {
    const auto [ring, point] = find_section_node(node % section_nodes());
    const auto [x, y] = lattice_(point, ring);
    const int layer = node / section_nodes();
    return {x, y, shape_.length * (double(layer) / shape_.along)};
  }

  FaceSides face_sides(int element) const override {
    const int layer = element / section_quads(), quad = element % section_quads();
    const auto side_if = [](bool outside, Side of) { return outside ? int{of} : interior; };
    return {interior,
            side_if(quad >= section_quads() - around_, side),
            interior,
            interior,
            side_if(layer == 0, start),
            side_if(layer == shape_.along - 1, end)};
  }

  unsigned node_sides(int node) const override {
    const int layer = node / section_nodes(), in_section = node % section_nodes();
    unsigned sides = 0;
    if (layer == 0) sides |= 1U << start;
    if (layer == shape_.along) sides |= 1U << end;
    if (in_section >= section_nodes() - around_) sides |= 1U << side;
    return sides;
  }

  bool is_odd(int node) const override {
    const auto [ring, point] = find_section_node(node % section_nodes());
    return CellGrid::is_odd({point[0], point[1], ring + node / section_nodes()});
  }

  std::vector<CellBlock> blocks() const override {
    const int core = split_.core, rings = split_.rings, section = section_quads();
    const double along = shape_.length / shape_.along,
                 half_width = shape_.radius * choose_core_form<2>(split_).half_width;
    const double core_edge = 2 * half_width / core, ring_edge = (shape_.radius - half_width) / rings;
    const double middle = 0.5 * (shape_.radius + half_width);
    return {{0, {core, core, shape_.along}, {1, core, section}, {core_edge, core_edge, along}},
            {core_quads_,
             {around_, rings, shape_.along},
             {1, around_, section},
             {2 * std::numbers::pi * middle / around_, ring_edge, along}}};
  }

 private:
  struct SectionNode {
    int ring = 0;
    std::array<int, 2> point{};  // of the core lattice
  };

  int section_nodes() const { return core_nodes_ + split_.rings * around_; }
  int section_quads() const { return core_quads_ + split_.rings * around_; }
  int core_node(const std::array<int, 2>& point) const { return point[0] + (split_.core + 1) * point[1]; }

  /// Core lattice points along its boundary, counter-clockwise from the lowest corner.
  std::array<int, 2> find_boundary_point(int place) const {
    const int core = split_.core, on_edge = place % core;
    switch (place / core) {
      case 0:
        return {on_edge, 0};
      case 1:
        return {core, on_edge};
      case 2:
        return {core - on_edge, core};
      default:
        return {0, core - on_edge};
    }
  }

  SectionNode find_section_node(int node) const {
    if (node < core_nodes_) return {0, {node % (split_.core + 1), node / (split_.core + 1)}};
    const int beyond = node - core_nodes_;
    return {1 + beyond / around_, find_boundary_point(beyond % around_)};
  }

  int ring_node(int ring, int place) const {
    place %= around_;
    return ring == 0 ? core_node(find_boundary_point(place)) : core_nodes_ + (ring - 1) * around_ + place;
  }

  /// Section nodes of a quadrilateral, counter-clockwise seen from +z.
  std::array<int, 4> find_quad(int quad) const {
    if (quad < core_quads_) {
      const int i = quad % split_.core, j = quad / split_.core;
      return {core_node({i, j}), core_node({i + 1, j}), core_node({i + 1, j + 1}), core_node({i, j + 1})};
    }
    const int ring = (quad - core_quads_) / around_, p = (quad - core_quads_) % around_;
    return {ring_node(ring, p), ring_node(ring + 1, p), ring_node(ring + 1, p + 1), ring_node(ring, p + 1)};
  }

  CylinderShape shape_;
  RoundSplit split_;
  RoundedLattice<2> lattice_;
  int around_;  // nodes and quadrilaterals of a ring
  int core_nodes_, core_quads_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_cylinder_source(const CylinderShape& shape) {
  return std::make_unique<CylinderSource>(shape);
}

}  // namespace percuss
