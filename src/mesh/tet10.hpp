#pragma once
// The tetrahedron of ten nodes, as files have it: four corners, then the middles of its edges. It is cut into eight of
// four nodes when it is read; no mesh has it.
//
// Its nodes are those of tet4_topology's corners, then of its edges: 0-1, 1-2, 2-0, 0-3, 1-3, 2-3.

#include "src/mesh/topology/tet4.hpp"

namespace percuss {

inline constexpr std::size_t tet10_nodes = 10, tet10_pieces = 8;

/// Sides of one in a file: its four faces, then the four triangles of each.
inline constexpr int tet10_sides = 20;

using Tet4Corners = std::array<int, 4>;

/// The middle of an edge between two corners.
constexpr int find_middle(int a, int b) {
  for (int e = 0; e < tet4_topology.edge_count; ++e) {
    const auto& [first, second] = tet4_topology.edge_table[static_cast<std::size_t>(e)];
    if ((first == a && second == b) || (first == b && second == a)) return tet4_topology.corner_count + e;
  }
  return -1;
}

/// Between the middles of opposite edges: one of them is an edge of the four tetrahedra inside.
inline constexpr std::array<std::array<int, 2>, 3> tet10_diagonals{{{4, 9}, {5, 7}, {6, 8}}};

/// The middles around each diagonal, so that (both of the diagonal, two in a row) is a tetrahedron of positive volume.
inline constexpr std::array<std::array<int, 4>, 3> tet10_rings{{{5, 6, 7, 8}, {6, 4, 8, 9}, {4, 5, 9, 7}}};

/// One at each corner, then four around a diagonal.
constexpr std::array<Tet4Corners, tet10_pieces> cut_tet10(std::size_t diagonal) {
  std::array<Tet4Corners, tet10_pieces> pieces{{{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}}};
  const auto& [from, to] = tet10_diagonals[diagonal];
  const std::array<int, 4>& ring = tet10_rings[diagonal];
  for (std::size_t i = 0; i < 4; ++i) pieces[4 + i] = {from, to, ring[i], ring[(i + 1) % 4]};
  return pieces;
}

/// The triangles of a face: one at each of its corners, then that in the middle; outward.
constexpr std::array<std::array<int, 3>, 4> cut_tet10_face(int face) {
  const std::array<int, 4>& corner = tet4_topology.face_table[static_cast<std::size_t>(face)].once;
  const int ab = find_middle(corner[0], corner[1]), bc = find_middle(corner[1], corner[2]),
            ca = find_middle(corner[2], corner[0]);
  return {{{corner[0], ab, ca}, {ab, corner[1], bc}, {ca, bc, corner[2]}, {ab, bc, ca}}};
}

}  // namespace percuss
