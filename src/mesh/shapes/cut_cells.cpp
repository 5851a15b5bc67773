#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "src/mesh/shapes/shape_source.hpp"

namespace percuss {
namespace {

/// Each cell of a solid shape cut into so many elements. Nodes of the shape come first, then those in the middle of
/// cells, if there are any.
class CutSource : public ShapeSource {
 public:
  CutSource(std::unique_ptr<ShapeSource> cells, int elements_of_cell)
      : cells_(std::move(cells)), corner_nodes_(cells_->node_count()), elements_of_cell_(elements_of_cell) {}

  int node_count() const override { return corner_nodes_; }
  int element_count() const override { return elements_of_cell_ * cells_->element_count(); }
  Vec3 place(int node) const override { return cells_->place(node); }
  unsigned node_sides(int node) const override { return cells_->node_sides(node); }

  std::vector<CellBlock> blocks() const override {
    std::vector<CellBlock> blocks = cells_->blocks();
    for (CellBlock& block : blocks) block.elements_of_cell = elements_of_cell_;
    return blocks;
  }

 protected:
  int find_cell(int element) const { return element / elements_of_cell_; }
  int find_place(int element) const { return element % elements_of_cell_; }
  Corners cell_corners(int element) const { return cells_->corners(find_cell(element)); }

  /// Side of a face of the cell of an element.
  int cell_side(int element, int face) const {
    return cells_->face_sides(find_cell(element))[static_cast<std::size_t>(face)];
  }

  static FaceSides all_interior() {
    FaceSides sides;
    sides.fill(interior);
    return sides;
  }

  std::unique_ptr<ShapeSource> cells_;
  int corner_nodes_;

 private:
  int elements_of_cell_;
};

/// Cells that are cut with a node in the middle of each.
class CenteredSource : public CutSource {
 public:
  using CutSource::CutSource;
  int node_count() const override { return corner_nodes_ + cells_->element_count(); }

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

  unsigned node_sides(int node) const override { return node < corner_nodes_ ? cells_->node_sides(node) : 0; }

 protected:
  int middle(int element) const { return corner_nodes_ + find_cell(element); }
  static const std::array<int, 4>& hex_face(int face) {
    return hex8_topology.face_table[static_cast<std::size_t>(face)].four;
  }
};

/// Twelve tetrahedra a cell: each of its faces is halved along the diagonal from its lowest node, which both cells of a
/// face agree on.
class TetSource final : public CenteredSource {
 public:
  explicit TetSource(std::unique_ptr<ShapeSource> cells) : CenteredSource(std::move(cells), 12) {}
  TopologyKind topology() const override { return TopologyKind::tet4; }

  Corners corners(int element) const override {
    const Corners hexahedron = cell_corners(element);
    const auto& face = hex_face(find_face(element));
    const auto node = [&](std::size_t i) { return hexahedron[static_cast<std::size_t>(face[i % 4])]; };
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < 4; ++i) lowest = node(i) < node(lowest) ? i : lowest;
    const std::size_t next = lowest + (element % 2 == 0 ? 1 : 2);
    return {node(lowest), node(next + 1), node(next), middle(element)};
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides = all_interior();
    sides[base] = cell_side(element, find_face(element));
    return sides;
  }

 private:
  static constexpr std::size_t base = 3;  // the face of a tetrahedron that lies on one of its cell

  int find_face(int element) const { return find_place(element) / 2; }
};

/// Tetrahedra between the nodes of a cell alone.
class BareTetSource : public CutSource {
 public:
  using CutSource::CutSource;
  TopologyKind topology() const override { return TopologyKind::tet4; }

  Corners corners(int element) const override {
    const Corners hexahedron = cell_corners(element);
    const Tetrahedron places = find_places(hexahedron, find_place(element));
    const auto node = [&](std::size_t i) { return hexahedron[static_cast<std::size_t>(places[i])]; };
    return {node(0), node(1), node(2), node(3)};
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides = all_interior();
    const Tetrahedron places = find_places(cell_corners(element), find_place(element));
    const auto faces = tet4_topology.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto corners = faces[f].corners();
      for (int face = 0; face < hex8_topology.face_count; ++face) {
        const auto is_there = [&](int corner) { return is_on(face, places[static_cast<std::size_t>(corner)]); };
        if (std::all_of(corners.begin(), corners.end(), is_there)) sides[f] = cell_side(element, face);
      }
    }
    return sides;
  }

 protected:
  using Tetrahedron = std::array<int, 4>;  // places of its nodes among those of the cell

  static const std::array<int, 4>& face_places(int face) {
    return hex8_topology.face_table[static_cast<std::size_t>(face)].four;
  }
  static bool is_on(int face, int place) {
    const auto& places = face_places(face);
    return std::find(places.begin(), places.end(), place) != places.end();
  }

 private:
  virtual Tetrahedron find_places(const Corners& hexahedron, int tetrahedron) const = 0;
};

/// Six a cell: its lowest node is joined to the three faces that it is not on, each halved as both cells of a face
/// agree on. Its own three faces are then halved from it, which is the same rule.
class SixTetSource final : public BareTetSource {
 public:
  explicit SixTetSource(std::unique_ptr<ShapeSource> cells) : BareTetSource(std::move(cells), 6) {}

 private:
  /// Takes two halves of each of the three faces without the lowest node, in the order of the faces.
  Tetrahedron find_places(const Corners& hexahedron, int tetrahedron) const override {
    const auto node = [&](int place) { return hexahedron[static_cast<std::size_t>(place)]; };
    int apex = 0;
    for (int place = 1; place < 8; ++place) apex = node(place) < node(apex) ? place : apex;
    int face = 0;
    for (int left = tetrahedron / 2; is_on(face, apex) || left-- > 0;) ++face;
    const auto& places = face_places(face);
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < 4; ++i) lowest = node(places[i]) < node(places[lowest]) ? i : lowest;
    const std::size_t next = lowest + (tetrahedron % 2 == 0 ? 1 : 2);
    return {places[lowest], places[(next + 1) % 4], places[next % 4], apex};
  }
};

/// Five a cell: one between its even nodes, and one at each of its odd ones. Every face is halved by the diagonal of
/// its even nodes, so that neighbours are cut as in a mirror.
class FiveTetSource final : public BareTetSource {
 public:
  explicit FiveTetSource(std::unique_ptr<ShapeSource> cells) : BareTetSource(std::move(cells), 5) {}

 private:
  Tetrahedron find_places(const Corners& hexahedron, int tetrahedron) const override {
    // A cell whose first node is even has these; in another all places are one farther around their face.
    static constexpr Tetrahedron of_even[5] = {{0, 2, 7, 5}, {1, 2, 0, 5}, {3, 0, 2, 7}, {4, 7, 5, 0}, {6, 5, 7, 2}};
    Tetrahedron places = of_even[tetrahedron];
    if (!cells_->is_odd(hexahedron[0])) return places;
    for (int& place : places) place = (place & 4) | ((place + 1) & 3);
    return places;
  }
};

/// Six pyramids a cell, one on each of its faces.
class PyramidSource final : public CenteredSource {
 public:
  explicit PyramidSource(std::unique_ptr<ShapeSource> cells) : CenteredSource(std::move(cells), 6) {}
  TopologyKind topology() const override { return TopologyKind::pyramid5; }

  Corners corners(int element) const override {
    const Corners hexahedron = cell_corners(element);
    const auto& face = hex_face(find_place(element));
    const auto node = [&](std::size_t i) { return hexahedron[static_cast<std::size_t>(face[i])]; };
    return {node(0), node(3), node(2), node(1), middle(element)};
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides = all_interior();
    sides[base] = cell_side(element, find_place(element));
    return sides;
  }

 private:
  static constexpr std::size_t base = 4;
};

/// Two wedges a cell, along its third direction. The diagonals of neighbours cross over: all along one direction, they
/// would make the part stiffer on one side than on the other. Cells that follow each other in the third direction are
/// cut alike, as their corners are in the same order.
class WedgeSource final : public CutSource {
 public:
  explicit WedgeSource(std::unique_ptr<ShapeSource> cells) : CutSource(std::move(cells), 2), grids_(cells_->blocks()) {}
  TopologyKind topology() const override { return TopologyKind::wedge6; }

  Corners corners(int element) const override {
    const Corners c = cell_corners(element);
    const Triangle t = find_triangle(element);
    return {c[t[0]], c[t[1]], c[t[2]], c[t[0] + 4], c[t[1] + 4], c[t[2] + 4]};
  }

  FaceSides face_sides(int element) const override {
    FaceSides sides = all_interior();
    const Triangle t = find_triangle(element);
    // Faces of a wedge: on the edges of the triangle, of which one is the cut; then both triangles. Edge i of a cell is
    // that from corner i to the next.
    for (std::size_t e = 0; e < 3; ++e)
      if (t[(e + 1) % 3] == (t[e] + 1) % 4) sides[e] = cell_side(element, static_cast<int>(t[e]));
    sides[3] = cell_side(element, 4);
    sides[4] = cell_side(element, 5);
    return sides;
  }

 private:
  using Triangle = std::array<std::size_t, 3>;  // corners of the cell's first face across the third direction

  Triangle find_triangle(int element) const {
    const bool is_first = find_place(element) == 0;
    if (is_crossed(find_cell(element))) return is_first ? Triangle{0, 1, 3} : Triangle{1, 2, 3};
    return is_first ? Triangle{0, 1, 2} : Triangle{0, 2, 3};
  }

  /// Every other cell of a layer, of each of its grids.
  bool is_crossed(int cell) const {
    const int in_layer = cell % grids_.front().strides[2];
    const auto next =
        std::find_if(grids_.begin(), grids_.end(), [&](const CellBlock& grid) { return grid.first > in_layer; });
    const CellBlock& grid = *std::prev(next);
    const int place = in_layer - grid.first;
    return (place % grid.strides[1] + place / grid.strides[1]) % 2 != 0;
  }

  std::vector<CellBlock> grids_;
};

}  // namespace

std::unique_ptr<ShapeSource> cut_cells(std::unique_ptr<ShapeSource> cells, PartDeck::Elements elements) {
  switch (elements) {
    case PartDeck::Elements::tetrahedra:
      return std::make_unique<TetSource>(std::move(cells));
    case PartDeck::Elements::six_tetrahedra:
      return std::make_unique<SixTetSource>(std::move(cells));
    case PartDeck::Elements::five_tetrahedra:
      return std::make_unique<FiveTetSource>(std::move(cells));
    case PartDeck::Elements::pyramids:
      return std::make_unique<PyramidSource>(std::move(cells));
    case PartDeck::Elements::wedges:
      return std::make_unique<WedgeSource>(std::move(cells));
    case PartDeck::Elements::hexahedra:
      break;
  }
  return cells;
}

}  // namespace percuss
