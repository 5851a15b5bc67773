#include "src/contact/overlap/start_overlap.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/check/end_pack.hpp"
#include "kernels/contact/rows/row_geometry.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/history/edge_records.hpp"
#include "src/contact/overlap/part_gaps.hpp"

namespace percuss {
namespace {

/// Penetrations of this rank's nodes by a search of its own.
std::vector<Penetration> look_everywhere(const OverlapSearch& search, const SurfaceMotion& motion) {
  if (!search.share.may_touch()) return {};
  search.search_everywhere(motion);
  return search.finder.find_penetrations(motion);
}

/// Adds to the overlap of its two parts.
void add(const PartOverlap& more, std::vector<PartOverlap>& parts) {
  const auto is_before = [](const PartOverlap& a, const PartOverlap& b) {
    return a.part != b.part ? a.part < b.part : a.other < b.other;
  };
  auto place = std::lower_bound(parts.begin(), parts.end(), more, is_before);
  if (place == parts.end() || place->part != more.part || place->other != more.other)
    place = parts.insert(place, {more.part, more.other, 0, 0});
  place->nodes += more.nodes;
  place->deepest = std::max(place->deepest, more.deepest);
}

/// node: number; depth: its part, what it is in, and how deep.
void note(StartOverlap& found, std::int64_t node, const PartOverlap& overlap, bool held) {
  const double depth = overlap.deepest;
  add(overlap, found.parts);
  found.inside.push_back(node);
  ++found.nodes;
  if (!held) ++found.too_deep;
  if (depth < found.deepest || (depth == found.deepest && found.deepest_node >= 0 && node > found.deepest_node)) return;
  found.deepest = depth;
  found.deepest_node = node;
}

/// Walls and their pairs on the host.
struct HostWalls {
  HostWalls(const WallPairs& pairs, const Rows3<const double>& places)
      : walls(to_host(pairs.walls)),
        wall(to_host(pairs.wall)),
        node(to_host(pairs.node)),
        part(to_host(pairs.part)),
        number(to_host(pairs.number)),
        size(to_host(pairs.size)),
        offset(to_host(pairs.offset)),
        x(to_host(places)) {}

  int count() const { return static_cast<int>(wall.extent(0)); }
  double depth(int p) const {
    const ContactWall& w = walls(wall(p));
    const double kept = offset.extent(0) > 0 ? offset(p) : 0;
    const Point3 at = load_row(x, node(p));
    const double depth = kept - find_wall_height(w, at);
    return is_beside(w, at, depth, size(p)) ? std::min(depth, 0.0) : depth;
  }

  /// Whether the node is in a cylinder that ends, too deep to be pushed out.
  bool is_lost(int p) const {
    const ContactWall& w = walls(wall(p));
    if (w.shape != WallShape::cylinder || !(w.size[0] > 0)) return false;
    const Point3 at = load_row(x, node(p));
    const double along = dot(w.along, at - w.point);
    return along >= 0 && along <= w.size[0] && is_beside(w, at, -find_wall_height(w, at), size(p));
  }
  double depth_inside(int p) const { return -find_wall_height(walls(wall(p)), load_row(x, node(p))); }

  decltype(to_host(WallPairs().walls)) walls;
  decltype(to_host(WallPairs().wall)) wall, node, part;
  decltype(to_host(WallPairs().number)) number;
  decltype(to_host(WallPairs().size)) size, offset;
  decltype(to_host(Rows3<const double>())) x;
};

/// The records of a history on the host into which overlap is taken: it is held, and pushed out if the deck says so.
struct SeededRecords {
  explicit SeededRecords(const ContactHistory& history)
      : face(to_host(history.face)), reference(to_host(history.reference)), to_push(to_host(history.to_push)) {}

  void hold(int record, double depth) const {
    reference(record) = depth;
    if (to_push.extent(0) > 0) to_push(record) = depth;
  }
  /// A row measures along its push, and finds more than the distance from the face. All that it finds in its first step
  /// is accepted: it takes the lesser of its own depth and the reference.
  void hold(int record, std::int64_t by_face, double depth, bool is_pushed = true) const {
    // The depth is that of the closest point along the push, cos(angle) of its distance; a row finds 1 / cos of this.
    constexpr double most_of_row = 1 / (least_push_cosine * least_push_cosine);
    face(record) = by_face;
    reference(record) = most_of_row * depth;
    if (is_pushed && to_push.extent(0) > 0) to_push(record) = depth;
  }
  void write_to(const ContactHistory& history) const {
    copy_values(history.face, face);
    copy_values(history.reference, reference);
    copy_values(history.to_push, to_push);
  }

  HostMirror<Array<std::int64_t>> face;
  HostMirror<Array<double>> reference, to_push;
};

bool pushes_out(const ContactHistory& history) { return history.to_push.extent(0) > 0; }

/// Seeds the walls named that act, or all, for records from `first` on.
void seed_walls(const OverlapSearch& search, const SurfaceMotion& motion, const std::vector<char>& only,
                StartOverlap& found, const SeededRecords& records) {
  const HostWalls host(search.walls, motion.x);
  const int first = contact_limits::max_touches * search.share.nodes.count();
  for (int p = 0; p < host.count(); ++p) {
    if (!only.empty() && only[static_cast<std::size_t>(host.wall(p))] == 0) continue;
    if (host.is_lost(p)) add({host.part(p), -1 - host.wall(p), 1, host.depth_inside(p)}, found.lost);
    if (host.depth(p) <= contact_limits::overlap * host.size(p)) continue;
    note(found, host.number(p), {host.part(p), -1 - host.wall(p), 1, host.depth(p)}, true);
    records.hold(first + p, host.depth(p));
  }
}

/// Where a node's record of a face goes that it does not have yet; -1: it has one, or all its records are in use.
int find_free_record(const HostMirror<Array<std::int64_t>>& history_face, const Penetration& p) {
  int free = -1;
  for (int i = contact_limits::max_touches - 1; i >= 0; --i) {
    const int record = contact_limits::max_touches * p.node + i;
    if (history_face(record) == p.face) return -1;
    if (history_face(record) < 0) free = record;
  }
  return free;
}

/// A record of edges by itself.
struct EdgeRecord {
  std::int64_t a, b;
  std::array<double, HeldRecords::value_count> values;
};

/// Sorts records by (a, b); of two of the same edges the first stays.
HeldRecords join_records(std::vector<EdgeRecord>& records) {
  std::stable_sort(records.begin(), records.end(),
                   [](const EdgeRecord& p, const EdgeRecord& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  HeldRecords held;
  for (const EdgeRecord& record : records) {
    if (!held.a.empty() && held.a.back() == record.a && held.b.back() == record.b) continue;
    held.a.push_back(record.a);
    held.b.push_back(record.b);
    held.values.insert(held.values.end(), record.values.begin(), record.values.end());
  }
  return held;
}

/// The counts of all ranks, and the deepest node of any.
void reduce(const Communicator& ranks, StartOverlap& found) {
  std::int64_t counts[3] = {found.nodes, found.too_deep, found.edge_pairs};
  all_reduce(ranks, Reduce::sum, counts);
  const double own = found.deepest;
  double deepest[2] = {found.deepest, found.deepest_edges};
  all_reduce(ranks, Reduce::largest, deepest);
  found.deepest = deepest[0];
  found.deepest_edges = deepest[1];
  constexpr std::int64_t none = std::int64_t{1} << 62;
  std::int64_t node = found.deepest_node >= 0 && own == found.deepest ? found.deepest_node : none;
  all_reduce(ranks, Reduce::least, node);
  std::vector<PartOverlap> all;
  for (const PartOverlap& parts : gather_items(ranks, found.parts)) add(parts, all);
  found.parts = std::move(all);
  all.clear();
  for (const PartOverlap& parts : gather_items(ranks, found.lost)) add(parts, all);
  found.lost = std::move(all);
  found.nodes = counts[0];
  found.too_deep = counts[1];
  found.edge_pairs = counts[2];
  found.deepest_node = node == none ? -1 : node;
}

/// The records that a history holds.
std::vector<EdgeRecord> list_records(const EdgeHistory& history) {
  const HeldRecords held = history.count > 0 ? take_held(history) : HeldRecords{};
  std::vector<EdgeRecord> records;
  for (std::size_t r = 0; r < held.a.size(); ++r) {
    records.push_back({held.a[r], held.b[r], {}});
    std::copy_n(held.values.begin() + static_cast<std::ptrdiff_t>(HeldRecords::value_count * r),
                HeldRecords::value_count, records.back().values.begin());
  }
  return records;
}

/// Records that are there stay. pushes: what is added is to be pushed out.
void add_records(const std::vector<EdgePenetration>& found, bool pushes, EdgeHistory& history) {
  if (found.empty()) return;
  std::vector<EdgeRecord> records = list_records(history);
  for (const EdgePenetration& p : found)
    records.push_back(
        {p.a, p.b, {p.normal.x, p.normal.y, p.normal.z, 0, 0, 0, 0, 0, 0, p.depth, 0, pushes ? p.depth : 0}});
  history = make_edge_history(join_records(records));
}

/// Overlap of edges into an empty history.
void seed_all_edges(const OverlapSearch& search, const std::vector<EdgePenetration>& penetrations, bool pushes,
                    StartOverlap& found, EdgeHistory& history) {
  std::vector<EdgePenetration> held, tied;
  for (const EdgePenetration& p : penetrations) {
    if (p.depth <= contact_limits::overlap * p.size) continue;
    const bool is_tied = search.tied.has_edges(p.a, p.b);
    if (!is_tied) {
      ++found.edge_pairs;
      found.deepest_edges = std::max(found.deepest_edges, p.depth);
    }
    if (p.depth <= p.limit) (is_tied ? tied : held).push_back(p);
  }
  history = {};
  add_records(held, pushes, history);
  add_records(tied, false, history);
}

/// Takes into a history the pairs of edges that it does not have, and that have an end among `nodes`.
void seed_born_edges(const OverlapSearch& search, const SurfaceMotion& motion, bool pushes,
                     const std::vector<std::int64_t>& nodes, StartOverlap& found, EdgeHistory& history) {
  std::vector<std::int64_t> own;
  const auto has = [](const std::vector<std::int64_t>& sorted, std::int64_t n) {
    return std::binary_search(sorted.begin(), sorted.end(), n);
  };
  for (const EdgeTopology& edge : search.share.edges)
    if (has(nodes, edge.ends[0]) || has(nodes, edge.ends[1])) own.push_back(edge.number);
  std::vector<std::int64_t> edges = gather_items(search.ranks, own);
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<std::int64_t, std::int64_t>> known;
  for (const EdgeRecord& record : list_records(history)) known.emplace_back(record.a, record.b);
  std::sort(known.begin(), known.end());
  std::vector<EdgePenetration> born;
  for (const EdgePenetration& p : search.finder.find_edge_penetrations(motion)) {
    if ((!has(edges, p.a) && !has(edges, p.b)) || p.depth <= contact_limits::overlap * p.size) continue;
    if (std::binary_search(known.begin(), known.end(), std::pair(p.a, p.b))) continue;
    ++found.edge_pairs;
    found.deepest_edges = std::max(found.deepest_edges, p.depth);
    if (p.depth <= p.limit) born.push_back(p);
  }
  add_records(born, pushes, history);
}

}  // namespace

double OverlapSearch::find_margin(const SurfaceMotion& motion) const {
  constexpr double margin = 0.3;  // share of a mean edge
  return margin * bound.find_mean_edge(motion);
}

StartOverlap seed_history(const OverlapSearch& search, const SurfaceMotion& motion, ContactHistory& history) {
  const SeededRecords records(history);
  StartOverlap found;
  for (const Penetration& p : look_everywhere(search, motion)) {
    if (p.depth <= contact_limits::overlap * p.size) continue;
    const bool held = p.depth <= p.limit;
    const auto n = static_cast<std::size_t>(p.node);
    const std::int64_t number = search.share.nodes.numbers[n];
    const bool is_tied = search.tied.has_face(number, p.face);
    if (!is_tied) note(found, number, {search.share.nodes.parts[n], p.part, 1, p.depth}, held);
    if (held) records.hold(contact_limits::max_touches * p.node, p.face, p.depth, !is_tied);
  }
  seed_walls(search, motion, {}, found, records);
  if (search.share.may_touch()) {
    seed_all_edges(search, search.finder.find_edge_penetrations(motion), pushes_out(history), found, history.edges);
    found.gaps = gather_gaps(search.ranks, search.finder.find_gaps(motion));
  }
  records.write_to(history);
  reduce(search.ranks, found);
  return found;
}

void complete_gaps(const std::vector<PartGap>& tied, StartOverlap& found) {
  for (const PartGap& gap : tied) add_gap(gap, found.gaps);
  const auto add = [&](int part, int other, double depth) {
    add_gap({std::min(part, other), std::max(part, other), -depth}, found.gaps);
  };
  for (const PartOverlap& overlap : found.parts)
    if (overlap.other >= 0) add(overlap.part, overlap.other, overlap.deepest);
  for (const PartCrossing& crossing : found.crossings)
    if (crossing.contact != PartCrossing::Contact::never) add(crossing.part, crossing.other, crossing.depth);
}

StartOverlap seed_born(const OverlapSearch& search, const SurfaceMotion& motion, const BornContact& born,
                       ContactHistory& history) {
  const auto has = [](const std::vector<std::int64_t>& sorted, std::int64_t number) {
    return std::binary_search(sorted.begin(), sorted.end(), number);
  };
  const SeededRecords records(history);
  const bool has_faces = search.share.may_touch();
  StartOverlap found;
  for (const Penetration& p : has_faces ? search.finder.find_penetrations(motion) : std::vector<Penetration>{}) {
    if (p.depth <= contact_limits::overlap * p.size || !has(born.faces, p.face)) continue;
    const auto n = static_cast<std::size_t>(p.node);
    const int record = find_free_record(records.face, p);
    if (record < 0) continue;  // a contact of another pair that continues
    const bool held = p.depth <= p.limit;
    note(found, search.share.nodes.numbers[n], {search.share.nodes.parts[n], p.part, 1, p.depth}, held);
    if (held) records.hold(record, p.face, p.depth);
  }
  seed_walls(search, motion, born.walls, found, records);
  records.write_to(history);
  if (has_faces) seed_born_edges(search, motion, pushes_out(history), born.nodes, found, history.edges);
  reduce(search.ranks, found);
  return found;
}

void seed_opened(const OverlapSearch& search, const SurfaceMotion& motion, const SurfaceChange& change,
                 ContactHistory& history) {
  if (!search.share.may_touch()) return;
  const auto list_new = [](const std::vector<std::int64_t>& before, const std::vector<std::int64_t>& now) {
    std::vector<std::int64_t> fresh;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(fresh));
    return fresh;
  };
  const std::vector<std::int64_t> nodes = list_new(change.before.nodes, change.now.nodes);
  std::vector<std::int64_t> own_faces = list_new(change.before.faces, change.now.faces);
  own_faces.insert(own_faces.end(), change.released_faces.begin(), change.released_faces.end());
  std::vector<std::int64_t> faces = gather_items(search.ranks, own_faces);
  std::sort(faces.begin(), faces.end());
  const SeededRecords records(history);
  for (const Penetration& p : search.finder.find_penetrations(motion)) {
    const std::int64_t number = search.share.nodes.numbers[static_cast<std::size_t>(p.node)];
    const bool is_new = std::binary_search(faces.begin(), faces.end(), p.face) ||
                        std::binary_search(nodes.begin(), nodes.end(), number) ||
                        std::binary_search(change.released_nodes.begin(), change.released_nodes.end(), number);
    const int record = contact_limits::max_touches * p.node;
    if (!is_new || p.depth <= contact_limits::overlap * p.size || p.depth > p.limit) continue;
    if (records.face(record) >= 0) continue;  // a contact that continues
    records.hold(record, p.face, p.depth);
  }
  records.write_to(history);
}

std::vector<std::int64_t> list_fresh_edges(const EdgeChange& change) {
  struct Known {
    EdgeEnds ends;
    int is_blunt;
    auto operator<=>(const Known&) const = default;
  };
  std::vector<Known> before;
  for (const EdgeTopology& edge : change.before)
    for (int blunt = edge.is_blunt; blunt <= warped_ridge; ++blunt)
      before.push_back({{edge.ends[0], edge.ends[1]}, blunt});
  std::sort(before.begin(), before.end());
  const auto& released = change.released_nodes;
  const auto is_released = [&](std::int64_t node) {
    return std::binary_search(released.begin(), released.end(), node);
  };
  std::vector<std::int64_t> fresh;
  for (const EdgeTopology& edge : change.now)
    if (is_released(edge.ends[0]) || is_released(edge.ends[1]) ||
        !std::binary_search(before.begin(), before.end(), Known{{edge.ends[0], edge.ends[1]}, edge.is_blunt}))
      fresh.push_back(edge.number);
  return fresh;
}

void seed_edges(const OverlapSearch& search, const SurfaceMotion& motion, const EdgeChange& change,
                EdgeHistory& history) {
  if (!search.share.may_touch()) return;
  std::vector<std::int64_t> fresh = gather_items(search.ranks, list_fresh_edges(change));
  std::sort(fresh.begin(), fresh.end());
  const auto is_fresh = [&](std::int64_t number) { return std::binary_search(fresh.begin(), fresh.end(), number); };
  std::vector<EdgePenetration> found = search.finder.find_edge_penetrations(motion);
  std::erase_if(found, [&](const EdgePenetration& p) {
    return (!is_fresh(p.a) && !is_fresh(p.b)) || p.depth <= contact_limits::overlap * p.size || p.depth > p.limit;
  });
  add_records(found, false, history);
}

double find_deepest_penetration(const OverlapSearch& search, const SurfaceMotion& motion) {
  double deepest = 0;
  for (const Penetration& p : look_everywhere(search, motion)) deepest = std::max(deepest, p.ratio);
  if (search.share.may_touch())
    for (const EdgePenetration& p : search.finder.find_edge_penetrations(motion))
      deepest = std::max(deepest, p.depth / p.size);
  const HostWalls host(search.walls, motion.x);
  for (int p = 0; p < host.count(); ++p) deepest = std::max(deepest, host.depth(p) / host.size(p));
  all_reduce(search.ranks, Reduce::largest, deepest);
  return deepest;
}

}  // namespace percuss
