#include <algorithm>
#include <cstddef>
#include <utility>

#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

/// Each cell of a solid shape cut into twelve: a node in its middle, and each of its faces halved along the diagonal
/// from its lowest node, which both cells of a face agree on. Nodes of the shape come first, then one a cell.
class TetSource final : public ShapeSource {
 public:
  explicit TetSource(std::unique_ptr<ShapeSource> cells)
      : cells_(std::move(cells)), corner_nodes_(cells_->node_count()) {}

  int node_count() const override { return corner_nodes_ + cells_->element_count(); }
  int element_count() const override { return tetrahedra_of_cell * cells_->element_count(); }
  TopologyKind topology() const override { return TopologyKind::tet4; }

  Corners corners(int element) const override {
    const int cell = element / tetrahedra_of_cell, half = element % 2;
    const Corners hexahedron = cells_->corners(cell);
    const auto& face = find_topology(TopologyKind::hex8).face_table[static_cast<std::size_t>(find_face(element))].four;
    const auto node = [&](std::size_t i) { return hexahedron[static_cast<std::size_t>(face[i % 4])]; };
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < 4; ++i) lowest = node(i) < node(lowest) ? i : lowest;
    const std::size_t middle = lowest + (half == 0 ? 1 : 2);
    return {node(lowest), node(middle + 1), node(middle), corner_nodes_ + cell};
  }

  Vec3 place(int node) const override {
    if (node < corner_nodes_) return cells_->place(node);
    Vec3 low{}, high{};
    const Corners corners = cells_->corners(node - corner_nodes_);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 a = cells_->place(corners[i]), b = cells_->place(corners[i + 4]);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] += a[k];
        high[k] += b[k];
      }
    }
    return {(low[0] + high[0]) / 8, (low[1] + high[1]) / 8, (low[2] + high[2]) / 8};
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides;
    sides.fill(interior);
    sides[base] = cells_->face_sides(element / tetrahedra_of_cell)[static_cast<std::size_t>(find_face(element))];
    return sides;
  }

  unsigned node_sides(int node) const override { return node < corner_nodes_ ? cells_->node_sides(node) : 0; }

  std::vector<CellBlock> blocks() const override {
    std::vector<CellBlock> blocks = cells_->blocks();
    for (CellBlock& block : blocks) block.elements_of_cell = tetrahedra_of_cell;
    return blocks;
  }

 private:
  static constexpr int tetrahedra_of_cell = 12;
  static constexpr std::size_t base = 3;  // the face of a tetrahedron that lies on one of its cell

  static int find_face(int element) { return element % tetrahedra_of_cell / 2; }

  std::unique_ptr<ShapeSource> cells_;
  int corner_nodes_;
};

}  // namespace

std::unique_ptr<ShapeSource> cut_into_tetrahedra(std::unique_ptr<ShapeSource> cells) {
  return std::make_unique<TetSource>(std::move(cells));
}

}  // namespace percuss
