#pragma once
// What a search for pairs of points and boxes is asked, and the list that it answers with.

#include "kernels/contact/surface/contact_state.hpp"
#include "kernels/contact/surface/edge_surface.hpp"
#include "kernels/contact/surface/lane_mask.hpp"
#include "kernels/core/prefetch.hpp"

namespace percuss {

/// Candidate pairs by node, faces ascending: the pair list sorted by (node, face).
struct CandidateList {
  int num_pairs = 0;
  int num_nodes = 0;                                               // nodes with candidates
  int num_faces = 0;                                               // faces whose geometry the detailed check reads
  Array<int> offset = Array<int>("contact::candidate_offset", 0);  // [contact nodes + 1]
  Array<int> face = Array<int>("contact::candidate_face", 0);      // [pairs]
  Array<int> nodes = Array<int>("contact::candidate_nodes", 0);    // [num_nodes] contact nodes, ascending
  Array<int> faces = Array<int>("contact::candidate_faces", 0);    // [num_faces] ascending
  Array<int> is_candidate =
      Array<int>("contact::candidate_faces", 0);  // [num_faces] 0: no candidate, its normal is read
  // [pairs] 1: checked if the node remembers some contact; none: all are checked
  Array<int> with_history = Array<int>("contact::with_history", 0);
};

/// Points and boxes by the names that hits give them.
struct PointQuery {
  Rows3<const double> x;
  Array<const int> points;       // [points] rows of x
  Array<const int> point_names;  // [points], no name twice
  Boxes boxes;
  Array<const int> box_names;  // [boxes]
  int num_names = 0;           // of points
};

/// Data of a box for a rule: stored beside the box, since access by its name would be scattered over memory.
struct BoxMark {
  int name = 0;
  int box_class = 0;                   // which of the named surfaces it lies on
  int corners[4] = {}, backs[4] = {};  // of a face, as ContactSurface has them
};

/// The lanes of `near` that may touch a box of that class. first_pair: [16] row of each lane in the table of pairs.
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_lanes_with_friction(const Array<const double>& pair_friction,
                                                                   int num_classes, const int* first_pair,
                                                                   int box_class, std::uint32_t near) {
  if (num_classes == 1) return pair_friction(0) < 0 ? 0 : near;
  for (std::uint32_t left = near; left != 0; left &= left - 1) {
    const int lane = find_lowest_bit(left);
    if (pair_friction(first_pair[lane] + box_class) < 0) near &= ~(std::uint32_t{1} << lane);
  }
  return near;
}

/// The rule by which nodes make pairs with faces.
struct NodeFaceRule {
  ContactSurface surface;

  /// Data of sixteen nodes that the rule needs.
  struct Lanes {
    LaneNumbers node, mesh_node;
    int first_pair[block_size];  // place in the table of pairs
  };

  KOKKOS_INLINE_FUNCTION bool operator()(int node, int face) const {
    return find_friction(surface, node, face) >= 0 && !shares_element(surface, node, face);
  }

  /// row: of the point in PointQuery::x, here its mesh node.
  KOKKOS_FORCEINLINE_FUNCTION void load(int lane, int node, int row, Lanes& lanes) const {
    lanes.node.lane[lane] = node;
    lanes.mesh_node.lane[lane] = row;
    lanes.first_pair[lane] = surface.num_classes > 1 ? surface.node_class(node) * surface.num_classes : 0;
  }

  /// Asks for what mark() will read.
  KOKKOS_FORCEINLINE_FUNCTION void fetch(int face) const {
    fetch_ahead(&surface.face_corners(face, 0));
    fetch_ahead(&surface.face_backs(face, 0));
  }

  KOKKOS_FORCEINLINE_FUNCTION BoxMark mark(int face) const {
    BoxMark box{face, surface.face_class(face), {}, {}};
    for (int i = 0; i < 4; ++i) {
      box.corners[i] = surface.face_corners(face, i);
      box.backs[i] = surface.face_backs(face, i);
    }
    return box;
  }

  /// The lanes of `near` for which the rule holds.
  KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_allowed(const Lanes& lanes, const BoxMark& box,
                                                         std::uint32_t near) const {
    near &= ~(find_equal_lanes(lanes.node, box.corners) | find_equal_lanes(lanes.mesh_node, box.backs));
    return find_lanes_with_friction(surface.pair_friction, surface.num_classes, lanes.first_pair, box.box_class, near);
  }
};

/// The rule by which points of edges make pairs with edges, as far as is seen at a glance; edges may still be joined.
struct EdgePairRule {
  static constexpr int line = smooth_line;  // lines and ridges never meet

  EdgeSurface surface;
  Array<const int> edge_of_point;

  /// Data of sixteen points that the rule needs.
  struct Lanes {
    LaneNumbers edge, kind, part;
    int first_pair[block_size];  // place in the table of pairs
  };

  KOKKOS_INLINE_FUNCTION bool operator()(int point, int b) const {
    const int a = edge_of_point(point);
    return a < b && may_meet(surface, a, b) && find_edge_friction(surface, a, b) >= 0;
  }

  /// EdgeSurface::is_blunt, of ridges that of lines.
  KOKKOS_FORCEINLINE_FUNCTION int find_kind(int edge) const {
    const int kind = find_bluntness(surface, edge);
    return kind < line ? kind : line;
  }

  /// Distinguished only where the scene has lines.
  KOKKOS_FORCEINLINE_FUNCTION int find_part(int edge) const {
    return surface.scale.extent(0) > 0 ? surface.scale(edge).part : 0;
  }

  KOKKOS_FORCEINLINE_FUNCTION void load(int lane, int point, int, Lanes& lanes) const {
    lanes.edge.lane[lane] = edge_of_point(point);
    lanes.kind.lane[lane] = find_kind(lanes.edge.lane[lane]);
    lanes.part.lane[lane] = find_part(lanes.edge.lane[lane]);
    lanes.first_pair[lane] = surface.edge_class(lanes.edge.lane[lane]) * surface.num_classes;
  }

  KOKKOS_FORCEINLINE_FUNCTION void fetch(int) const {}

  KOKKOS_FORCEINLINE_FUNCTION BoxMark mark(int edge) const {
    const int kind = find_kind(edge), part = find_part(edge);
    return {edge, surface.edge_class(edge), {kind, kind, kind, kind}, {part, part, part, part}};
  }

  /// The lanes that may_meet() leaves out for their kinds and parts: lines meet features of other parts only.
  KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_kept_apart(const Lanes& lanes, const BoxMark& box) const {
    const int lines[4] = {line, line, line, line}, blunt_or_line[4] = {line, blunt_edge, line, blunt_edge};
    const int kind = box.corners[0];
    if (kind == blunt_edge) return find_equal_lanes(lanes.kind, lines);
    const std::uint32_t of_part = find_equal_lanes(lanes.part, box.backs);
    return kind == line ? find_equal_lanes(lanes.kind, blunt_or_line) | of_part
                        : find_equal_lanes(lanes.kind, lines) & of_part;
  }

  /// The lanes of `near` for which the rule holds.
  KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_allowed(const Lanes& lanes, const BoxMark& box,
                                                         std::uint32_t near) const {
    near &= find_lanes_below(lanes.edge, box.name);
    if (surface.scale.extent(0) > 0) near &= ~find_kept_apart(lanes, box);
    return find_lanes_with_friction(surface.pair_friction, surface.num_classes, lanes.first_pair, box.box_class, near);
  }
};

}  // namespace percuss
