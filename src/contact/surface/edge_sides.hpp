#pragma once
// The sides of the edges of the contact surface: each face ends at its edges, and what lies on either side of an edge
// tells its angle.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "comm/exchange/item_exchange.hpp"
#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/edge_geometry.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/core/counting_sort.hpp"
#include "src/contact/surface/face_corners.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/index.hpp"

namespace percuss {

/// One side of an edge: a face that ends there.
struct EdgeSide {
  std::int64_t ends[2]{}, wings[2]{};  // node numbers; the wing of each end
  std::int64_t face = 0;               // number
  int surface_class = 0;
  int part = 0;
  int rank = 0;
  int item = -1;      // of SharedSides
  double length = 0;  // of the edge
  double offset = 0;
  Point3 normal{}, inward{};  // of the face, and from the edge into it

  std::int64_t element() const { return find_element_of_face(face); }
  bool is_shell() const { return offset > 0; }
};

/// Whether warping makes a ridge of a diagonal of the face.
inline bool has_diagonals(const FaceTopology& face) { return !(face.offset > 0) && count_corners(face.corners) == 4; }

/// Whether faces with these normals may meet at an edge that is sharper than `cosine`.
inline bool are_at_angle(const Point3& normal, const Point3& other, double cosine) {
  return dot(normal, other) < cosine;
}

inline bool is_same_edge(const EdgeSide& a, const EdgeSide& b) {
  return a.ends[0] == b.ends[0] && a.ends[1] == b.ends[1];
}

inline bool side_comes_before(const EdgeSide& a, const EdgeSide& b) {
  if (a.ends[0] != b.ends[0]) return a.ends[0] < b.ends[0];
  return a.ends[1] != b.ends[1] ? a.ends[1] < b.ends[1] : a.face < b.face;
}

/// A face with what its sides need to know of it.
struct SidedFace {
  const FaceTopology* face = nullptr;
  FacePoints places;  // corners relative to the first
  Point3 normal;

  SidedFace(const Mesh& mesh, const FaceTopology& topology, const std::array<int, 4>& corners) : face(&topology) {
    const Vec3& origin = mesh.nodes[at(corners[0])];
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& x = mesh.nodes[at(corners[i])];
      places.corner[i] = {x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
    }
    normal = find_face_normal(places);
  }

  /// The corner of the lower number of the edge from corner k to the next.
  std::size_t find_lower_corner(std::size_t k) const {
    return face->corners[(k + 1) % 4] < face->corners[k] ? (k + 1) % 4 : k;
  }

  /// The side of that edge.
  EdgeSide make_side(std::size_t k, int rank) const {
    const FaceTopology& of = *face;
    std::size_t p = k, q = (k + 1) % 4;
    std::size_t wing_p = find_previous_corner(of.corners, p), wing_q = find_next_corner(of.corners, q);
    if (of.corners[q] < of.corners[p]) {
      std::swap(p, q);
      std::swap(wing_p, wing_q);
    }
    EdgeSide side;
    side.ends[0] = of.corners[p];
    side.ends[1] = of.corners[q];
    side.wings[0] = of.corners[wing_p];
    side.wings[1] = of.corners[wing_q];
    side.face = of.number;
    side.surface_class = of.surface_class;
    side.part = of.part;
    side.rank = rank;
    side.length = norm(places.corner[q] - places.corner[p]);
    side.offset = of.offset;
    side.normal = normal;
    side.inward = find_inward(places.corner[p], places.corner[q], places.corner[wing_p], places.corner[wing_q]);
    return side;
  }
};

/// Sides of the edges whose lower node is this rank's: those of its own faces, made on demand, and those received from
/// other ranks.
class SharedSides {
 public:
  /// Collective.
  SharedSides(const ChunkedMesh& chunked, const std::vector<FaceTopology>& faces,
              const std::vector<std::array<int, 4>>& face_corners, const Communicator& ranks)
      : rank_(ranks.rank()) {
    const Mesh& mesh = chunked.mesh;
    std::vector<int> lower_nodes;
    std::vector<EdgeSide> sent;
    faces_.reserve(faces.size());
    own_.reserve(4 * faces.size());
    lower_nodes.reserve(4 * faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const SidedFace& face = faces_.emplace_back(mesh, faces[f], face_corners[f]);
      for (std::size_t k = 0; k < 4; ++k) {
        if (is_repeated(faces[f].corners, (k + 1) % 4)) continue;
        const std::size_t lower = face.find_lower_corner(k);
        const int owner = chunked.numbering.find_node_owner(faces[f].corners[lower]);
        if (owner == rank_) {
          own_.push_back({static_cast<int>(f), static_cast<int>(k)});
          lower_nodes.push_back(face_corners[f][lower]);
        } else {
          sent.push_back(face.make_side(k, rank_));
          sent_.push_back({static_cast<int>(f), static_cast<int>(k)});
          sent_to_.push_back(owner);
        }
      }
    }
    received_ = ItemExchange(ranks).send(sent_to_, sent);
    for (const EdgeSide& side : received_) {
      const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), side.ends[0]);
      lower_nodes.push_back(static_cast<int>(place - mesh.node_numbers.begin()));
    }
    by_node_ = sort_into_buckets(lower_nodes, mesh.nodes.size());
  }

  std::size_t node_count() const { return by_node_.first.size() - 1; }

  /// Lowers `shortest`, by part, to the shortest edge of this rank's faces.
  void find_shortest_edges(std::vector<double>& shortest) const {
    for (const SidedFace& face : faces_) {
      double& least = shortest[at(face.face->part)];
      for (std::size_t k = 0; k < 4; ++k) {
        if (is_repeated(face.face->corners, (k + 1) % 4)) continue;
        least = std::min(least, norm(face.places.corner[(k + 1) % 4] - face.places.corner[k]));
      }
    }
  }

  /// Whether some edge of this lower node may be sharper than `cosine`: most nodes lie where the surface is smooth.
  bool may_have_edges(std::size_t node, double cosine) const {
    for (int i = by_node_.first[node]; i < by_node_.first[node + 1]; ++i) {
      const std::size_t item = at(by_node_.items[at(i)]);
      if (item >= own_.size()) return true;
      const SidedFace& face = faces_[at(own_[item].face)];
      if (face.face->offset > 0) return true;
      for (int j = by_node_.first[node]; j < i; ++j)
        if (are_at_angle(face.normal, faces_[at(own_[at(by_node_.items[at(j)])].face)].normal, cosine)) return true;
    }
    return false;
  }

  /// Whether some edge of this lower node may be a line between whose nodes edges pass. passing: by part, 0 for none.
  bool may_have_lines(std::size_t node, const std::vector<double>& passing) const {
    for (int i = by_node_.first[node]; i < by_node_.first[node + 1]; ++i) {
      const std::size_t item = at(by_node_.items[at(i)]);
      if (item >= own_.size() || passing[at(faces_[at(own_[item].face)].face->part)] > 0) return true;
    }
    return false;
  }

  /// The sides of all edges of a lower node, by edge and face.
  void list_around(std::size_t node, std::vector<EdgeSide>& sides) const {
    sides.clear();
    for (int i = by_node_.first[node]; i < by_node_.first[node + 1]; ++i) {
      const std::size_t item = at(by_node_.items[at(i)]);
      sides.push_back(item < own_.size() ? faces_[at(own_[item].face)].make_side(at(own_[item].corner), rank_)
                                         : received_[item - own_.size()]);
      sides.back().item = static_cast<int>(item);
    }
    std::sort(sides.begin(), sides.end(), side_comes_before);
  }

  /// Calls visit(first, last) for the sides of each edge of a lower node.
  template <class Visit>
  void visit_edges(std::size_t node, std::vector<EdgeSide>& sides, const Visit& visit) const {
    list_around(node, sides);
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t last = first + 1;
      while (last < sides.size() && is_same_edge(sides[first], sides[last])) ++last;
      visit(sides.data() + first, sides.data() + last);
      first = last;
    }
  }

  /// A face of the share, and its corner where the edge begins.
  struct OwnSide {
    int face, corner;
  };
  /// Items below this number of them are this rank's, the others are received from other ranks in this order.
  const std::vector<OwnSide>& own() const { return own_; }
  const std::vector<OwnSide>& sent() const { return sent_; }
  const std::vector<int>& sent_to() const { return sent_to_; }

 private:
  int rank_;
  std::vector<SidedFace> faces_;
  std::vector<OwnSide> own_, sent_;
  std::vector<int> sent_to_;  // ranks
  std::vector<EdgeSide> received_;
  Buckets by_node_;  // of own, then of received sides
};

/// How the sides of an edge belong together.
enum class EdgeKind {
  rim,   // a shell ends
  fold,  // two shells meet
  solid  // two faces of solids meet
};

/// Calls visit(kind, side, other side) for what meets at an edge. sides: [first, last), by face. Shells have two sides
/// each here, one after the other, of which either will do. Where more than two faces meet, those of one element belong
/// together, and two that are left; shells that meet solids have none.
template <class Visit>
void visit_meetings(const EdgeSide* first, const EdgeSide* last, const Visit& visit) {
  const auto count = last - first;
  if (std::all_of(first, last, [](const EdgeSide& side) { return side.is_shell(); })) {
    if (count == 2) visit(EdgeKind::rim, *first, *(first + 1));
    if (count == 4) visit(EdgeKind::fold, *first, *(first + 2));
    return;
  }
  const EdgeSide* left[2] = {nullptr, nullptr};
  int num_left = 0;
  for (const EdgeSide* side = first; side != last; ++side) {
    if (side->is_shell()) continue;
    if (side + 1 != last && side->element() == (side + 1)->element()) {
      visit(EdgeKind::solid, *side, *(side + 1));
      ++side;
    } else {
      if (num_left < 2) left[num_left] = side;
      ++num_left;
    }
  }
  if (num_left == 2) visit(EdgeKind::solid, *left[0], *left[1]);
}

/// Whether an edge is sharper than this cosine at the start.
inline bool is_sharp(EdgeKind kind, const EdgeSide& a, const EdgeSide& b, double cosine) {
  switch (kind) {
    case EdgeKind::rim:
      return true;
    case EdgeKind::fold:
      return dot(a.inward, b.inward) > -cosine;  // whichever way the faces look
    case EdgeKind::solid:
      break;
  }
  return dot(a.normal, b.normal) < cosine && dot(a.normal, b.inward) < 0;
}

/// Whether an edge is a feature by the angle at the start.
inline bool is_feature(EdgeKind kind, const EdgeSide& a, const EdgeSide& b) {
  return is_sharp(kind, a, b, contact_limits::feature);
}

/// Whether an edge touches others by the angle at the start, as a feature or once they have crossed.
inline bool is_blunt_or_feature(EdgeKind kind, const EdgeSide& a, const EdgeSide& b) {
  return is_sharp(kind, a, b, contact_limits::blunt);
}

/// Length above which other edges can pass between the nodes of this one.
inline double find_passing_length(EdgeKind kind, const EdgeSide& a) {
  namespace limits = contact_limits;
  return a.length * (kind == EdgeKind::solid ? limits::passing_edges : limits::passing_edges_of_shells);
}

/// Whether an edge is a line of a flat or convex surface of solids, or of a curved shell, between whose nodes an edge
/// as long as `passing` can pass.
inline bool is_passed_line(EdgeKind kind, const EdgeSide& a, const EdgeSide& b, double passing) {
  namespace limits = contact_limits;
  if (!(find_passing_length(kind, a) < passing)) return false;
  return kind == EdgeKind::solid ? dot(a.normal, b.inward) < limits::concave_sine
                                 : is_sharp(kind, a, b, limits::curved);
}

}  // namespace percuss
