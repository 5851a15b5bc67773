#include "src/contact/surface/feature_edges.hpp"

#include <algorithm>
#include <cmath>

#include "comm/exchange/item_exchange.hpp"
#include "comm/merge_reduction.hpp"
#include "kernels/contact/geometry/edge_geometry.hpp"
#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/core/counting_sort.hpp"
#include "kernels/core/exact_sum.hpp"
#include "src/contact/surface/face_corners.hpp"
#include "src/contact/surface/surface_share.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_edges = 1 << edge_place_bits;  // of one lower node

/// One side of an edge: a face that ends there.
struct EdgeSide {
  std::int64_t ends[2]{}, wings[2]{};  // node numbers; the wing of each end
  std::int64_t face = 0;               // number
  int surface_class = 0;
  int rank = 0;
  double offset = 0;
  Point3 normal{}, inward{};  // of the face, and from the edge into it

  std::int64_t element() const { return find_element_of_face(face); }
  bool is_shell() const { return offset > 0; }
};

bool are_at_angle(const Point3& normal, const Point3& other) { return dot(normal, other) < contact_limits::feature; }

bool is_same_edge(const EdgeSide& a, const EdgeSide& b) { return a.ends[0] == b.ends[0] && a.ends[1] == b.ends[1]; }

bool comes_before(const EdgeSide& a, const EdgeSide& b) {
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
    side.rank = rank;
    side.offset = of.offset;
    side.normal = normal;
    side.inward = find_inward(places.corner[p], places.corner[q], places.corner[wing_p], places.corner[wing_q]);
    return side;
  }
};

/// Sides of the edges whose lower node is this rank's: those of its own faces, made on demand, and those received from
/// other ranks.
class ToldSides {
 public:
  /// Collective.
  ToldSides(const ChunkedMesh& chunked, const std::vector<FaceTopology>& faces,
            const std::vector<std::array<int, 4>>& face_corners, const Communicator& ranks)
      : rank_(ranks.rank()) {
    const Mesh& mesh = chunked.mesh;
    std::vector<int> lower_nodes, owners;
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
          owners.push_back(owner);
        }
      }
    }
    received_ = ItemExchange(ranks).send(owners, sent);
    for (const EdgeSide& side : received_) {
      const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), side.ends[0]);
      lower_nodes.push_back(static_cast<int>(place - mesh.node_numbers.begin()));
    }
    by_node_ = sort_into_buckets(lower_nodes, mesh.nodes.size());
  }

  std::size_t node_count() const { return by_node_.first.size() - 1; }

  /// Whether some edge of this lower node may be a feature: most nodes lie where the surface is smooth.
  bool may_have_features(std::size_t node) const {
    for (int i = by_node_.first[node]; i < by_node_.first[node + 1]; ++i) {
      const std::size_t item = at(by_node_.items[at(i)]);
      if (item >= own_.size()) return true;
      const SidedFace& face = faces_[at(own_[item].face)];
      if (face.face->offset > 0) return true;
      for (int j = by_node_.first[node]; j < i; ++j)
        if (are_at_angle(face.normal, faces_[at(own_[at(by_node_.items[at(j)])].face)].normal)) return true;
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
    }
    std::sort(sides.begin(), sides.end(), comes_before);
  }

 private:
  struct OwnSide {
    int face, corner;
  };

  int rank_;
  std::vector<SidedFace> faces_;
  std::vector<OwnSide> own_;
  std::vector<EdgeSide> received_;
  Buckets by_node_;  // of own, then of received sides
};

bool is_feature(const EdgeSide& a, const EdgeSide& b) {
  return are_at_angle(a.normal, b.normal) && dot(a.normal, b.inward) < 0;
}

/// Whether two shells meet at an angle of more than that of feature edges, whichever way their faces look.
bool is_fold(const EdgeSide& a, const EdgeSide& b) { return dot(a.inward, b.inward) > -contact_limits::feature; }

FoundEdge make_edge(const EdgeSide& first, const EdgeSide& second) {
  FoundEdge found;
  EdgeTopology& edge = found.edge;
  const EdgeSide* const sides[2] = {&first, &second};
  for (int i = 0; i < 2; ++i) {
    edge.ends[i] = first.ends[i];
    edge.elements[i] = sides[i]->element();
    found.face_classes[i] = sides[i]->surface_class;
    for (int j = 0; j < 2; ++j) edge.wings[2 * i + j] = sides[i]->wings[j];
  }
  edge.home = first.rank;
  edge.offset = std::max(first.offset, second.offset);
  return found;
}

/// The feature edge of shells, if they are all that meets there: their end, with the same wedge on both sides, or a
/// fold. Each has two sides here, one after the other, of which either will do.
void list_shell_edges(const EdgeSide* first, const EdgeSide* last, std::vector<FoundEdge>& edges) {
  const auto count = last - first;
  if (count == 2 || (count == 4 && is_fold(*first, *(first + 2))))
    edges.push_back(make_edge(*first, *(first + count - 2)));
}

/// The feature edges of sides [first, last) of one edge of the mesh. Where more than two faces meet, those of one
/// element belong together, and two that are left; shells that meet solids have none.
void list_edges(const EdgeSide* first, const EdgeSide* last, std::vector<FoundEdge>& edges) {
  if (std::all_of(first, last, [](const EdgeSide& side) { return side.is_shell(); })) {
    list_shell_edges(first, last, edges);
    return;
  }
  std::vector<const EdgeSide*> left;
  const auto add = [&](const EdgeSide& a, const EdgeSide& b) {
    if (is_feature(a, b)) edges.push_back(make_edge(a, b));
  };
  for (const EdgeSide* side = first; side != last; ++side) {
    if (side->is_shell()) continue;
    if (side + 1 != last && side->element() == (side + 1)->element()) {
      add(*side, *(side + 1));
      ++side;
    } else {
      left.push_back(side);
    }
  }
  if (left.size() == 2) add(*left[0], *left[1]);
}

/// Edges by lower node, numbered.
std::vector<FoundEdge> number_edges(const ToldSides& told) {
  std::vector<FoundEdge> edges;
  std::vector<EdgeSide> sides;
  for (std::size_t node = 0; node < told.node_count(); ++node) {
    if (!told.may_have_features(node)) continue;
    told.list_around(node, sides);
    const std::size_t first_edge = edges.size();
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t last = first + 1;
      while (last < sides.size() && is_same_edge(sides[first], sides[last])) ++last;
      list_edges(sides.data() + first, sides.data() + last, edges);
      first = last;
    }
    if (edges.size() - first_edge > most_edges)
      throw InputError(
          "mesh: error: a node has more than 128 sharp edges (edge contact supports no more): coarsen the mesh around "
          "it, or set contact.edges: false");
    for (std::size_t i = first_edge; i < edges.size(); ++i)
      edges[i].edge.number = (edges[i].edge.ends[0] << edge_place_bits) + static_cast<std::int64_t>(i - first_edge);
  }
  return edges;
}

}  // namespace

std::vector<FoundEdge> find_feature_edges(const ChunkedMesh& chunked, const std::vector<FaceTopology>& faces,
                                          const std::vector<std::array<int, 4>>& face_corners,
                                          UnstructuredExchange& exchange) {
  const ToldSides sides(chunked, faces, face_corners, exchange.ranks());
  std::vector<FoundEdge> numbered;
  fail_together(exchange.ranks(), [&] { numbered = number_edges(sides); });
  std::vector<int> homes;
  homes.reserve(numbered.size());
  for (const FoundEdge& found : numbered) homes.push_back(found.edge.home);
  std::vector<FoundEdge> edges = ItemExchange(exchange.ranks()).send(homes, numbered);
  std::sort(edges.begin(), edges.end(),
            [](const FoundEdge& a, const FoundEdge& b) { return a.edge.number < b.edge.number; });
  return edges;
}

int count_pieces(double length, double piece) {
  constexpr double most = 1000;
  return static_cast<int>(std::clamp(std::ceil(length / piece), 1.0, most));
}

double divide_edges(const Communicator& ranks, const std::vector<double>& lengths, std::vector<EdgeTopology>& edges) {
  // Exact, because it sets what a search lists.
  struct Sums {
    ExactSum length;
    std::int64_t count = 0;
    void merge(const Sums& other) {
      length.merge(other.length);
      count += other.count;
    }
  } sums;
  for (const double length : lengths) sums.length.add(length);
  sums.count = static_cast<std::int64_t>(lengths.size());
  sums.length.normalize();
  if (ranks.size() > 1) MergeReduction<Sums>()(ranks, sums);
  if (sums.count == 0) return 0;
  // Short enough for edges that are not neighbours in a uniform mesh to be no pairs.
  constexpr double longest = 1.25;  // piece, in mean lengths
  const double piece = longest * sums.length.round() / static_cast<double>(sums.count);
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e].pieces = count_pieces(lengths[e], piece);
  return piece;
}

}  // namespace percuss
