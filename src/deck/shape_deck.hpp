#pragma once
// Shapes that percuss generates, all in local coordinates: then array, rotate and `at` of a part are applied in this
// order. And meshes from files.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/deck/functions/selector.hpp"

namespace percuss {

/// Local origin: the lowest corner. Sides: x_min, x_max, y_min, y_max, z_min, z_max.
struct BoxShape {
  Vec3 size{};
  std::array<int, 3> cells{1, 1, 1};
};

/// A solid cylinder without degenerate hexahedra: a square core and rings around it. Local origin: the middle of the
/// start face, axis +z. `across` cells on a diameter: rings = max(1, across / 4), core = across - 2 rings (across >=
/// 3). Sides: start, end, side.
struct CylinderShape {
  double radius = 0;
  double length = 0;
  int across = 0;
  int along = 0;
};

/// A hollow cylinder, or a sector of one. Local origin: on the axis in the start face, axis +z. Sides: start, end,
/// inner, outer; of a sector also first (at +x) and last.
struct TubeShape {
  double inner_radius = 0;
  double outer_radius = 0;
  double length = 0;
  std::array<int, 3> cells{1, 8, 1};  // through the wall, around, along
  double arc = 360;                   // degrees of the turn, from +x counter-clockwise; 360: closed
};

/// A solid ball: a cube of core cells and rings on its six faces, split as CylinderShape. Local origin: its middle.
/// Sides: surface.
struct SphereShape {
  double radius = 0;
  int across = 0;
};

// Surfaces of four-node shells. Each also has its two faces as sides; the second one is where normals point to.

/// A flat rectangle in the plane of x and y, normals along +z. Local origin: the lowest corner. Sides: the edges x_min,
/// x_max, y_min, y_max; bottom, top.
struct ShellPlateShape {
  std::array<double, 2> size{};
  std::array<int, 2> cells{1, 1};
};

/// The surface of a cylinder, or of a cone, or a sector of one. Local origin: on the axis in the start, axis +z. Sides:
/// the edges start, end; inner, outer; of a sector also the edges first (at +x) and last.
struct ShellTubeShape {
  double radius = 0;
  std::optional<double> end_radius;  // a cone; default: radius
  double length = 0;
  std::array<int, 2> cells{8, 1};  // around, along
  double arc = 360;                // as TubeShape::arc
};

/// The surface of a ball: the six faces of a cube, without a pole. Local origin: its middle. Sides: inner, outer.
struct ShellSphereShape {
  double radius = 0;
  int cells = 1;  // along an edge of the cube
};

/// The four walls of a rectangular profile, its corners sharp, and plates that close its ends, joined to the walls:
/// one makes a tray, two a box. Local origin: the middle of the start, axis +z, walls along x and y. Sides: the edges
/// start, end (where closed all nodes there); inner, outer.
struct ShellBoxTubeShape {
  enum class Closed { none, start, end, both };
  std::array<double, 2> size{};  // of the section, along x and y
  double length = 0;
  std::array<int, 3> cells{1, 1, 1};  // along x, y and z
  Closed closed = Closed::none;

  bool has_start() const { return closed == Closed::start || closed == Closed::both; }
  bool has_end() const { return closed == Closed::end || closed == Closed::both; }
};

/// A straight line of beams. Sides: start, end, its two outer nodes.
struct LineShape {
  Vec3 from{}, to{};
  int cells = 1;
};

/// A file with a mesh. All its element blocks and sets, by name (or "block_7", "nodes_7", "sides_7", "elements_7").
struct FileMesh {
  std::string file;                 // as found: relative paths are relative to the deck
  std::vector<std::string> blocks;  // empty: all
  double scale = 1;
  bool is_exodus = true;  // key `exodus`: of this format, with nodes of its own; else of any, nodes shared (`mesh`)
};

using Shape = std::variant<BoxShape, CylinderShape, TubeShape, SphereShape, ShellPlateShape, ShellTubeShape,
                           ShellSphereShape, ShellBoxTubeShape, LineShape, FileMesh>;

/// Whether a generated shape is a surface of shells.
bool is_shell_shape(const Shape& shape);

/// The sides that percuss names on a generated shape; empty for a mesh from a file.
std::vector<std::string> side_names(const Shape& shape);

}  // namespace percuss
