#include "src/contact/overlap/missed_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/overlap/box_tree.hpp"
#include "src/contact/overlap/sunken_edges.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr double least_ratio = 0.1;  // share of an element
/// Least ratio for a body inside itself: tight folds reach through their neighbours.
constexpr double least_own_ratio = 0.5;

bool is_deeper(const MissedContact& a, const MissedContact& b) {
  return a.ratio != b.ratio ? a.ratio > b.ratio : a.node < b.node;
}

void take(const MissedContact& found, std::optional<MissedContact>& deepest) {
  if (found.ratio > least_ratio && (!deepest || is_deeper(found, *deepest))) deepest = found;
}

/// Whether a node has a record. face: ContactHistory::face on the host.
template <class Faces>
bool has_face(const Faces& face, int node) {
  for (int k = 0; k < contact_limits::max_touches; ++k)
    if (face(contact_limits::max_touches * node + k) >= 0) return true;
  return false;
}

/// Boxes in which the search finds nodes at faces of a part of solids, each with its part. Of all ranks; of a part as
/// many as ranks have faces of it. Collective.
std::vector<HostBox> list_part_boxes(const OverlapSearch& search, const SurfaceMotion& motion,
                                     const KnownContact& known) {
  const SurfaceShare& share = search.share;
  const Boxes boxes("contact::look_boxes", share.searched_faces.size());
  const double margin = search.find_margin(motion);
  run_where_it_pays(static_cast<int>(share.searched_faces.size()) / 2, [&](const auto& space) {
    bound_faces(space, share.bounded_faces(), motion, margin, boxes);
    space.fence();
  });
  const auto box = to_host(boxes);
  std::map<int, HostBox> own;
  for (std::size_t f = 0; f < share.searched_faces.size(); ++f) {
    const int part = share.faces[at(share.searched_faces[f])].part;
    if (known.is_of_shells(part)) continue;
    HostBox& of = own[part];
    of.item = part;
    of.add({box(f, 0), box(f, 1), box(f, 2)});
    of.add({box(f, 3), box(f, 4), box(f, 5)});
  }
  std::vector<HostBox> list;
  list.reserve(own.size());
  for (const auto& [part, of] : own) list.push_back(of);
  return gather_items(search.ranks, list);
}

/// Whether a node of solids that did not begin inside a body has no record. face: ContactHistory::face on the host.
template <class Faces>
bool is_unknown(const OwnedContactNodes& nodes, std::size_t n, const Faces& face, const KnownContact& known) {
  return nodes.searched[n] != 0 && !known.is_of_shells(nodes.parts[n]) && !has_face(face, static_cast<int>(n)) &&
         !std::binary_search(known.inside.begin(), known.inside.end(), nodes.numbers[n]);
}

void find_nodes(const OverlapSearch& search, const SurfaceMotion& motion, const std::vector<char>& watched,
                const KnownContact& known, std::optional<MissedContact>& deepest) {
  const auto x = to_host(motion.x);
  const OwnedContactNodes& nodes = search.share.nodes;
  for (const Penetration& p : search.finder.find_penetrations(motion)) {
    const auto n = static_cast<std::size_t>(p.node);
    if (watched[n] == 0 || !(p.size > 0) || nodes.parts[n] == p.part || known.is_of_shells(p.part)) continue;
    MissedContact found{p.depth / p.size, p.depth, nodes.numbers[n],  false,
                        nodes.parts[n],   p.part,  MissedWay::inside, {}};
    for (int k = 0; k < 3; ++k) found.x[k] = x(nodes.mesh_nodes[n], k);
    take(found, deepest);
  }
}

void find_edges(const OverlapSearch& search, const SurfaceMotion& motion, const ContactHistory& history,
                std::optional<MissedContact>& deepest) {
  std::set<std::pair<std::int64_t, std::int64_t>> held;
  const auto a = to_host(history.edges.a), b = to_host(history.edges.b);
  for (int r = 0; r < history.edges.count; ++r) held.insert({a(r), b(r)});
  const auto x = to_host(motion.x);
  const std::vector<EdgeTopology>& edges = search.share.edges;
  for (const EdgePenetration& p : search.finder.find_edge_penetrations(motion)) {
    if (held.count({p.a, p.b}) > 0 || !(p.size > 0)) continue;
    const auto edge = std::lower_bound(edges.begin(), edges.end(), p.a,
                                       [](const EdgeTopology& e, std::int64_t number) { return e.number < number; });
    const auto place = static_cast<std::size_t>(edge - edges.begin());
    MissedContact found{p.depth / p.size, p.depth, edge->ends[0], true, -1, -1, MissedWay::across_edge, {}};
    for (int k = 0; k < 3; ++k) found.x[k] = x(search.share.edge_ends[place][0], k);
    take(found, deepest);
  }
}

/// Marks of an edge on this rank.
constexpr int is_held = 1, began_inside = 2;

/// Marks the edges of all ranks: is_held where this rank has a record of the edge or of an end, began_inside.
std::vector<int> find_known(const OverlapSearch& search, const ContactHistory& history, const KnownContact& known,
                            const std::vector<SunkenEdge>& edges) {
  std::set<std::int64_t> held;
  const auto a = to_host(history.edges.a), b = to_host(history.edges.b);
  for (int r = 0; r < history.edges.count; ++r) held.insert({a(r), b(r)});
  const auto face = to_host(history.face);
  const std::vector<std::int64_t>& numbers = search.share.nodes.numbers;
  std::vector<int> flags;
  for (const SunkenEdge& edge : edges) {
    int flag = held.count(edge.edge) > 0 ? is_held : 0;
    for (const std::int64_t end : edge.ends) {
      if (std::binary_search(known.inside.begin(), known.inside.end(), end)) flag |= began_inside;
      const auto place = std::lower_bound(numbers.begin(), numbers.end(), end);
      if (place == numbers.end() || *place != end) continue;
      if (has_face(face, static_cast<int>(place - numbers.begin()))) flag |= is_held;
    }
    flags.push_back(flag);
  }
  return flags;
}

/// The deepest of edges of all ranks that is not known.
std::optional<MissedContact> find_deepest(const OverlapSearch& search, const ContactHistory& history,
                                          const KnownContact& known, const std::vector<SunkenEdge>& edges,
                                          MissedWay way) {
  std::optional<MissedContact> deepest;
  std::vector<int> flags = find_known(search, history, known, edges), inside;
  for (int& flag : flags) {
    inside.push_back(flag & began_inside);
    flag &= is_held;
  }
  all_reduce(search.ranks, Reduce::largest, flags);
  all_reduce(search.ranks, Reduce::largest, inside);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const SunkenEdge& edge = edges[e];
    const bool may_be_held = known.holds_deep && flags[e] != 0 && edge.ratio() <= contact_limits::history_depth;
    if (inside[e] != 0 || may_be_held) continue;
    take({edge.ratio(), edge.depth, edge.ends[0], true, edge.part, edge.other, way, {edge.x[0], edge.x[1], edge.x[2]}},
         deepest);
  }
  return deepest;
}

}  // namespace

MissedEdge find_missed_edge(const OverlapSearch& search, const Rows3<const double>& x, const ContactHistory& history,
                            const KnownContact& known) {
  const SunkenEdges sunken = find_sunken_edges(search.ranks, search.share, x, least_ratio);
  const std::vector<SunkenEdge> edges = gather_items(search.ranks, sunken.found);
  return {find_deepest(search, history, known, edges, MissedWay::inside), sunken.tests};
}

std::optional<MissedContact> find_missed_piercing(const OverlapSearch& search, const ContactHistory& history,
                                                  const KnownContact& known, const std::vector<PiercingEdge>& found) {
  std::vector<SunkenEdge> edges;
  for (const PiercingEdge& piercing : found)
    if (piercing.body != piercing.in || piercing.edge.ratio() > least_own_ratio) edges.push_back(piercing.edge);
  return find_deepest(search, history, known, edges, MissedWay::through);
}

LookedAt find_watched(const OverlapSearch& search, const SurfaceMotion& motion, const ContactHistory& history,
                      const KnownContact& known) {
  const OwnedContactNodes& nodes = search.share.nodes;
  BoxTree boxes(list_part_boxes(search, motion, known));
  const auto face = to_host(history.face);
  const auto x = to_host(motion.x);
  std::vector<char> watched(nodes.numbers.size(), 0);
  int any = 0;
  for (std::size_t n = 0; n < watched.size(); ++n) {
    if (!is_unknown(nodes, n, face, known)) continue;
    HostBox place;
    place.add(load_row(x, nodes.mesh_nodes[n]));
    boxes.visit_meeting(place, [&](int part) {
      if (part != nodes.parts[n]) watched[n] = 1;
    });
    any = std::max(any, static_cast<int>(watched[n]));
  }
  all_reduce(search.ranks, Reduce::largest, any);
  const bool has_edges = search.share.total_edges > 0 && !known.has_shells() && !search.share.has_beams;
  return {std::move(watched), any != 0, has_edges};
}

std::optional<MissedContact> find_missed_contact(const OverlapSearch& search, const SurfaceMotion& motion,
                                                 const ContactHistory& history, const LookedAt& at,
                                                 const KnownContact& known) {
  search.search_everywhere(motion);
  std::optional<MissedContact> deepest;
  if (at.has_nodes) find_nodes(search, motion, *at.nodes, known, deepest);
  if (at.has_edges) find_edges(search, motion, history, deepest);
  std::vector<MissedContact> own;
  if (deepest) own.push_back(*deepest);
  deepest.reset();
  for (const MissedContact& found : gather_items(search.ranks, own)) take(found, deepest);
  return deepest;
}

std::string describe_missed_contact(const MissedContact& missed, const Mesh& mesh, std::int64_t id) {
  const auto name = [&](int part) {
    return part < 0 ? std::string() : fmt::format(" part '{}'", mesh.parts[static_cast<std::size_t>(part)].name);
  };
  const bool is_own = missed.way == MissedWay::through && missed.part == missed.other;
  const std::string of = name(missed.part), other = is_own ? " its own part" : name(missed.other);
  const std::string what = !missed.is_edge ? fmt::format("node {} of{} lies", id, of)
                           : missed.way == MissedWay::across_edge
                               ? fmt::format("an edge at node {} crosses another by", id)
                           : missed.way == MissedWay::through ? fmt::format("an edge of{} at node {} has gone", of, id)
                                                              : fmt::format("an edge of{} at node {} lies", of, id);
  const std::string where = missed.way == MissedWay::inside    ? " inside" + other
                            : missed.way == MissedWay::through ? " through" + other
                                                               : "";
  return fmt::format(
      "{} {:.3g} ({:.2g} of an element){} at ({:.6g}, {:.6g}, {:.6g}) and no contact holds it (it came there "
      "where no check saw it, or another contact pushed it in): refine the coarser surface there",
      what, missed.depth, missed.ratio, where, missed.x[0], missed.x[1], missed.x[2]);
}

}  // namespace percuss
