#include "src/contact/surface/fold_watch.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/index_lists.hpp"
#include "kernels/core/small_space.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {
namespace {

/// Shape of a side, as the angle at an edge needs it.
struct SideShape {
  Point3 inward{}, normal{};
};

KOKKOS_INLINE_FUNCTION SideShape find_shape(const Rows3<const double>& x, const WatchedSide& side) {
  const Point3 origin = load_row(x, side.ends[0]);
  const Point3 along = load_row(x, side.ends[1]) - origin;
  SideShape shape;
  shape.inward = find_inward(Point3{}, along, load_row(x, side.wings[0]) - origin, load_row(x, side.wings[1]) - origin);
  shape.normal = static_cast<double>(side.turn) * cross(along, shape.inward);
  return shape;
}

/// Whether an edge is no longer what it was, sharp or smooth.
KOKKOS_INLINE_FUNCTION FoldChange find_change(const SideShape& a, const SideShape& b, const FoldRule& rule) {
  const double level = -dot(a.inward, b.inward);
  const bool is_convex = rule.is_solid == 0 || dot(a.normal, b.inward) < 0;
  if (rule.is_fold != 0) return !is_convex || level > rule.smooth ? FoldChange::slow : FoldChange::none;
  if (!is_convex || !(level < rule.sharp)) return FoldChange::none;
  return level < rule.fast ? FoldChange::fast : FoldChange::slow;
}

/// Whether an edge is none and stays none, by more than round-off: nearly all are, and this takes no roots.
KOKKOS_INLINE_FUNCTION bool is_surely_smooth(const Rows3<const double>& x, const WatchedEdge& edge) {
  constexpr double slack = 1 + 1e-6;
  const Point3 origin = load_row(x, edge.side.ends[0]), along = load_row(x, edge.side.ends[1]) - origin;
  const double square = dot(along, along);
  const auto find_long_inward = [&](const WatchedSide& side) {
    const Point3 across = load_row(x, side.wings[0]) - origin + (load_row(x, side.wings[1]) - origin - along);
    return square * across - dot(across, along) * along;
  };
  const Point3 a = find_long_inward(edge.side), b = find_long_inward(edge.other);
  const double level = -dot(a, b), sharp = edge.rule.sharp;
  return edge.rule.is_fold == 0 && level > 0 && level * level > slack * sharp * sharp * dot(a, a) * dot(b, b);
}

/// start: angle at the start, negative where it is concave.
FoldRule make_rule(const FoldAngles& angles, double start, bool is_solid, bool is_fold) {
  constexpr double degree = 0.017453292519943295, feature = 30 * degree;  // contact_limits::feature
  const double sharp = std::clamp(start + angles.bend * degree, angles.least * degree, feature);
  return {is_solid ? 1 : 0, is_fold ? 1 : 0, std::cos(sharp), std::cos(sharp + angles.fast * degree),
          std::cos(sharp - angles.slack * degree)};
}

FoldRule make_rule(EdgeKind kind, const EdgeSide& a, const EdgeSide& b, bool is_fold) {
  const double level = -dot(a.inward, b.inward), angle = std::acos(std::clamp(level, -1.0, 1.0));
  const bool is_solid = kind == EdgeKind::solid;
  return make_rule(fold_angles, is_solid && dot(a.normal, b.inward) > 0 ? -angle : angle, is_solid, is_fold);
}

WatchedSide make_watched(const SurfaceShare& share, const SharedSides::OwnSide& own) {
  const std::array<int, 4>& nodes = share.face_corners[at(own.face)];
  const auto& corners = share.faces[at(own.face)].corners;
  const std::size_t p = at(own.corner), q = (p + 1) % 4;
  const int wing_p = nodes[find_previous_corner(corners, p)], wing_q = nodes[find_next_corner(corners, q)];
  if (corners[q] < corners[p]) return {{nodes[q], nodes[p]}, {wing_q, wing_p}, -1};
  return {{nodes[p], nodes[q]}, {wing_p, wing_q}, 1};
}

/// A diagonal of a face of solids: a ridge once the face has warped.
WatchedEdge make_diagonal(const SurfaceShare& share, std::size_t face, std::size_t which) {
  const std::array<int, 4>& nodes = share.face_corners[face];
  const FaceDiagonal diagonal = find_diagonal(share.faces[face].corners, which);
  const auto make_side = [&](std::size_t wing, int turn) {
    return WatchedSide{{nodes[diagonal.ends[0]], nodes[diagonal.ends[1]]}, {nodes[wing], nodes[wing]}, turn};
  };
  return {make_side(diagonal.wings[0], -diagonal.turn), make_side(diagonal.wings[1], diagonal.turn),
          make_rule(ridge_angles, 0, true, false)};
}

/// [classes] whether it may touch any.
std::vector<char> find_touching(const SurfaceShare& share) {
  const auto friction = to_host(share.pair_friction);
  const std::size_t n = at(share.num_classes);
  std::vector<char> touches(n, 0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (friction(a * n + b) >= 0) touches[a] = touches[b] = 1;
  return touches;
}

}  // namespace

/// The edges that are no features by their angle at the start.
void FoldWatch::list_edges(const SurfaceShare& share) {
  has_edges_ = true;
  own_.clear();
  shared_.clear();
  const SharedSides shared(chunked_, share.faces, share.face_corners, ranks_);
  const std::vector<char> touches = find_touching(share);
  std::vector<WatchedSide> sides;
  for (const SharedSides::OwnSide& own : shared.sent()) sides.push_back(make_watched(share, own));
  sent_to_ = shared.sent_to();
  const int num_own = static_cast<int>(shared.own().size());
  const auto place_side = [&](int item) {  // received sides have negative numbers until all own ones are known
    if (item >= num_own) return num_own - 1 - item;
    sides.push_back(make_watched(share, shared.own()[at(item)]));
    return static_cast<int>(sides.size()) - 1;
  };
  std::vector<EdgeSide> around;
  const auto list = [&](EdgeKind kind, const EdgeSide& a, const EdgeSide& b) {
    const bool may_touch = touches[at(a.surface_class)] != 0 || touches[at(b.surface_class)] != 0;
    if (!may_touch || is_feature(kind, a, b)) return;
    const EdgeEnds ends{a.ends[0], a.ends[1]};
    const FoldRule rule = make_rule(kind, a, b, is_fold(ends));
    if (a.item < num_own && b.item < num_own)
      own_.push_back(
          {make_watched(share, shared.own()[at(a.item)]), make_watched(share, shared.own()[at(b.item)]), rule});
    else
      shared_.push_back({ends, place_side(a.item), place_side(b.item), rule});
  };
  for (std::size_t node = 0; node < shared.node_count(); ++node)
    shared.visit_edges(node, around,
                       [&](const EdgeSide* first, const EdgeSide* last) { visit_meetings(first, last, list); });
  list_diagonals(share, touches);
  const int num_sides = static_cast<int>(sides.size());
  for (SharedEdge& edge : shared_) {
    if (edge.side < 0) edge.side = num_sides - 1 - edge.side;
    if (edge.other < 0) edge.other = num_sides - 1 - edge.other;
  }
  own_edges_ = to_view("contact::watched_edges", own_);
  sides_ = to_view("contact::watched_sides", sides);
}

/// Lists the diagonals of faces that edges of other parts may cross.
void FoldWatch::list_diagonals(const SurfaceShare& share, const std::vector<char>& touches) {
  if (chunked_.mesh.parts.size() < 2) return;
  for (std::size_t f = 0; f < share.faces.size(); ++f) {
    const FaceTopology& face = share.faces[f];
    if (!has_diagonals(face) || touches[at(face.surface_class)] == 0) continue;
    for (std::size_t which = 0; which < 2; ++which) {
      const auto [p, q] = find_diagonal(face.corners, which).ends;
      own_.push_back(make_diagonal(share, f, which));
      own_.back().rule.is_fold = is_fold({face.corners[p], face.corners[q]}) ? 1 : 0;
    }
  }
}

/// Appends the edges that have changed; returns how many have at least by so much.
std::int64_t FoldWatch::look_at_own(const Rows3<const double>& x, FoldChange least,
                                    std::vector<EdgeEnds>& changed) const {
  const Array<WatchedEdge> edges = own_edges_;
  const int count = static_cast<int>(own_.size());
  const auto has_changed = [edges, x] KOKKOS_FUNCTION(int i, FoldChange by) {
    const WatchedEdge& e = edges(i);
    if (is_surely_smooth(x, e)) return false;  // requested changes only
    return find_change(find_shape(x, e.side), find_shape(x, e.other), e.rule) >= by;
  };
  std::int64_t num_due = 0;
  parallel_reduce(
      "contact::watch_folds", RangeOf(ExecSpace(), 0, count),
      KOKKOS_LAMBDA(int i, std::int64_t& sum) { sum += has_changed(i, least) ? 1 : 0; }, num_due);
  if (num_due == 0 && ranks_.size() == 1) return 0;
  const Array<int> list("contact::changed_folds", at(count));
  const int num_changed = list_where(
      ExecSpace(), count, [has_changed] KOKKOS_FUNCTION(int i) { return has_changed(i, FoldChange::slow); }, list);
  const auto places = to_host(list);
  for (std::size_t i = 0; i < at(num_changed); ++i) {
    const int* const ends = own_[at(places(i))].side.ends;
    changed.push_back({chunked_.mesh.node_numbers[at(ends[0])], chunked_.mesh.node_numbers[at(ends[1])]});
  }
  return num_due;
}

std::int64_t FoldWatch::look_at_shared(const Rows3<const double>& x, FoldChange least,
                                       std::vector<EdgeEnds>& changed) const {
  const Array<const WatchedSide> sides = sides_;
  const Array<SideShape> shapes("contact::side_shapes", sides.extent(0));
  parallel_for(
      "contact::watch_sides", RangeOf(ExecSpace(), 0, static_cast<int>(sides.extent(0))),
      KOKKOS_LAMBDA(int i) { shapes(i) = find_shape(x, sides(i)); });
  const auto host = to_host(shapes);
  std::vector<SideShape> all(host.data(), host.data() + host.extent(0));
  const std::vector<SideShape> sent(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(sent_to_.size()));
  const std::vector<SideShape> received = ItemExchange(ranks_).send(sent_to_, sent);
  all.insert(all.end(), received.begin(), received.end());
  std::int64_t num_due = 0;
  for (const SharedEdge& edge : shared_) {
    const FoldChange by = find_change(all[at(edge.side)], all[at(edge.other)], edge.rule);
    if (by >= FoldChange::slow) changed.push_back(edge.ends);
    num_due += by >= least ? 1 : 0;
  }
  return num_due;
}

/// Updates the folds: a changed edge that was a fold is one no longer, any other is one now.
void FoldWatch::note(std::vector<EdgeEnds> changed) {
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  std::vector<EdgeEnds> folds;
  std::set_symmetric_difference(folds_.begin(), folds_.end(), changed.begin(), changed.end(),
                                std::back_inserter(folds));
  folds_ = std::move(folds);
  note_own(changed);
  for (SharedEdge& edge : shared_) edge.rule.is_fold = is_fold(edge.ends) ? 1 : 0;
}

/// changed: ascending.
void FoldWatch::note_own(const std::vector<EdgeEnds>& changed) {
  const std::vector<std::int64_t>& numbers = chunked_.mesh.node_numbers;
  std::vector<char> is_lower_of_changed(numbers.size(), 0);
  for (const EdgeEnds& ends : changed)
    if (const int node = find_number(numbers, ends.lower); node >= 0) is_lower_of_changed[at(node)] = 1;
  std::vector<int> places, values;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const int* const ends = own_[i].side.ends;
    if (is_lower_of_changed[at(ends[0])] == 0) continue;
    own_[i].rule.is_fold = is_fold({numbers[at(ends[0])], numbers[at(ends[1])]}) ? 1 : 0;
    places.push_back(static_cast<int>(i));
    values.push_back(own_[i].rule.is_fold);
  }
  const Array<const int> place = to_view("contact::noted_edges", places), value = to_view("contact::noted", values);
  const Array<WatchedEdge> edges = own_edges_;
  parallel_for(
      "contact::note_folds", RangeOf(ExecSpace(), 0, static_cast<int>(places.size())),
      KOKKOS_LAMBDA(int i) { edges(place(i)).rule.is_fold = value(i); });
}

bool FoldWatch::look(const SurfaceShare& share, const Rows3<const double>& x, long step) {
  if (share.total_searched_faces == 0) return false;
  if (!has_edges_) list_edges(share);
  std::vector<EdgeEnds> changed;
  const FoldChange least = step % slow_fold_steps == 0 ? FoldChange::slow : FoldChange::fast;
  std::int64_t num_due = look_at_own(x, least, changed);
  if (ranks_.size() > 1) num_due += look_at_shared(x, least, changed);
  all_reduce(ranks_, Reduce::sum, num_due);
  if (num_due == 0) return false;
  note(gather_items(ranks_, changed));
  return true;
}

/// Archives the folds by their lower nodes. A run may begin without.
bool FoldWatch::archive(CheckpointArchive& archive, const SurfaceShare& share) {
  auto total = static_cast<std::int64_t>(folds_.size());
  if (!is_active_ || (archive.is_loading() ? !archive.has_number("contact/folds/count") : total == 0)) return false;
  archive.number("contact/folds/count", total);
  const std::vector<std::int64_t>& nodes = share.nodes.numbers;
  std::vector<std::int64_t> counts, lower, upper;
  for (const std::int64_t node : nodes) {
    const auto first = std::lower_bound(folds_.begin(), folds_.end(), EdgeEnds{node, -1});
    auto last = first;
    while (last != folds_.end() && last->lower == node) upper.push_back((last++)->upper);
    counts.push_back(last - first);
  }
  const ChunkRows rows = find_rows_of_nodes(chunked_, nodes);
  archive.rows("contact/folds/of_nodes", rows, 1, std::span<std::int64_t>(counts));
  constexpr std::int64_t most = std::int64_t{1} << 20;  // of a node
  std::vector<std::int64_t> of_chunks;
  std::size_t next = 0;
  for (const std::int64_t num_rows : rows.counts) {
    std::int64_t sum = 0;
    for (std::int64_t i = 0; i < num_rows; ++i, ++next) {
      const std::int64_t count = counts[rows.places.empty() ? next : at(rows.places[next])];
      sum = sum < 0 || count < 0 || count > most ? -1 : sum + count;
    }
    of_chunks.push_back(sum);
  }
  archive.expect_rows("contact/folds/ends", of_chunks, 1);
  for (std::size_t n = 0; n < nodes.size(); ++n) lower.insert(lower.end(), at(counts[n]), nodes[n]);
  upper.resize(lower.size());
  archive.rows("contact/folds/ends", find_rows_of_nodes(chunked_, lower), 1, std::span<std::int64_t>(upper));
  if (!archive.is_loading()) return false;
  std::vector<EdgeEnds> own;
  for (std::size_t i = 0; i < lower.size(); ++i) own.push_back({lower[i], upper[i]});
  folds_ = gather_items(ranks_, own);
  std::sort(folds_.begin(), folds_.end());
  return true;
}

}  // namespace percuss
