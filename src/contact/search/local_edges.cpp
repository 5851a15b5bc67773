#include "src/contact/search/local_edges.hpp"

#include <algorithm>

#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

LocalEdges::LocalEdges(const SurfaceShare& share, const ContactDeck& deck) : share_(share) {
  scratch_.points.method = find_method(deck.search);
  space_.keeps_still = deck.reuse_search;
  if (share.edges.empty()) return;
  const auto find_row = [&](std::int64_t number) {
    return share.nodes.mesh_nodes[static_cast<std::size_t>(find_number(share.nodes.numbers, number))];
  };
  set_edge_surface(make_edge_surface(share.edges, find_row, share), space_);
  divided_edges_ = share.edges;
  points_ = list_edge_points(divided_edges_, space_.surface.ends, {});
  boxes_ = Boxes("contact::edge_boxes", share.edges.size());
}

std::int64_t LocalEdges::find_candidates(const SurfaceMotion& motion, double margin) {
  if (share_.edges.empty()) return 0;
  const std::int64_t limit = std::min(find_edge_pair_limit(share_), most_indexed_pairs);
  if (divide_again(space_.surface.ends, motion.x, share_.edge_piece, divided_edges_))
    points_ = list_edge_points(divided_edges_, space_.surface.ends, {});
  reserve(places_, points_.points.num_points);
  std::int64_t hits = 0;
  run_where_it_pays(static_cast<int>(share_.edges.size()) / 2, [&](const auto& space) {
    const EdgePoints& points = points_.points;
    place_edge_points(space, points, motion.x, places_);
    const Point3 half = find_half_piece(space, points, motion.x);
    bound_edges(space, points.ends, motion, find_edge_margin(half, margin, 2 * share_.largest_offset), boxes_);
    const EdgeQuery query{points_.names, places_, motion.x, boxes_, find_edge_slack(half, margin)};
    hits = find_edge_pairs(space, space_.surface, query, limit, scratch_, space_.pairs);
  });
  refuse_too_many_pairs(hits, limit, margin);
  space_.near.forget();
  return space_.pairs.num_pairs;
}

}  // namespace percuss
