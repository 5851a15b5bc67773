#include <algorithm>

#include "src/contact/host_copy.hpp"
#include "src/contact/stage_memory.hpp"

namespace percuss {
namespace {

template <class View>
auto mirror(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// Margin of an audit's boxes in mean edges: with the reach of the check, nodes half a face deep are found.
constexpr double audit_margin = 0.3;

/// Penetrations at the places of a motion without dt, by a search of its own.
PenetrationTable look_everywhere(const ContactSurface& surface, const SurfaceMotion& motion, SearchMemory& memory) {
  PenetrationTable table;
  const Array<int> no_history("contact::no_history", static_cast<std::size_t>(3 * surface.num_nodes));
  Kokkos::deep_copy(no_history, -1);
  double margin = 0;
  run_where_it_pays(surface.num_nodes / 10,
                    [&](const auto& space) { margin = audit_margin * find_mean_edge(space, surface, motion.x); });
  search_pairs(surface, motion, margin, no_history, memory);
  run_where_it_pays(memory.candidates.num_pairs, [&](const auto& space) {
    update_faces(space, surface, motion, memory.candidates, memory.faces);
    find_penetrations(space, surface, motion, memory.candidates, memory.faces, table);
  });
  return table;
}

void note(StartOverlap& found, double depth, int node, bool held) {
  ++found.nodes;
  if (!held) ++found.too_deep;
  if (depth <= found.deepest) return;
  found.deepest = depth;
  found.deepest_node = node;
}

/// Walls and their pairs on the host.
struct HostWalls {
  HostWalls(const ContactSurface& surface, const WallPairs& pairs, const Rows3<const double>& places)
      : walls(mirror(pairs.walls)),
        wall(mirror(pairs.wall)),
        node(mirror(pairs.node)),
        nodes(mirror(surface.nodes)),
        size(mirror(pairs.size)),
        x(mirror(places)) {}

  int count() const { return static_cast<int>(wall.extent(0)); }
  double depth(int p) const {
    const ContactWall& w = walls(wall(p));
    return -dot(w.normal, load_row(x, nodes(node(p))) - w.point);
  }

  decltype(mirror(WallPairs().walls)) walls;
  decltype(mirror(WallPairs().wall)) wall, node, nodes;
  decltype(mirror(WallPairs().size)) size;
  decltype(mirror(Rows3<const double>())) x;
};

}  // namespace

ContactHistory make_history(const ContactSurface& surface, const WallPairs& walls) {
  const std::size_t faces = static_cast<std::size_t>(contact_limits::max_touches * surface.num_nodes);
  const std::size_t records = faces + walls.node.extent(0);
  ContactHistory history{Array<int>("contact::history_face", faces), Rows3<double>("contact::history_impulse", records),
                         Rows3<double>("contact::history_slip", records),
                         Array<double>("contact::history_reference", records)};
  Kokkos::deep_copy(history.face, -1);
  return history;
}

StartOverlap seed_history(const ContactSurface& surface, const WallPairs& walls, const SurfaceMotion& motion,
                          ContactDeck::Overlap overlap, const ContactHistory& history) {
  SearchMemory memory(surface);
  const PenetrationTable table = look_everywhere(surface, motion, memory);
  const auto depth = mirror(table.depth);
  const auto face = mirror(table.face), history_face = mirror(history.face);
  const auto size = mirror(memory.faces.size), reference = mirror(history.reference);
  const bool accept = overlap == ContactDeck::Overlap::accept;
  StartOverlap found;
  for (int n = 0; n < surface.num_nodes; ++n) {
    if (face(n) < 0 || depth(n) <= contact_limits::overlap * size(face(n))) continue;
    const bool held = depth(n) <= contact_limits::history_depth * size(face(n));
    note(found, depth(n), n, held);
    if (!held) continue;
    history_face(contact_limits::max_touches * n) = face(n);
    reference(contact_limits::max_touches * n) = accept ? depth(n) : 0;
  }
  const HostWalls host(surface, walls, motion.x);
  const int first = contact_limits::max_touches * surface.num_nodes;
  for (int p = 0; p < host.count(); ++p) {
    if (host.depth(p) <= contact_limits::overlap * host.size(p)) continue;
    note(found, host.depth(p), host.node(p), true);
    reference(first + p) = accept ? host.depth(p) : 0;
  }
  Kokkos::deep_copy(history.face, history_face);
  Kokkos::deep_copy(history.reference, reference);
  return found;
}

double find_deepest_penetration(const ContactSurface& surface, const WallPairs& walls, const Rows3<const double>& x) {
  double deepest = 0;
  if (surface.searched_faces.extent(0) > 0) {
    SearchMemory memory(surface);
    const auto ratio = mirror(look_everywhere(surface, {x, x, 0}, memory).ratio);
    for (int n = 0; n < surface.num_nodes; ++n) deepest = std::max(deepest, ratio(n));
  }
  const HostWalls host(surface, walls, x);
  for (int p = 0; p < host.count(); ++p) deepest = std::max(deepest, host.depth(p) / host.size(p));
  return deepest;
}

}  // namespace percuss
