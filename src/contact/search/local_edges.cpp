#include "src/contact/search/local_edges.hpp"

#include <algorithm>

#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

LocalEdges::LocalEdges(const SurfaceShare& share, const ContactDeck& deck) : share_(share) {
  scratch_.points.method = find_method(deck.search);
  space_.keeps_still = deck.reuse_search;
  lists_near_ = deck.reuse_search && share.largest_offset > 0;
  if (share.edges.empty()) return;
  // A table, because the faces around an edge request its nodes again and again.
  const OwnedContactNodes& nodes = share.nodes;
  std::vector<int> rows(static_cast<std::size_t>(nodes.numbers.back() - nodes.numbers.front()) + 1, -1);
  for (std::size_t n = 0; n < nodes.numbers.size(); ++n)
    rows[static_cast<std::size_t>(nodes.numbers[n] - nodes.numbers.front())] = nodes.mesh_nodes[n];
  const auto find_row = [&](std::int64_t number) {
    return rows[static_cast<std::size_t>(number - nodes.numbers.front())];
  };
  use(make_edge_surface(share.edges, find_row, share));
}

LocalEdges::LocalEdges(const LocalEdges& of_run, bool looks) : share_(of_run.share_) {
  scratch_.points.method = of_run.scratch_.points.method;
  if (looks && !share_.edges.empty()) use(of_run.space_.surface);
}

void LocalEdges::use(const EdgeSurface& surface) {
  set_edge_surface(surface, space_);
  divided_edges_ = share_.edges;
  points_ = list_edge_points(divided_edges_, surface.ends, {});
  boxes_ = Boxes("contact::edge_boxes", share_.edges.size());
}

void LocalEdges::take_over(const LocalEdges& before) {
  cells_.take_over(before.cells_);
  if (share_.edges.empty() || scratch_.points.method != SearchMethod::blocks) return;
  scratch_.points.blocks = before.scratch_.points.blocks;
  identify_edges();
}

/// Identifies edges by numbers. A number may name another edge of the same lower node later: it lies there, too.
void LocalEdges::identify_edges() {
  constexpr std::int64_t most_pieces = 1024;  // count_pieces()
  std::vector<std::int64_t> points, edges;
  for (const EdgeTopology& edge : divided_edges_) {
    edges.push_back(edge.number);
    for (int piece = 0; piece < edge.pieces; ++piece) points.push_back(most_pieces * edge.number + piece);
  }
  identify(points, edges, scratch_.points.blocks);
}

std::int64_t LocalEdges::find_candidates(const SurfaceMotion& motion, double margin) {
  if (divided_edges_.empty()) return 0;
  const std::int64_t limit = std::min(find_edge_pair_limit(share_), most_indexed_pairs);
  if (divide_again(space_.surface.ends, motion.x, share_.edge_piece, divided_edges_)) {
    points_ = list_edge_points(divided_edges_, space_.surface.ends, {});
    if (scratch_.points.method == SearchMethod::blocks) identify_edges();
  }
  reserve(places_, points_.points.num_points);
  std::int64_t hits = 0;
  run_where_it_pays(static_cast<int>(share_.edges.size()) / 2, [&](const auto& space) {
    const EdgePoints& points = points_.points;
    place_edge_points(space, points, motion.x, places_);
    const Point3 half = find_half_piece(space, points, motion.x);
    bound_edges(space, points.ends, motion, find_edge_margin(half, margin, 2 * share_.largest_offset), boxes_);
    const EdgeQuery query{points_.names, places_, motion.x, boxes_, find_edge_slack(half, margin)};
    hits = find_edge_pairs(space, space_.surface, query, limit, scratch_, all_);
  });
  refuse_too_many_pairs(hits, limit, margin);
  space_.pairs = all_;
  space_.near.forget();
  cells_.forget();
  return all_.num_pairs;
}

int LocalEdges::check(const SurfaceMotion& motion, const EdgeHistory& history) {
  if (lists_near_ && all_.num_pairs > 0) {
    cells_.update(EdgeCheckInputs{space_.surface, motion, {}, history}, all_);
    space_.pairs = cells_.choose(all_);
  }
  return check_edge_pairs(motion, history, space_);
}

}  // namespace percuss
