#pragma once
// What a kind of element is in a mesh: its corners, faces and edges, and what files call it. Each kind has a table of
// its own in this folder; topologies.hpp lists them. What asks how many corners or faces an element has, asks here.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "kernels/core/element_family.hpp"

namespace percuss {

/// The most of any topology. A face is numbered most_faces * element + face.
inline constexpr std::size_t most_corners = 8, most_faces = 6, most_edges = 12;

/// Corners that kernels see of every element (chunk tables).
inline constexpr std::size_t kernel_corner_count = 8;

/// A face of a topology. Corners are places among those of the element, outward by the right-hand rule.
struct FaceCorners {
  std::array<int, 4> four{};  // as contact and loads take it: of a triangle one corner twice
  std::array<int, 4> once{};  // each corner once, `count` of them
  int count = 0;

  constexpr std::span<const int> corners() const { return {once.data(), static_cast<std::size_t>(count)}; }
};

/// A face with four corners; a triangle has two of them in a row equal.
constexpr FaceCorners make_face(int a, int b, int c, int d) {
  FaceCorners face{{a, b, c, d}, {}, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    if (face.four[i] != face.four[(i + 3) % 4]) face.once[static_cast<std::size_t>(face.count++)] = face.four[i];
  }
  return face;
}

struct Topology {
  std::string_view name;      // as the deck's documentation and reports call it
  std::string_view noun;      // in messages: "a hexahedron"
  std::string_view how_many;  // corners, in words
  ElementFamily family{};
  int dimension = 0;  // 3: a solid, 2: a surface with a thickness, 1: a line with a cross section
  int corner_count = 0, face_count = 0, edge_count = 0;
  std::array<FaceCorners, most_faces> face_table{};
  std::array<std::array<int, 2>, most_edges> edge_table{};  // of a surface around it, along its normal
  /// The three corners of a solid that an edge joins to each, right-handed.
  std::array<std::array<int, 3>, most_corners> corner_edges{};
  /// Corners as kernels see them: all, then some of them again if there are fewer.
  std::array<int, kernel_corner_count> kernel_corners{};
  /// Share of each corner in the mass of an element, in eighths; zeros: all have equal shares.
  std::array<double, most_corners> mass_eighths{};
  std::uint8_t vtk_type = 0;                                          // VTKCellType
  std::array<int, most_corners> vtk_corners{0, 1, 2, 3, 4, 5, 6, 7};  // in the order of VTK and XDMF
  int xdmf_type = 0;                                                  // in a mixed topology of XDMF
  std::string_view xdmf_name;                                         // of a topology with this kind alone
  std::array<std::string_view, 4> exodus_names{};   // beginnings of the names of its blocks; unused: empty
  std::array<int, most_faces> exodus_sides{};       // face of the Exodus side with this number, less one
  std::array<std::string_view, 2> abaqus_names{};   // element types with its corners; unused: empty
  std::array<std::string_view, 4> nastran_names{};  // entries of elements that begin with its corners; unused: empty

  constexpr std::span<const FaceCorners> faces() const {
    return {face_table.data(), static_cast<std::size_t>(face_count)};
  }
  constexpr std::span<const std::array<int, 2>> edges() const {
    return {edge_table.data(), static_cast<std::size_t>(edge_count)};
  }
  constexpr bool is_surface() const { return dimension == 2; }
  constexpr bool is_line() const { return dimension == 1; }
  constexpr bool is_solid() const { return dimension == 3; }

  /// Share of one of the corners that kernels see in the mass of an element, in eighths: the share of the corner,
  /// divided over its places.
  constexpr double find_mass_share(std::size_t place) const {
    int count = 0;
    for (const int corner : kernel_corners) count += corner == kernel_corners[place] ? 1 : 0;
    const double own = mass_eighths[static_cast<std::size_t>(kernel_corners[place])];
    return (own > 0 ? own : 8.0 / corner_count) / count;
  }

  /// The corner behind one of a face: across the element along an edge. Of a surface the corner itself.
  constexpr int find_corner_behind(const FaceCorners& face, int corner) const {
    for (const auto& [a, b] : edges()) {
      if (a != corner && b != corner) continue;
      const int other = a == corner ? b : a;
      bool is_on_face = false;
      for (const int c : face.corners()) is_on_face = is_on_face || c == other;
      if (!is_on_face) return other;
    }
    return corner;
  }
};

}  // namespace percuss
