#include "src/contact/overlap/crossing_edges.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/touching_beams.hpp"
#include "src/deck/jointed_parts.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Nodes of this rank that something holds in solids or to other nodes, by their numbers, ascending.
std::vector<std::int64_t> list_held_nodes(const CrossingScene& scene) {
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<std::int64_t> held;
  const auto add = [&](const Selector& where) {
    for (const int node : select_nodes(mesh, scene.deck, where)) held.push_back(mesh.node_numbers[at(node)]);
  };
  for (const EmbeddedDeck& embedded : scene.deck.embedded) add(embedded.nodes);
  for (const ConstraintDeck& constraint : scene.deck.constraints) {
    if (constraint.nodes) add(*constraint.nodes);
    if (!constraint.between) continue;
    for (const SpringEndDeck& end : *constraint.between)
      if (!end.point) add(end.where);
  }
  std::sort(held.begin(), held.end());
  return held;
}

bool has_one(const PiercingEdge& of, const std::vector<std::int64_t>& sorted) {
  const auto is_there = [&](std::int64_t node) { return std::binary_search(sorted.begin(), sorted.end(), node); };
  return std::any_of(std::begin(of.edge.ends), std::end(of.edge.ends), is_there) ||
         std::any_of(std::begin(of.corners), std::end(of.corners), is_there);
}

/// The pairs of parts of which a tie holds one to the other, lower first. Collective.
std::set<std::pair<int, int>> list_tied_parts(const CrossingScene& scene, std::size_t tie) {
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<int> sides[2];
  for (std::size_t s = 0; s < 2; ++s) {
    std::set<int> parts;
    for (const ElementFace& face : scene.ties.faces[tie][s]) parts.insert(mesh.part_of(at(face.element)));
    sides[s] = gather_items(scene.ranks, std::vector<int>(parts.begin(), parts.end()));
  }
  std::set<std::pair<int, int>> pairs;
  for (const int a : sides[0])
    for (const int b : sides[1]) pairs.insert(std::minmax(a, b));
  return pairs;
}

/// [edges] CrossingEdge::is_held. Collective.
std::vector<int> find_held(const CrossingScene& scene, const std::vector<PiercingEdge>& edges) {
  const std::vector<std::int64_t> held = list_held_nodes(scene);
  std::vector<int> flags;
  for (const PiercingEdge& edge : edges) flags.push_back(has_one(edge, held) ? 1 : 0);
  for (std::size_t t = 0; t < scene.ties.known.size(); ++t) {
    const std::set<std::pair<int, int>> parts = list_tied_parts(scene, t);
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (parts.count(std::minmax(edges[e].edge.part, edges[e].edge.other)) > 0 &&
          has_one(edges[e], scene.ties.known[t]))
        flags[e] = 1;
  }
  all_reduce(scene.ranks, Reduce::largest, flags);
  return flags;
}

/// When edges and faces of two classes may touch.
class ContactTimes {
 public:
  explicit ContactTimes(const CrossingScene& scene)
      : count_(scene.share.num_classes),
        now_(to_host(scene.share.pair_friction)),
        ever_(scene.share.classes.find_rules(scene.deck.contact, {})) {}

  PartCrossing::Contact find(const PiercingEdge& of) const {
    using Contact = PartCrossing::Contact;
    if (of.classes[0] < 0 || of.classes[0] >= count_) return Contact::never;
    const int place = of.classes[0] * count_ + of.classes[1];
    return now_(place) >= 0 ? Contact::now : ever_[at(place)].friction >= 0 ? Contact::later : Contact::never;
  }

 private:
  int count_;
  decltype(to_host(SurfaceShare::pair_friction)) now_;
  std::vector<PairRule> ever_;
};

}  // namespace

PartKinds find_part_kinds(const Mesh& mesh) {
  PartKinds kinds{std::vector<char>(mesh.parts.size(), 0), std::vector<double>(mesh.parts.size(), 0)};
  for (const ElementBlock& block : mesh.elements.blocks) {
    if (find_topology(block.topology).is_solid()) kinds.solid[at(block.part)] = 1;
    double& thickness = kinds.thickness[at(block.part)];
    const double own = find_topology(block.topology).is_surface() ? block.section.thickness : 0;
    if (own > 0 && (thickness == 0 || own < thickness)) thickness = own;
  }
  return kinds;
}

std::vector<TravellingEdge> list_beams(const CrossingScene& scene, const HostPlaces& x) {
  const Mesh& mesh = scene.chunked.mesh;
  std::vector<TravellingEdge> beams;
  if (!has_beams(mesh)) return beams;
  const std::vector<double> radii = find_touching_radii(mesh, scene.deck);
  std::vector<int> classes(mesh.parts.size(), -1);
  if (scene.share.has_beams) {
    const std::vector<SurfaceSet> sets = find_part_surfaces(mesh, scene.deck);
    for (std::size_t p = 0; p < classes.size(); ++p)
      if (radii[p] > 0) classes[p] = scene.share.classes.find(sets[p]);
  }
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_line()) continue;
    std::pair<std::int64_t, int> ends[2];
    for (std::size_t k = 0; k < 2; ++k) ends[k] = {mesh.node_numbers[at(mesh.corners(e)[k])], mesh.corners(e)[k]};
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    const int part = mesh.part_of(e);
    beams.push_back({{{ends[0].first, ends[1].first}, mesh.bodies[e], part, classes[at(part)], -1},
                     {load_row(x, ends[0].second), load_row(x, ends[1].second)}});
  }
  return beams;
}

std::vector<CrossingEdge> find_crossing_edges(const CrossingScene& scene, const Rows3<const double>& x,
                                              const std::vector<TravellingEdge>& beams) {
  const std::vector<PiercingEdge> edges =
      find_piercing_edges(scene.ranks, scene.share, x, PiercedPairs::all_surfaces, beams).found;
  std::vector<CrossingEdge> list;
  if (edges.empty()) return list;
  const std::vector<int> held = find_held(scene, edges), body = name_rigid_bodies(scene.deck).body_of_part;
  const ContactTimes contact(scene);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto part = at(edges[e].edge.part), other = at(edges[e].edge.other);
    const bool is_one_body = body[part] >= 0 && body[part] == body[other];
    if (is_one_body || are_jointed(scene.deck, part, other)) continue;
    const bool is_inside = !edges[e].is_of_solid || edges[e].edge.depth > contact_limits::overlap * edges[e].edge.size;
    if (is_inside) list.push_back({edges[e], contact.find(edges[e]), held[e] != 0});
  }
  return list;
}

}  // namespace percuss
