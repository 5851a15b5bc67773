#include "src/contact/overlap/missed_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

constexpr double least_ratio = 0.1;  // of an element

bool is_deeper(const MissedContact& a, const MissedContact& b) {
  return a.ratio != b.ratio ? a.ratio > b.ratio : a.node < b.node;
}

void take(const MissedContact& found, std::optional<MissedContact>& deepest) {
  if (found.ratio > least_ratio && (!deepest || is_deeper(found, *deepest))) deepest = found;
}

void find_nodes(const OverlapSearch& search, const SurfaceMotion& motion, const ContactHistory& history,
                const KnownContact& known, std::optional<MissedContact>& deepest) {
  const auto face = to_host(history.face);
  const auto x = to_host(motion.x);
  const OwnedContactNodes& nodes = search.share.nodes;
  for (const Penetration& p : search.finder.find_penetrations(motion)) {
    const auto n = static_cast<std::size_t>(p.node);
    const int first = contact_limits::max_touches * p.node;
    bool is_held = false;
    for (int k = 0; k < contact_limits::max_touches; ++k) is_held = is_held || face(first + k) >= 0;
    if (is_held || !(p.size > 0) || nodes.parts[n] == p.part || known.is_of_shells(nodes.parts[n]) ||
        known.is_of_shells(p.part) || std::binary_search(known.inside.begin(), known.inside.end(), nodes.numbers[n]))
      continue;
    MissedContact found{p.depth / p.size, p.depth, nodes.numbers[n], false, nodes.parts[n], p.part, {}};
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
    MissedContact found{p.depth / p.size, p.depth, edge->ends[0], true, -1, -1, {}};
    for (int k = 0; k < 3; ++k) found.x[k] = x(search.share.edge_ends[place][0], k);
    take(found, deepest);
  }
}

}  // namespace

std::optional<MissedContact> find_missed_contact(const OverlapSearch& search, const SurfaceMotion& motion,
                                                 const ContactHistory& history, const KnownContact& known) {
  search.search_everywhere(motion);
  std::optional<MissedContact> deepest;
  find_nodes(search, motion, history, known, deepest);
  if (search.share.total_edges > 0 && !known.has_shells() && !search.share.has_beams)
    find_edges(search, motion, history, deepest);
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
  const std::string what = missed.is_edge ? fmt::format("an edge at node {} crosses another by", id)
                                          : fmt::format("node {} of{} lies", id, name(missed.part));
  return fmt::format(
      "{} {:.3g} ({:.2g} of an element){} at ({:.6g}, {:.6g}, {:.6g}) and is not in contact (it came there "
      "where no check saw it, or another contact pushed it in): refine the coarser surface there",
      what, missed.depth, missed.ratio, missed.is_edge ? "" : " inside" + name(missed.other), missed.x[0], missed.x[1],
      missed.x[2]);
}

}  // namespace percuss
