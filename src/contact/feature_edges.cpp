#include "src/contact/feature_edges.hpp"

#include <algorithm>
#include <cmath>

#include "comm/item_exchange.hpp"
#include "comm/merge_reduction.hpp"
#include "kernels/contact/edge_geometry.hpp"
#include "kernels/contact/face_geometry.hpp"
#include "kernels/core/exact_sum.hpp"
#include "src/contact/face_corners.hpp"
#include "src/contact/surface_share.hpp"
#include "src/fail_together.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

constexpr int most_edges = 1 << edge_place_bits;  // of one lower node

/// One side of an edge: a face that ends there.
struct EdgeSide {
  std::int64_t ends[2]{}, wings[2]{};  // node numbers; the wing of each end
  std::int64_t face = 0;               // number
  int surface_class = 0;
  int rank = 0;
  double offset = 0;
  Point3 normal{}, inward{};  // of the face, and from the edge into it

  std::int64_t element() const { return face / 6; }
  bool is_shell() const { return offset > 0; }
};

bool is_same_edge(const EdgeSide& a, const EdgeSide& b) { return a.ends[0] == b.ends[0] && a.ends[1] == b.ends[1]; }

bool comes_before(const EdgeSide& a, const EdgeSide& b) {
  if (a.ends[0] != b.ends[0]) return a.ends[0] < b.ends[0];
  return a.ends[1] != b.ends[1] ? a.ends[1] < b.ends[1] : a.face < b.face;
}

/// The side of the edge from corner k of a face to the next. places: corners relative to the first.
EdgeSide make_side(const FaceTopology& face, const FacePoints& places, std::size_t k, int rank) {
  std::size_t p = k, q = (k + 1) % 4;
  std::size_t wing_p = find_previous_corner(face.corners, p), wing_q = find_next_corner(face.corners, q);
  if (face.corners[q] < face.corners[p]) {
    std::swap(p, q);
    std::swap(wing_p, wing_q);
  }
  EdgeSide side;
  side.ends[0] = face.corners[p];
  side.ends[1] = face.corners[q];
  side.wings[0] = face.corners[wing_p];
  side.wings[1] = face.corners[wing_q];
  side.face = face.number;
  side.surface_class = face.surface_class;
  side.rank = rank;
  side.offset = face.offset;
  side.normal = find_face_normal(places);
  side.inward = find_inward(places.corner[p], places.corner[q], places.corner[wing_p], places.corner[wing_q]);
  return side;
}

/// Tells the owner of every edge's lower node about its sides on this rank; returns what this rank was told, by edge
/// and face.
std::vector<EdgeSide> exchange_sides(const ChunkedMesh& chunked, const std::vector<FaceTopology>& faces,
                                     const std::vector<std::array<int, 4>>& face_corners, const Communicator& ranks) {
  std::vector<EdgeSide> sides;
  std::vector<int> owners;
  sides.reserve(4 * faces.size());
  owners.reserve(4 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    FacePoints places;
    const Vec3& origin = chunked.mesh.nodes[at(face_corners[f][0])];
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& x = chunked.mesh.nodes[at(face_corners[f][i])];
      places.corner[i] = {x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
    }
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_repeated(faces[f].corners, (k + 1) % 4)) continue;
      sides.push_back(make_side(faces[f], places, k, ranks.rank()));
      owners.push_back(chunked.numbering.find_node_owner(sides.back().ends[0]));
    }
  }
  std::vector<EdgeSide> received = ItemExchange(ranks).send(owners, sides);
  std::sort(received.begin(), received.end(), comes_before);
  return received;
}

bool is_feature(const EdgeSide& a, const EdgeSide& b) {
  return dot(a.normal, b.normal) < contact_limits::feature && dot(a.normal, b.inward) < 0;
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
std::vector<FoundEdge> number_edges(const std::vector<EdgeSide>& sides) {
  std::vector<FoundEdge> edges;
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && is_same_edge(sides[first], sides[last])) ++last;
    list_edges(sides.data() + first, sides.data() + last, edges);
    first = last;
  }
  int place = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::int64_t node = edges[i].edge.ends[0];
    place = i > 0 && edges[i - 1].edge.ends[0] == node ? place + 1 : 0;
    if (place == most_edges)
      throw InputError(
          "mesh: error: a node has more than 128 sharp edges (contact between edges numbers no more) merge "
          "the elements around it, or set contact.edges: false");
    edges[i].edge.number = (node << edge_place_bits) + place;
  }
  return edges;
}

}  // namespace

std::vector<FoundEdge> find_feature_edges(const ChunkedMesh& chunked, const std::vector<FaceTopology>& faces,
                                          const std::vector<std::array<int, 4>>& face_corners,
                                          UnstructuredExchange& exchange) {
  const std::vector<EdgeSide> sides = exchange_sides(chunked, faces, face_corners, exchange.ranks());
  std::vector<FoundEdge> numbered;
  fail_together(exchange.ranks(), [&] { numbered = number_edges(sides); });
  std::vector<int> homes;
  for (const FoundEdge& found : numbered) homes.push_back(found.edge.home);
  std::vector<FoundEdge> edges = ItemExchange(exchange.ranks()).send(homes, numbered);
  std::sort(edges.begin(), edges.end(),
            [](const FoundEdge& a, const FoundEdge& b) { return a.edge.number < b.edge.number; });
  return edges;
}

void divide_edges(const Communicator& ranks, const std::vector<double>& lengths, std::vector<EdgeTopology>& edges) {
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
  if (sums.count == 0) return;
  // Short enough for edges that are not neighbours in a uniform mesh to be no pairs.
  constexpr double longest = 1.25, most = 1000;  // pieces, in mean lengths; of one edge
  const double piece = longest * sums.length.round() / static_cast<double>(sums.count);
  for (std::size_t e = 0; e < edges.size(); ++e)
    edges[e].pieces = static_cast<int>(std::clamp(std::ceil(lengths[e] / piece), 1.0, most));
}

}  // namespace percuss
