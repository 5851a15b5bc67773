#include "src/contact/surface/surface_share.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/contact_nodes.hpp"
#include "src/contact/surface/face_springs.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/contact/surface/surface_classes.hpp"
#include "src/contact/surface/touching_beams.hpp"
#include "src/index.hpp"

namespace percuss {

namespace {

/// Corners behind those of each face, by topology: surfaces are defined anew at each erosion.
using CornersBehind = std::array<std::array<std::array<int, 4>, most_faces>, topology_count>;

constexpr CornersBehind list_corners_behind() {
  CornersBehind behind{};
  for (std::size_t t = 0; t < topology_count; ++t) {
    const auto faces = topologies[t].faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < 4; ++i)
        behind[t][f][i] = topologies[t].find_corner_behind(faces[f], faces[f].four[i]);
    }
  }
  return behind;
}

/// The node behind each corner of a face; of a shell that of the corner itself.
std::array<int, 4> find_nodes_behind(const Mesh& mesh, const ElementFace& f) {
  static constexpr CornersBehind behind = list_corners_behind();
  std::array<int, 4> nodes = behind[static_cast<std::size_t>(mesh.block_of(at(f.element)).topology)][at(f.face)];
  for (int& node : nodes) node = mesh.corners(at(f.element))[at(node)];
  return nodes;
}

void list_faces(const ChunkedMesh& chunked, const std::vector<ElementFace>& faces, SurfaceShare& share) {
  const Mesh& mesh = chunked.mesh;
  const std::vector<std::int64_t> numbers = list_element_numbers(chunked);
  share.faces.reserve(faces.size());
  share.face_corners.reserve(faces.size());
  share.face_backs.reserve(faces.size());
  for (const ElementFace& f : faces) {
    FaceTopology face;
    face.number = find_face_number(numbers[at(f.element)], f.face);
    face.body = mesh.bodies[at(f.element)];
    face.part = mesh.part_of(at(f.element));
    face.offset = 0.5 * mesh.thickness_of(at(f.element));
    const std::array<int, 4> corners = mesh.elements.face_nodes(f), backs = find_nodes_behind(mesh, f);
    for (std::size_t i = 0; i < 4; ++i) {
      face.corners[i] = mesh.node_numbers[at(corners[i])];
      face.backs[i] = mesh.node_numbers[at(backs[i])];
    }
    share.faces.push_back(face);
    share.face_corners.push_back(corners);
    share.face_backs.push_back(backs);
  }
}

/// Surfaces of edges: few sets of many edges.
struct EdgeSurfaces {
  std::vector<SurfaceSet> sets;  // by two classes of faces
  std::vector<int> of_edge;      // which of these
};

/// Surfaces of each edge: those of its two faces, or of its beam.
EdgeSurfaces find_edge_surfaces(const std::vector<FoundEdge>& edges, const SurfaceClasses& classes) {
  EdgeSurfaces found;
  std::map<std::array<int, 2>, int> place_of_faces;
  found.of_edge.reserve(edges.size());
  for (const FoundEdge& edge : edges) {
    const std::array<int, 2> faces{edge.face_classes[0], edge.face_classes[1]};
    const auto [place, is_new] = place_of_faces.try_emplace(faces, static_cast<int>(found.sets.size()));
    found.of_edge.push_back(place->second);
    if (!is_new) continue;
    const SurfaceSet &a = classes.sets[at(faces[0])], &b = classes.sets[at(faces[1])];
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(found.sets.emplace_back()));
  }
  return found;
}

/// Keeps the edges that may touch others, with their mesh nodes.
void set_edges(const Mesh& mesh, const Communicator& ranks, const std::vector<FoundEdge>& edges,
               const EdgeSurfaces& surfaces, SurfaceShare& share) {
  const SurfaceClasses& classes = share.classes;
  const auto friction = to_host(share.pair_friction);
  const std::size_t n = at(classes.count());
  share.edges.clear();
  share.edge_ends.clear();
  std::vector<double> lengths;
  std::vector<int> class_of_set;
  for (const SurfaceSet& set : surfaces.sets) class_of_set.push_back(classes.find(set));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int surface_class = class_of_set[at(surfaces.of_edge[e])];
    const double* const row = friction.data() + at(surface_class) * n;
    if (std::all_of(row, row + n, [](double f) { return f < 0; })) continue;
    share.edges.push_back(edges[e].edge);
    share.edges.back().surface_class = surface_class;
    std::array<int, 2> ends{};
    for (std::size_t i = 0; i < 2; ++i) ends[i] = find_number(mesh.node_numbers, edges[e].edge.ends[i]);
    share.edge_ends.push_back(ends);
    const Vec3 &p = mesh.nodes[at(ends[0])], &q = mesh.nodes[at(ends[1])];
    lengths.push_back(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  share.edge_piece = divide_edges(ranks, lengths, share.edges);
}

/// Classes of nodes and faces, who may touch whom, and which nodes and faces a search must look at.
void set_classes(const Deck& deck, const SurfaceClasses& of_faces, const std::vector<SurfaceSet>& node_sets,
                 SurfaceShare& share) {
  const SurfaceClasses& classes = share.classes;
  const auto renumber = [&](FaceTopology& face) {
    face.surface_class = classes.find(of_faces.sets[at(face.surface_class)]);
  };
  std::for_each(share.faces.begin(), share.faces.end(), renumber);
  std::for_each(share.foreign_faces.begin(), share.foreign_faces.end(), renumber);
  for (FoundEdge& beam : share.beams)
    for (int& surface_class : beam.face_classes) surface_class = classes.find(of_faces.sets[at(surface_class)]);
  for (const SurfaceSet& set : node_sets) share.nodes.classes.push_back(classes.find(set));
  std::vector<double> friction;
  std::vector<int> pair_number;
  for (const PairRule& rule : classes.find_rules(deck.contact, share.active)) {
    friction.push_back(rule.friction);
    pair_number.push_back(rule.pair);
  }
  const std::size_t n = at(classes.count());
  std::vector<char> node_searched(n, 0), face_searched(n, 0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (friction[a * n + b] >= 0) node_searched[a] = face_searched[b] = 1;
    }
  }
  share.num_classes = classes.count();
  share.pair_friction = to_view("contact::pair_friction", friction);
  share.pair_number = to_view("contact::pair_number", pair_number);
  for (const int c : share.nodes.classes) share.nodes.searched.push_back(node_searched[at(c)]);
  for (const FaceTopology& face : share.faces) share.face_searched.push_back(face_searched[at(face.surface_class)]);
}

/// Thickness of the shells and beams that may touch anything.
void set_offsets(const Mesh& mesh, const Communicator& ranks, SurfaceShare& share) {
  if (!has_shells(mesh) && !share.has_beams) return;
  double largest = 0;
  for (std::size_t f = 0; f < share.faces.size(); ++f)
    if (share.face_searched[f] != 0) largest = std::max(largest, share.faces[f].offset);
  const OwnedContactNodes& nodes = share.nodes;
  for (std::size_t n = 0; n < nodes.searched.size(); ++n)
    for (int f = nodes.first_face[n]; nodes.searched[n] != 0 && f < nodes.first_face[n + 1]; ++f)
      largest = std::max(largest, share.face(nodes.faces[at(f)]).offset);
  for (const double radius : nodes.radii) largest = std::max(largest, radius);
  for (const FoundEdge& beam : share.beams) largest = std::max(largest, beam.edge.offset);
  all_reduce(ranks, Reduce::largest, largest);
  share.largest_offset = largest;
  if (largest == 0) return;
  std::vector<double> reach;
  for (const int f : share.searched_faces) reach.push_back(find_offset_reach(share.faces[at(f)].offset, largest));
  share.reach_list = to_view("contact::face_reach", reach);
}

void set_lists(const Mesh& mesh, const Communicator& ranks, SurfaceShare& share) {
  std::vector<std::array<int, 4>> corners;
  std::vector<char> is_watched(mesh.nodes.size(), 0);
  for (const int n : share.nodes.mesh_nodes) is_watched[at(n)] = 1;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    if (share.face_searched[f] == 0) continue;
    // The thickness of a shell is that of time 0; of a solid it is found from the nodes behind the face.
    if (share.faces[f].offset == 0)
      for (const int n : share.face_backs[f]) is_watched[at(n)] = 1;
    share.searched_faces.push_back(static_cast<int>(f));
    corners.push_back(share.face_corners[f]);
  }
  share.node_list = to_view("contact::nodes", share.nodes.mesh_nodes);
  std::vector<int> watched;
  for (std::size_t n = 0; n < is_watched.size(); ++n)
    if (is_watched[n] != 0) watched.push_back(static_cast<int>(n));
  share.watched_list = to_view("contact::watched_nodes", watched);
  share.corner_list = to_rows("contact::face_nodes", corners);
  std::int64_t totals[4] = {share.nodes.count(), static_cast<std::int64_t>(share.faces.size()),
                            static_cast<std::int64_t>(corners.size()), static_cast<std::int64_t>(share.edges.size())};
  all_reduce(ranks, Reduce::sum, totals);
  share.total_nodes = totals[0];
  share.total_faces = totals[1];
  share.total_searched_faces = totals[2];
  share.total_edges = totals[3];
}

SpringRows find_spring_rows(const Deck& deck) {
  if (!may_have_contact_springs(deck)) return SpringRows::none;
  return deck.contact.enforcement == ContactDeck::Enforcement::penalty ? SpringRows::all : SpringRows::of_sheets;
}

}  // namespace

SurfaceShare build_surface_share(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                                 UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds,
                                 const ActiveContact& active) {
  const Mesh& mesh = chunked.mesh;
  SurfaceShare share;
  share.active = active;
  const std::vector<ElementFace> faces = find_exterior_faces(mesh);
  list_faces(chunked, faces, share);
  const std::vector<SurfaceSet> face_sets = find_face_surfaces(mesh, deck, ties, faces);
  std::vector<SurfaceSet> named = face_sets, part_sets;
  share.has_beams = has_touching_beams(mesh, deck);
  if (mesh.eroded.any || share.has_beams) part_sets = find_part_surfaces(mesh, deck);
  named.insert(named.end(), part_sets.begin(), part_sets.end());
  // Classes are agreed on twice: nodes and edges lie on unions of the faces' surfaces, which are classes of their own.
  const SurfaceClasses of_faces = agree_on_classes(mesh, std::move(named));
  for (std::size_t f = 0; f < faces.size(); ++f) share.faces[f].surface_class = of_faces.find(face_sets[f]);
  std::vector<int> part_classes;
  part_classes.reserve(part_sets.size());
  for (const SurfaceSet& set : part_sets) part_classes.push_back(of_faces.find(set));
  std::vector<SurfaceSet> node_sets = list_contact_nodes(chunked, deck, find_face_springs(mesh, deck, faces),
                                                         {of_faces, part_classes}, exchange, share);
  adjust_for_ties(deck, ties, share.nodes, node_sets);
  share.own_sets = of_faces.sets;
  share.own_sets.insert(share.own_sets.end(), node_sets.begin(), node_sets.end());
  sort_unique(share.own_sets);
  std::vector<SurfaceSet> all = share.own_sets;
  std::vector<FoundEdge> edges;
  const bool has_edges = has_edge_contact(deck.contact);
  if (has_edges) edges = find_feature_edges(chunked, share, exchange, folds, share.passing_lengths);
  const EdgeSurfaces edge_surfaces = find_edge_surfaces(edges, of_faces);
  all.insert(all.end(), edge_surfaces.sets.begin(), edge_surfaces.sets.end());
  share.classes = agree_on_classes(mesh, std::move(all));
  set_classes(deck, of_faces, node_sets, share);
  if (has_edges) set_edges(mesh, exchange.ranks(), edges, edge_surfaces, share);
  set_lists(mesh, exchange.ranks(), share);
  set_offsets(mesh, exchange.ranks(), share);
  share.springs = find_spring_rows(deck);
  return share;
}

bool change_folds(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                  UnstructuredExchange& exchange, const std::vector<EdgeEnds>& folds, SurfaceShare& share) {
  const std::vector<FoundEdge> edges = find_feature_edges(chunked, share, exchange, folds, share.passing_lengths);
  const EdgeSurfaces edge_surfaces = find_edge_surfaces(edges, share.classes);
  std::vector<SurfaceSet> all = share.own_sets;
  all.insert(all.end(), edge_surfaces.sets.begin(), edge_surfaces.sets.end());
  if (agree_on_classes(chunked.mesh, std::move(all)).sets != share.classes.sets) {  // the same on all ranks
    share = build_surface_share(chunked, deck, ties, exchange, folds, ActiveContact(share.active));
    return false;
  }
  set_edges(chunked.mesh, exchange.ranks(), edges, edge_surfaces, share);
  share.total_edges = static_cast<std::int64_t>(share.edges.size());
  all_reduce(exchange.ranks(), Reduce::sum, share.total_edges);
  return true;
}

}  // namespace percuss
