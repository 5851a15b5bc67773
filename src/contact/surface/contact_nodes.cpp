#include "src/contact/surface/contact_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "comm/exchange/item_exchange.hpp"
#include "kernels/core/counting_sort.hpp"
#include "src/contact/surface/face_corners.hpp"
#include "src/contact/surface/face_springs.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/contact/surface/touching_beams.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A face in the message to the owner of one of its corners.
struct CornerNotice {
  std::int64_t node = 0;
  double size = 0;    // shorter of the two edges that meet there
  double spring = 0;  // its share of the stiffness of the face
  FaceTopology face;
};

/// Message to an owned node on a face around it or, by a face without a number, on itself as a particle.
struct NodeNotice {
  int node = 0;  // of this rank's mesh
  int face = 0;  // SurfaceShare::face()
  double size = 0, spring = 0;
};

/// Lengths of the edges of a face, from each corner to the next.
std::array<double, 4> measure_edges(const Mesh& mesh, const std::array<int, 4>& corners) {
  std::array<double, 4> lengths{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 &p = mesh.nodes[at(corners[i])], &q = mesh.nodes[at(corners[(i + 1) % 4])];
    lengths[i] = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return lengths;
}

/// The shorter of the two edges that meet at a corner, which is not one repeated.
double find_corner_size(const std::array<int, 4>& corners, const std::array<double, 4>& lengths, std::size_t corner) {
  const std::size_t next = (corner + 1) % 4, previous = (corner + 3) % 4;
  return std::min(lengths[corners[next] == corners[corner] ? next : corner], lengths[previous]);
}

/// Shortest edge of an element at one of its corners.
double find_shortest_edge_at(const Mesh& mesh, std::size_t element, int corner) {
  const std::span<const int> nodes = mesh.corners(element);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.topology_of(element).edges()) {
    if (a != corner && b != corner) continue;
    const Vec3 &p = mesh.nodes[at(nodes[at(a)])], &q = mesh.nodes[at(nodes[at(b)])];
    shortest = std::min(shortest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return shortest;
}

/// The last face of a topology that has the corner.
int find_last_face(const Topology& topology, int corner) {
  int last = 0;
  for (int f = 0; f < topology.face_count; ++f) {
    const std::span<const int> corners = topology.face_table[at(f)].corners();
    if (std::find(corners.begin(), corners.end(), corner) != corners.end()) last = f;
  }
  return last;
}

/// Nodes without elements: data from their eroded elements, without a face. part_classes: the class of each part's
/// surface.
std::vector<CornerNotice> list_particles(const Mesh& mesh, const Deck& deck, const std::vector<int>& part_classes) {
  std::vector<CornerNotice> notices;
  std::vector<ElementFace> faces;  // a face at each corner, for its stiffness
  for (std::size_t e = 0; e < mesh.eroded.dead.size(); ++e) {
    if (mesh.eroded.dead[e] == 0) continue;
    const Topology& topology = mesh.topology_of(e);
    for (int corner = 0; corner < topology.corner_count; ++corner) {
      const int node = mesh.corners(e)[at(corner)];
      if (mesh.eroded.nodes[at(node)] != ErodedMesh::particle) continue;
      CornerNotice notice;
      notice.node = mesh.node_numbers[at(node)];
      notice.size = find_shortest_edge_at(mesh, e, corner);
      notice.face.part = mesh.part_of(e);
      notice.face.surface_class = part_classes[at(notice.face.part)];
      notices.push_back(notice);
      faces.push_back({static_cast<int>(e), find_last_face(topology, corner)});
    }
  }
  const std::vector<double> springs = find_face_springs(mesh, deck, faces);
  for (std::size_t n = 0; n < notices.size(); ++n) {
    const Topology& topology = mesh.topology_of(at(faces[n].element));
    notices[n].spring = springs[n] / topology.face_table[at(faces[n].face)].count;
  }
  return notices;
}

/// Adds ends of beams, as nodes with a radius, and to the share their edges. Collective.
void list_beams(const ChunkedMesh& chunked, const Deck& deck, const std::vector<int>& part_classes,
                const Communicator& ranks, std::vector<CornerNotice>& notices, SurfaceShare& share) {
  for (const TouchingBeam& beam : list_touching_beams(chunked, deck, ranks.rank())) {
    CornerNotice notice;
    notice.size = std::min(beam.length, 2 * beam.radius);
    notice.spring = beam.spring;
    notice.face.part = beam.part;
    notice.face.body = beam.body;
    notice.face.surface_class = part_classes[at(beam.part)];
    notice.face.offset = beam.radius;
    for (const std::int64_t end : beam.edge.ends) {
      notice.node = end;
      notices.push_back(notice);
    }
    const int own = notice.face.surface_class;
    share.beams.push_back({beam.edge, {own, own}, beam.part, beam.length});
  }
  mark_beam_ends(chunked.numbering, ranks, share.beams);
}

/// Notifies the owner of every corner of each face of this rank, and of particles and beams. Returns the notices of
/// owned nodes: of faces of the share in their order, then of `foreign_faces`, which it fills.
std::vector<NodeNotice> notify_nodes(const ChunkedMesh& chunked, const std::vector<double>& springs,
                                     std::vector<CornerNotice> sent, UnstructuredExchange& exchange,
                                     SurfaceShare& share) {
  const Mesh& mesh = chunked.mesh;
  const int own = exchange.ranks().rank();
  std::vector<NodeNotice> notices;
  notices.reserve(4 * share.faces.size());
  std::vector<int> owners;
  owners.reserve(sent.size());
  for (const CornerNotice& notice : sent) owners.push_back(chunked.numbering.find_node_owner(notice.node));
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    const FaceTopology& face = share.faces[f];
    const std::array<int, 4>& corners = share.face_corners[f];
    const std::array<double, 4> lengths = measure_edges(mesh, corners);
    const double spring = springs[f] / static_cast<double>(count_corners(corners));
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_repeated(corners, i)) continue;
      const double size = find_corner_size(corners, lengths, i);
      const int owner = chunked.numbering.find_node_owner(face.corners[i]);
      if (owner == own) {
        notices.push_back({corners[i], static_cast<int>(f), size, spring});
      } else {
        sent.push_back({face.corners[i], size, spring, face});
        owners.push_back(owner);
      }
    }
  }
  for (const CornerNotice& notice : ItemExchange(exchange.ranks()).send(owners, sent)) {
    const int node = find_number(mesh.node_numbers, notice.node);
    const std::size_t face = share.faces.size() + share.foreign_faces.size();
    share.foreign_faces.push_back(notice.face);
    notices.push_back({node, static_cast<int>(face), notice.size, notice.spring});
  }
  return notices;
}

/// Elements at a node: the node of a solid has no thickness, whatever beams end there.
struct NodeItems {
  bool has_faces = false, has_solid = false;

  template <class Items, class FaceOf>
  NodeItems(const Items& first, const Items& last, const FaceOf& face_of) {
    for (auto item = first; item != last; ++item) {
      const FaceTopology& face = face_of(*item);
      has_faces = has_faces || face.number >= 0;
      has_solid = has_solid || (face.number >= 0 && face.offset == 0);
    }
  }
};

/// Adds a particle or an end of a beam to the last node, in no certain order.
void add_point(const NodeNotice& notice, const FaceTopology& face, const NodeItems& around, SurfaceShare& share) {
  OwnedContactNodes& nodes = share.nodes;
  nodes.springs.back() = std::max(nodes.springs.back(), notice.spring);
  if (!around.has_faces) nodes.parts.back() = std::min(nodes.parts.back(), face.part);
  if (face.offset == 0) return;
  const bool is_first = nodes.beams.back() < 0;
  const FaceTopology& last = is_first ? face : share.face(nodes.beams.back());
  if (is_first || std::pair(face.body, face.part) < std::pair(last.body, last.part)) nodes.beams.back() = notice.face;
  nodes.radii.back() = std::max(nodes.radii.back(), face.offset);
}

/// Adds a node, so far without faces and beams.
void begin_node(const Mesh& mesh, std::size_t n, int part, SurfaceShare& share) {
  OwnedContactNodes& nodes = share.nodes;
  nodes.mesh_nodes.push_back(static_cast<int>(n));
  nodes.numbers.push_back(mesh.node_numbers[n]);
  nodes.ids.push_back(mesh.node_ids[n]);
  nodes.sizes.push_back(std::numeric_limits<double>::infinity());
  nodes.springs.push_back(0);
  nodes.parts.push_back(part);
  nodes.first_face.push_back(static_cast<int>(nodes.faces.size()));
  if (!share.has_beams) return;
  nodes.radii.push_back(0);
  nodes.beams.push_back(-1);
}

/// point_classes: out, [nodes] classes of the surfaces of particles and beams.
void list_nodes(const Mesh& mesh, const std::vector<NodeNotice>& notices, SurfaceShare& share,
                std::vector<std::vector<int>>& point_classes) {
  OwnedContactNodes& nodes = share.nodes;
  std::vector<int> noticed;
  noticed.reserve(notices.size());
  for (const NodeNotice& notice : notices) noticed.push_back(notice.node);
  Buckets by_node = sort_into_buckets(noticed, mesh.nodes.size());
  nodes.faces.reserve(notices.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto first = by_node.items.begin() + by_node.first[n], last = by_node.items.begin() + by_node.first[n + 1];
    if (first == last) continue;
    const auto face_of = [&](int item) -> const FaceTopology& { return share.face(notices[at(item)].face); };
    if (at(notices[at(*(last - 1))].face) >= share.faces.size())  // the rank's own faces are in order
      std::sort(first, last, [&](int a, int b) { return face_of(a).number < face_of(b).number; });
    begin_node(mesh, n, face_of(*first).part, share);
    const NodeItems around(first, last, face_of);
    bool has_soft = false;  // a face without a spring
    point_classes.emplace_back();
    for (auto item = first; item != last; ++item) {
      const NodeNotice& notice = notices[at(*item)];
      const FaceTopology& face = face_of(*item);
      if (face.number < 0 && face.offset > 0 && around.has_solid) continue;
      nodes.sizes.back() = std::min(nodes.sizes.back(), notice.size);
      if (face.number < 0) {
        add_point(notice, face, around, share);
        point_classes.back().push_back(face.surface_class);
        continue;
      }
      nodes.springs.back() += notice.spring;
      has_soft = has_soft || !(notice.spring > 0);
      if (nodes.faces.size() == at(nodes.first_face.back())) nodes.parts.back() = face.part;
      nodes.faces.push_back(notice.face);
    }
    if (has_soft) nodes.springs.back() = 0;  // what else it has does not carry the whole thickness there
  }
  nodes.first_face.push_back(static_cast<int>(nodes.faces.size()));
}

/// Surfaces of each owned node: those of all faces around it, of a particle or a beam those of its parts.
std::vector<SurfaceSet> find_node_surfaces(const SurfaceShare& share, const SurfaceClasses& classes,
                                           const std::vector<std::vector<int>>& point_classes) {
  const OwnedContactNodes& nodes = share.nodes;
  std::vector<SurfaceSet> sets(at(nodes.count()));
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const auto add = [&](int surface_class) {
      const SurfaceSet& set = classes.sets[at(surface_class)];
      sets[n].insert(sets[n].end(), set.begin(), set.end());
    };
    for (int f = nodes.first_face[n]; f < nodes.first_face[n + 1]; ++f)
      add(share.face(nodes.faces[at(f)]).surface_class);
    for (const int surface_class : point_classes[n]) add(surface_class);
    std::sort(sets[n].begin(), sets[n].end());
    sets[n].erase(std::unique(sets[n].begin(), sets[n].end()), sets[n].end());
  }
  return sets;
}

/// Ends of beams may not touch what they are tied to, as nodes of tied faces may not.
void tie_beams(const Deck& deck, const TiedSurfaces& ties, const OwnedContactNodes& nodes,
               std::vector<SurfaceSet>& sets) {
  if (nodes.radii.empty()) return;
  for (const TiedNode& tied : ties.nodes) {
    const int place = find_number(nodes.numbers, tied.node);
    if (place < 0 || nodes.radii[at(place)] == 0) continue;
    const std::size_t n = at(place);
    sets[n].push_back(2 * (static_cast<int>(deck.contact.pairs.size()) + tied.tie));
    std::sort(sets[n].begin(), sets[n].end());
    sets[n].erase(std::unique(sets[n].begin(), sets[n].end()), sets[n].end());
  }
}

/// Nodes that were released from a tie, or are not tied yet, may touch side b, though a face of theirs is tied.
void release_nodes(const Deck& deck, const TiedSurfaces& ties, const std::vector<std::int64_t>& numbers,
                   std::vector<SurfaceSet>& sets) {
  for (const auto* const free : {&ties.released, &ties.untied}) {
    for (std::size_t t = 0; t < free->size(); ++t) {
      const int side_a = 2 * static_cast<int>(deck.contact.pairs.size() + t);
      for (const std::int64_t number : (*free)[t]) {
        const int place = find_number(numbers, number);
        if (place >= 0) std::erase(sets[at(place)], side_a);
      }
    }
  }
}

}  // namespace

std::vector<SurfaceSet> list_contact_nodes(const ChunkedMesh& chunked, const Deck& deck,
                                           const std::vector<double>& springs, const NamedSurfaces& surfaces,
                                           UnstructuredExchange& exchange, SurfaceShare& share) {
  std::vector<CornerNotice> points = list_particles(chunked.mesh, deck, surfaces.of_parts);
  if (share.has_beams) list_beams(chunked, deck, surfaces.of_parts, exchange.ranks(), points, share);
  std::vector<std::vector<int>> point_classes;
  list_nodes(chunked.mesh, notify_nodes(chunked, springs, std::move(points), exchange, share), share, point_classes);
  return find_node_surfaces(share, surfaces.classes, point_classes);
}

void adjust_for_ties(const Deck& deck, const TiedSurfaces& ties, const OwnedContactNodes& nodes,
                     std::vector<SurfaceSet>& sets) {
  tie_beams(deck, ties, nodes, sets);
  release_nodes(deck, ties, nodes.numbers, sets);
}

}  // namespace percuss
