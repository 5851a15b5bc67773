#include "src/contact/surface/feature_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/merge_reduction.hpp"
#include "kernels/core/exact_sum.hpp"
#include "src/contact/surface/edge_sides.hpp"
#include "src/fail_together.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_edges = 1 << edge_place_bits;  // of one lower node

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
  found.part = first.part;
  found.length = first.length;
  return found;
}

/// Whether an edge has become sharp in the run. folds: of all ranks, ascending.
bool is_folded(const std::vector<EdgeEnds>& folds, const EdgeSide& side) {
  return std::binary_search(folds.begin(), folds.end(), EdgeEnds{side.ends[0], side.ends[1]});
}

/// Whether some edge has this lower node.
bool has_folds(const std::vector<EdgeEnds>& folds, std::int64_t lower) {
  const auto first = std::lower_bound(folds.begin(), folds.end(), EdgeEnds{lower, 0});
  return first != folds.end() && first->lower == lower;
}

/// Longest feature edge of any other part, by part; 0 where none can pass between the nodes of the part. Collective.
std::vector<double> find_passing_lengths(const SharedSides& shared, const Mesh& mesh,
                                         const std::vector<FoundEdge>& beams, const Communicator& ranks) {
  std::vector<double> longest(mesh.parts.size(), 0), passing(longest.size(), 0);
  if (longest.size() < 2) return passing;
  for (const FoundEdge& beam : beams) longest[at(beam.part)] = std::max(longest[at(beam.part)], beam.length);
  std::vector<EdgeSide> sides;
  for (std::size_t node = 0; node < shared.node_count(); ++node) {
    if (!shared.may_have_edges(node, contact_limits::feature)) continue;
    shared.visit_edges(node, sides, [&](const EdgeSide* first, const EdgeSide* last) {
      visit_meetings(first, last, [&](EdgeKind kind, const EdgeSide& a, const EdgeSide& b) {
        if (is_feature(kind, a, b)) longest[at(a.part)] = std::max(longest[at(a.part)], a.length);
      });
    });
  }
  std::vector<double> shortest(longest.size(), std::numeric_limits<double>::infinity());
  shared.find_shortest_edges(shortest);
  all_reduce(ranks, Reduce::largest, longest);
  all_reduce(ranks, Reduce::least, shortest);
  for (std::size_t p = 0; p < longest.size(); ++p)
    for (std::size_t q = 0; q < longest.size(); ++q)
      if (q != p && longest[q] > contact_limits::passing_edges * shortest[p])
        passing[p] = std::max(passing[p], longest[q]);
  return passing;
}

/// Rule by which an edge of the surface may touch others.
struct EdgeRule {
  const std::vector<EdgeEnds>& folds;
  const std::vector<double>& passing;  // find_passing_lengths()

  /// EdgeTopology::is_blunt; -1: touches none.
  int find_bluntness(EdgeKind kind, const EdgeSide& a, const EdgeSide& b) const {
    if (is_feature(kind, a, b) || is_folded(folds, a)) return 0;
    if (is_blunt_or_feature(kind, a, b)) return blunt_edge;
    return is_passed_line(kind, a, b, passing[at(a.part)]) ? 2 : -1;
  }
};

void refuse_crowded_node(std::size_t num_edges) {
  if (num_edges <= most_edges) return;
  throw InputError(
      "mesh: error: a node has more than 128 sharp edges (edge contact supports no more): coarsen the mesh around "
      "it, or set contact.edges: false");
}

/// Lists the diagonals of this rank's faces that are among the folds.
void list_ridges(const Mesh& mesh, const SurfaceShare& share, const std::vector<EdgeEnds>& folds, int rank,
                 std::vector<FoundEdge>& ridges) {
  if (folds.empty()) return;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    const FaceTopology& face = share.faces[f];
    if (!has_diagonals(face)) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const FaceDiagonal diagonal = find_diagonal(face.corners, k);
      const auto [p, q] = diagonal.ends;
      if (!std::binary_search(folds.begin(), folds.end(), EdgeEnds{face.corners[p], face.corners[q]})) continue;
      FoundEdge& found = ridges.emplace_back();
      found.edge.ends[0] = face.corners[p];
      found.edge.ends[1] = face.corners[q];
      for (std::size_t i = 0; i < 4; ++i) found.edge.wings[i] = face.corners[diagonal.wings[i / 2]];
      found.edge.elements[0] = found.edge.elements[1] = find_element_of_face(face.number);
      found.edge.home = rank;
      found.edge.is_blunt = warped_ridge;
      found.face_classes[0] = found.face_classes[1] = face.surface_class;
      found.part = face.part;
      found.length = find_distance(mesh.nodes[at(share.face_corners[f][p])], mesh.nodes[at(share.face_corners[f][q])]);
    }
  }
}

/// Numbers beams and ridges behind the edges of faces that have the same lower node, and adds them to these. beams: of
/// the lower nodes of this rank, in any order; edges: by lower node.
void add_beams(std::vector<FoundEdge> beams, std::vector<FoundEdge>& edges) {
  std::sort(beams.begin(), beams.end(), [](const FoundEdge& a, const FoundEdge& b) {
    const EdgeTopology &p = a.edge, &q = b.edge;
    if (p.ends[0] != q.ends[0]) return p.ends[0] < q.ends[0];
    return p.ends[1] != q.ends[1] ? p.ends[1] < q.ends[1] : p.elements[0] < q.elements[0];
  });
  std::vector<std::int64_t> lower_of_faces;
  lower_of_faces.reserve(edges.size());
  for (const FoundEdge& found : edges) lower_of_faces.push_back(found.edge.ends[0]);
  std::int64_t lower = -1;
  std::size_t next = 0;  // place among the edges of the node
  for (FoundEdge& beam : beams) {
    if (beam.edge.ends[0] != lower) {
      lower = beam.edge.ends[0];
      const auto [first, last] = std::equal_range(lower_of_faces.begin(), lower_of_faces.end(), lower);
      next = at(last - first);
    }
    beam.edge.scale = {beam.part, beam.edge.is_blunt == warped_ridge ? 0 : beam.length};
    beam.edge.number = (lower << edge_place_bits) + static_cast<std::int64_t>(next++);
    refuse_crowded_node(next);
    edges.push_back(beam);
  }
}

/// Beams whose lower node is this rank's. Collective.
std::vector<FoundEdge> send_to_lower_nodes(const std::vector<FoundEdge>& beams, const Numbering& numbering,
                                           const Communicator& ranks) {
  std::vector<int> to;
  to.reserve(beams.size());
  for (const FoundEdge& beam : beams) to.push_back(numbering.find_node_owner(beam.edge.ends[0]));
  return ItemExchange(ranks).send(to, beams);
}

/// Sorts edges by number. On one rank those of faces come in order, and an edge is large to move: only those behind are
/// sorted.
void sort_edges(std::vector<FoundEdge>& edges) {
  const auto is_before = [](const FoundEdge& a, const FoundEdge& b) { return a.edge.number < b.edge.number; };
  const auto rest = std::is_sorted_until(edges.begin(), edges.end(), is_before);
  std::sort(rest, edges.end(), is_before);
  std::inplace_merge(edges.begin(), rest, edges.end(), is_before);
}

/// Edges by lower node, numbered.
std::vector<FoundEdge> number_edges(const SharedSides& shared, const Mesh& mesh, const EdgeRule& rule) {
  std::vector<FoundEdge> edges;
  std::vector<EdgeSide> sides;
  for (std::size_t node = 0; node < shared.node_count(); ++node) {
    if (!shared.may_have_lines(node, rule.passing) && !shared.may_have_edges(node, contact_limits::blunt) &&
        !has_folds(rule.folds, mesh.node_numbers[node]))
      continue;
    const std::size_t first_edge = edges.size();
    shared.visit_edges(node, sides, [&](const EdgeSide* first, const EdgeSide* last) {
      visit_meetings(first, last, [&](EdgeKind kind, const EdgeSide& a, const EdgeSide& b) {
        const int bluntness = rule.find_bluntness(kind, a, b);
        if (bluntness < 0) return;
        edges.push_back(make_edge(a, b));
        edges.back().edge.is_blunt = bluntness;
        edges.back().edge.scale = {a.part, bluntness == 2 ? find_passing_length(kind, a) : a.length};
      });
    });
    refuse_crowded_node(edges.size() - first_edge);
    for (std::size_t i = first_edge; i < edges.size(); ++i)
      edges[i].edge.number = (edges[i].edge.ends[0] << edge_place_bits) + static_cast<std::int64_t>(i - first_edge);
  }
  return edges;
}

}  // namespace

std::vector<FoundEdge> find_feature_edges(const ChunkedMesh& chunked, const SurfaceShare& share,
                                          UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds,
                                          std::vector<double>& passing) {
  const Communicator& ranks = exchange.ranks();
  const SharedSides sides(chunked, share.faces, share.face_corners, ranks);
  if (passing.empty()) passing = find_passing_lengths(sides, chunked.mesh, share.beams, ranks);
  std::vector<FoundEdge> beams = share.beams;
  list_ridges(chunked.mesh, share, folds, ranks.rank(), beams);
  if (share.has_beams || !folds.empty()) beams = send_to_lower_nodes(beams, chunked.numbering, ranks);
  std::vector<FoundEdge> numbered;
  fail_together(ranks, [&] {
    numbered = number_edges(sides, chunked.mesh, {folds, passing});
    add_beams(std::move(beams), numbered);
  });
  std::vector<int> homes;
  homes.reserve(numbered.size());
  for (const FoundEdge& found : numbered) homes.push_back(found.edge.home);
  std::vector<FoundEdge> edges = ItemExchange(exchange.ranks()).send(homes, numbered);
  sort_edges(edges);
  return edges;
}

int count_pieces(double length, double piece) {
  constexpr double most = 1000;
  return static_cast<int>(std::clamp(std::ceil(length / piece), 1.0, most));
}

namespace {

double set_pieces(const std::vector<double>& lengths, double piece, std::vector<EdgeTopology>& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) edges[e].pieces = count_pieces(lengths[e], piece);
  return piece;
}

}  // namespace

double divide_edges(const Communicator& ranks, const std::vector<double>& lengths, std::vector<EdgeTopology>& edges) {
  // Exact, because it sets what a search lists.
  struct Sums {
    ExactSum length, of_lines;
    std::int64_t count = 0, lines = 0;
    void merge(const Sums& other) {
      length.merge(other.length);
      of_lines.merge(other.of_lines);
      count += other.count;
      lines += other.lines;
    }
  } sums;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const bool is_line = edges[e].is_blunt >= smooth_line;
    (is_line ? sums.of_lines : sums.length).add(lengths[e]);
    ++(is_line ? sums.lines : sums.count);
  }
  sums.length.normalize();
  sums.of_lines.normalize();
  if (ranks.size() > 1) MergeReduction<Sums>()(ranks, sums);
  if (sums.count + sums.lines == 0) return 0;
  // Short enough for edges that are not neighbours in a uniform mesh to be no pairs. Lines do not cut edges that are
  // hardly longer; far longer ones would be near too many of them.
  constexpr double longest = 1.25, longest_of_lines = 2.5;  // piece, in mean lengths
  const double of_edges = sums.length.round(), of_all = of_edges + sums.of_lines.round();
  const double piece_of_all = longest * of_all / static_cast<double>(sums.count + sums.lines);
  if (sums.count == 0 || sums.lines == 0) return set_pieces(lengths, piece_of_all, edges);
  const double piece = longest * of_edges / static_cast<double>(sums.count);
  return set_pieces(lengths, std::min(piece, longest_of_lines / longest * piece_of_all), edges);
}

}  // namespace percuss
