#include <cstddef>

#include "src/mesh/shapes/cell_grid.hpp"
#include "src/mesh/shapes/cube_boundary.hpp"
#include "src/mesh/shapes/rounded_lattice.hpp"
#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

constexpr unsigned surface = 0;  // its only side

/// The core's cells, then shell after shell. A shell counts the core's boundary faces: along one direction, along the
/// other, the six faces of the cube in turn. Its elements look outside with their face 5.
class SphereSource final : public ShapeSource {
 public:
  explicit SphereSource(const SphereShape& shape)
      : shape_(shape),
        split_(split_round(shape.across)),
        lattice_(shape.radius, split_),
        grid_{{split_.core, split_.core, split_.core}},
        boundary_(split_.core),
        shell_elements_(6 * split_.core * split_.core) {}

  int node_count() const override { return grid_.node_count() + split_.rings * boundary_.count(); }
  int element_count() const override { return grid_.cell_count() + split_.rings * shell_elements_; }

  Corners corners(int element) const override {
    if (element < grid_.cell_count()) return grid_.corners(grid_.find_cell(element));
    const int beyond = element - grid_.cell_count(), shell = beyond / shell_elements_;
    const std::array<CellGrid::Index, 4> face = boundary_.find_face(beyond % shell_elements_);
    std::array<int, 8> nodes{};
    for (std::size_t c = 0; c < 4; ++c) {
      nodes[c] = node(face[c], shell);
      nodes[c + 4] = node(face[c], shell + 1);
    }
    return nodes;
  }

  Vec3 place(int node) const override {
    if (node < grid_.node_count()) return lattice_(grid_.find_node(node), 0);
    const int beyond = node - grid_.node_count();
    return lattice_(boundary_.find_point(beyond % boundary_.count()), 1 + beyond / boundary_.count());
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides{};
    sides.fill(interior);
    if (element >= element_count() - shell_elements_) sides[5] = static_cast<int>(surface);
    return sides;
  }

  unsigned node_sides(int node) const override { return node >= node_count() - boundary_.count() ? 1U << surface : 0U; }

  bool is_odd(int node) const override {
    if (node < grid_.node_count()) return CellGrid::is_odd(grid_.find_node(node));
    const int beyond = node - grid_.node_count();
    const CellGrid::Index point = boundary_.find_point(beyond % boundary_.count());
    return CellGrid::is_odd({point[0], point[1], point[2] + 1 + beyond / boundary_.count()});
  }

  std::vector<CellBlock> blocks() const override {
    const int core = split_.core, rings = split_.rings;
    const double half_width = shape_.radius * choose_core_form<3>(split_).half_width;
    const double core_edge = 2 * half_width / core, shell_edge = (shape_.radius - half_width) / rings;
    std::vector<CellBlock> blocks{{0, grid_.cells, {1, core, core * core}, {core_edge, core_edge, core_edge}}};
    const double middle_edge = core_edge * (0.5 * (shape_.radius + half_width)) / half_width;
    for (int face = 0; face < 6; ++face) {
      blocks.push_back({grid_.cell_count() + face,
                        {core, core, rings},
                        {6, 6 * core, shell_elements_},
                        {middle_edge, middle_edge, shell_edge}});
    }
    return blocks;
  }

 private:
  int node(const CellGrid::Index& point, int shell) const {
    if (shell == 0) return grid_.node(point[0], point[1], point[2]);
    return grid_.node_count() + (shell - 1) * boundary_.count() + boundary_.find_place(point);
  }

  SphereShape shape_;
  RoundSplit split_;
  RoundedLattice<3> lattice_;
  CellGrid grid_;
  CubeBoundary boundary_;
  int shell_elements_;
};

}  // namespace

std::unique_ptr<ShapeSource> make_sphere_source(const SphereShape& shape) {
  return std::make_unique<SphereSource>(shape);
}

}  // namespace percuss
