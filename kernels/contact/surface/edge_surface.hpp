#pragma once
// The feature edges of the contact surface as search and check of edge pairs see them.
//
// A feature edge is where two faces meet at a convex angle, where a shell ends or where two shells meet at an angle.
// Two of them can cross while no node reaches any face. A beam is an edge without faces: its axis, with its radius as
// offset. An edge is named by its place in these lists, which is in the
// order of edge numbers, so that every choice by order is the same on any rank.

#include "kernels/contact/geometry/spring_rows.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// Two values an item, stored as a row: shape [n][2].
template <class T>
using Rows2 = Kokkos::View<T* [2], Kokkos::LayoutRight, MemSpace>;

/// The feature edges that pass between the nodes of lines.
struct EdgeScale {
  int part = 0;
  double length = 0;  // of a feature at the start; of a line, what features that pass between its nodes are longer
                      // than; of a ridge 0
};

struct EdgeSurface {
  int num_edges = 0;
  Array<const std::int64_t> numbers;   // [edges] ascending
  Rows2<const int> ends;               // [edges][2] rows of the motion, lower node number first
  Rows4<const int> wings;              // [edges][4] rows: corners of the first face, then of the second, that lie next
                                       // to end 0 and next to end 1; of a beam is_beam(), is_free_end() and
                                       // find_next_node()
  Rows2<const std::int64_t> elements;  // [edges][2] numbers of the elements behind the two faces
  Array<const int> edge_class;         // [edges] which of the named surfaces it lies on, as a class
  int num_classes = 1;
  Array<const double> pair_friction;  // [classes * classes] friction; negative: may not touch
  Array<const int> pair_number;       // likewise: which of the deck's pairs
  Array<const double> offset;         // [edges] half the thickness of its shells, radius of a beam; empty: all are 0
  Array<const int> is_blunt;          // [edges] 1: touches only what has crossed it; 2: likewise, and only features, as
                                      // a line of a smooth surface; 3: likewise, the ridge across a warped face (both
                                      // wings of a side are the corner there); empty: the scene has none
  Array<const EdgeScale> scale;       // [edges] empty: the scene has no lines of smooth surfaces
  SpringRows springs = SpringRows::none;  // which contacts give way
};

/// Pairs of edges, by (a, b), a before b.
struct EdgePairs {
  int list = 0;  // which list this is: another one at each search
  int num_pairs = 0;
  int num_edges = 0;                                        // edges in any pair
  Array<int> a = Array<int>("contact::edge_pair_a", 0);     // [pairs]
  Array<int> b = Array<int>("contact::edge_pair_b", 0);     // [pairs]
  Array<int> edges = Array<int>("contact::pair_edges", 0);  // [num_edges] ascending
};

/// Half the thickness of the shells of an edge, the radius of a beam, 0 of solids.
KOKKOS_INLINE_FUNCTION double find_edge_offset(const EdgeSurface& surface, int edge) {
  return surface.offset.extent(0) > 0 ? surface.offset(edge) : 0;
}

/// Whether an edge is a beam, which has no faces: its first wings are its ends.
KOKKOS_INLINE_FUNCTION bool is_beam(const EdgeSurface& surface, int edge) {
  return surface.wings(edge, 0) == surface.ends(edge, 0) && surface.wings(edge, 1) == surface.ends(edge, 1);
}

/// Whether springs push two edges, or the nodes and faces beside them.
KOKKOS_INLINE_FUNCTION bool gives_way(const EdgeSurface& surface, int a, int b) {
  if (surface.springs != SpringRows::of_sheets) return surface.springs == SpringRows::all;
  const bool a_is_thick = find_edge_offset(surface, a) > 0, b_is_thick = find_edge_offset(surface, b) > 0;
  return is_beam(surface, a) || is_beam(surface, b) ? a_is_thick && b_is_thick : a_is_thick || b_is_thick;
}

/// Whether a beam has an end that no other beam continues: its second wing there is the other end.
KOKKOS_INLINE_FUNCTION bool is_free_end(const EdgeSurface& surface, int edge, int end) {
  return is_beam(surface, edge) && surface.wings(edge, 2 + end) == surface.ends(edge, 1 - end);
}

/// The other end of the only beam that continues an edge at an end, -1 if there is none: its second wing there.
KOKKOS_INLINE_FUNCTION int find_next_node(const EdgeSurface& surface, int edge, int end) {
  const int wing = surface.wings(edge, 2 + end);
  const bool is_own = wing == surface.ends(edge, 0) || wing == surface.ends(edge, 1);
  return is_beam(surface, edge) && !is_own ? wing : -1;
}

/// Whether two edges touch only once they have crossed.
KOKKOS_INLINE_FUNCTION bool is_blunt_pair(const EdgeSurface& surface, int a, int b) {
  return surface.is_blunt.extent(0) > 0 && (surface.is_blunt(a) != 0 || surface.is_blunt(b) != 0);
}

inline constexpr int blunt_edge = 1, smooth_line = 2, warped_ridge = 3;  // EdgeSurface::is_blunt

/// EdgeSurface::is_blunt, 0 for a feature.
KOKKOS_INLINE_FUNCTION int find_bluntness(const EdgeSurface& surface, int edge) {
  return surface.is_blunt.extent(0) > 0 ? surface.is_blunt(edge) : 0;
}

/// Whether two edges may meet: lines of smooth surfaces and ridges of faces are kept apart by nodes and faces, and from
/// edges of their own part as well, lines from shorter ones too.
KOKKOS_INLINE_FUNCTION bool may_meet(const EdgeSurface& surface, int a, int b) {
  if (surface.is_blunt.extent(0) == 0) return true;
  const int kind = surface.is_blunt(a), other = surface.is_blunt(b);
  const bool is_line = kind >= smooth_line, is_other = other >= smooth_line;
  if ((is_line || is_other) && kind != 0 && other != 0) return false;
  if (surface.scale.extent(0) == 0 || (!is_line && !is_other)) return true;
  const EdgeScale line = surface.scale(is_line ? a : b), feature = surface.scale(is_line ? b : a);
  return feature.part != line.part && feature.length > line.length;
}

/// Coulomb friction between two edges, negative if they may not touch.
KOKKOS_INLINE_FUNCTION double find_edge_friction(const EdgeSurface& surface, int a, int b) {
  return surface.pair_friction(surface.edge_class(a) * surface.num_classes + surface.edge_class(b));
}

/// The pair of the deck that lets two edges touch.
KOKKOS_INLINE_FUNCTION int find_edge_pair_number(const EdgeSurface& surface, int a, int b) {
  return surface.pair_number(surface.edge_class(a) * surface.num_classes + surface.edge_class(b));
}

/// Node k of an edge and its two faces: the ends, then the wings.
KOKKOS_INLINE_FUNCTION int find_edge_node(const EdgeSurface& surface, int edge, int k) {
  return k < 2 ? surface.ends(edge, k) : surface.wings(edge, k - 2);
}

/// Nodes of an edge and its faces; a beam has its ends alone.
KOKKOS_INLINE_FUNCTION int count_edge_nodes(const EdgeSurface& surface, int edge) {
  return is_beam(surface, edge) ? 2 : 6;
}

/// Whether two edges belong to one element, or their faces have a node in common: they cannot meet before elements
/// between them fold.
KOKKOS_INLINE_FUNCTION bool are_joined(const EdgeSurface& surface, int a, int b) {
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      if (surface.elements(a, i) == surface.elements(b, j)) return true;
  const int of_a = count_edge_nodes(surface, a), of_b = count_edge_nodes(surface, b);
  for (int i = 0; i < of_a; ++i)
    for (int j = 0; j < of_b; ++j)
      if (find_edge_node(surface, a, i) == find_edge_node(surface, b, j)) return true;
  return false;
}

}  // namespace percuss
