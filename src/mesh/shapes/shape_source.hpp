#pragma once
// A generated shape in closed form: every node, element and side is a function of its index, and nothing is stored. A
// rank can therefore make the elements of one chunk without those of any other.

#include <array>
#include <memory>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Cells of a shape that lie on a grid of their own: cell (i, j, k) has the number first + i strides[0] + j strides[1]
/// + k strides[2], and its elements follow each other: those of cell c begin with elements_of_cell c.
struct CellBlock {
  int first = 0;
  std::array<int, 3> cells{};
  std::array<int, 3> strides{};
  Vec3 edges{};  // mean length of a cell's edge in each direction [length]
  int elements_of_cell = 1;
};

/// Nodes and elements of a shape, in the local coordinates that deck.hpp gives for it. Indexes count from 0 within one
/// copy of it.
class ShapeSource {
 public:
  static constexpr int interior = -1;
  using FaceSides = std::array<int, most_faces>;

  virtual ~ShapeSource() = default;
  virtual int node_count() const = 0;
  virtual int element_count() const = 0;

  /// Topology of all elements.
  virtual TopologyKind topology() const { return TopologyKind::hex8; }

  /// Nodes of an element, in the order of its topology.
  virtual Corners corners(int element) const = 0;

  /// Position of a node [length].
  virtual Vec3 place(int node) const = 0;

  /// Side of each face of an element as an index into side_names() of the shape; `interior` for those between two
  /// elements. Every exterior face belongs to one side.
  virtual FaceSides face_sides(int element) const = 0;

  /// Bit s: the node lies on side s.
  virtual unsigned node_sides(int node) const = 0;

  /// Colours the nodes of a solid shape: nodes of a cell's edge are one odd, one even, wherever every closed path of
  /// edges has an even number of them.
  virtual bool is_odd(int /*node*/) const { return false; }

  /// Grids that hold every cell once.
  virtual std::vector<CellBlock> blocks() const = 0;
};

/// Sides of the faces of a shell: two surfaces, and edges that no other surface can meet.
inline ShapeSource::FaceSides name_shell_sides(int bottom, int top) {
  ShapeSource::FaceSides sides;
  sides.fill(ShapeSource::interior);
  sides[bottom_face] = bottom;
  sides[top_face] = top;
  return sides;
}

/// A solid of other elements in the same shape, whose faces match. A cell becomes twelve tetrahedra or six pyramids, of
/// which the mean of its corners is a node, too, six or five tetrahedra between its own nodes, or two wedges along its
/// third direction.
std::unique_ptr<ShapeSource> cut_cells(std::unique_ptr<ShapeSource> cells, PartDeck::Elements elements);

/// The source of a generated shape; null for a mesh from a file.
std::unique_ptr<ShapeSource> make_source(const Shape& shape);

/// Rectangular block of cells[0] x cells[1] x cells[2] equal elements. Nodes and elements count along x first.
std::unique_ptr<ShapeSource> make_box_source(const BoxShape& shape);

/// Solid cylinder: every section is a core of square topology and rings around it. The nodes of the side lie at the
/// radius; each section is symmetric to the last bit under quarter turns and under reflection in x, y and x = y.
std::unique_ptr<ShapeSource> make_cylinder_source(const CylinderShape& shape);

/// Hollow cylinder or a sector of one; the first of its node lines lies at +x. Symmetric to the last bit under
/// reflection in x (and, as far as `around` divides, in y and under quarter turns).
std::unique_ptr<ShapeSource> make_tube_source(const TubeShape& shape);

/// Solid ball: a core of cube topology and shells around it. The nodes of the surface lie at the radius; symmetric to
/// the last bit under the 48 symmetries of the cube.
std::unique_ptr<ShapeSource> make_sphere_source(const SphereShape& shape);

/// Surfaces of shells, their elements of four corners. Nodes lie on the surface; elements count
/// along the first direction of `cells` first, those of plates that close a profile after its walls.
std::unique_ptr<ShapeSource> make_shell_source(const ShellPlateShape& shape);
std::unique_ptr<ShapeSource> make_shell_source(const ShellTubeShape& shape);
std::unique_ptr<ShapeSource> make_shell_source(const ShellSphereShape& shape);
std::unique_ptr<ShapeSource> make_shell_source(const ShellBoxTubeShape& shape);

/// A line of beams from one end to the other.
std::unique_ptr<ShapeSource> make_line_source(const LineShape& shape);

}  // namespace percuss
