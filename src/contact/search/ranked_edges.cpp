#include "src/contact/search/ranked_edges.hpp"

#include <algorithm>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/search/contact_finder.hpp"
#include "src/contact/search/pair_limit.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/index.hpp"

namespace percuss {
/// An edge as it is sent to a rank that its box reaches.
struct RankedEdges::EdgeRecord {
  EdgeTopology edge;
  double box[6];
  double ends[6];  // places at n
  bool is_owned = false;
};

RankedEdges::RankedEdges(const ContactRanks& ranks, const SurfaceShare& share, const ContactDeck& deck)
    : ranks_(ranks), share_(share), check_(ranks, share, deck.reuse_search) {
  scratch_.points.method = find_method(deck.search);
  if (share.total_edges == 0) return;
  exchange_.emplace(ranks.ranks);
  data_.emplace(ranks.ranks);
  divided_edges_ = share.edges;
  points_ = list_edge_points(divided_edges_, to_rows("contact::edge_ends", share.edge_ends), {}).points;
  boxes_ = Boxes("contact::edge_boxes", share.edges.size());
}

/// The rank in whose part the middle of each edge lies.
void RankedEdges::find_owners(const SurfaceMotion& motion) {
  std::vector<std::int64_t> ids;
  for (const EdgeTopology& edge : share_.edges) ids.push_back(edge.number);
  const Rows3<double> middles("contact::edge_middles", ids.size());
  const Array<int> owners("contact::edge_owners", ids.size());
  const Rows2<const int> ends = points_.ends;
  const SurfaceMotion m = motion;
  parallel_for(
      "contact::edge_middles", RangeOf(ExecSpace(), 0, static_cast<int>(ids.size())),
      KOKKOS_LAMBDA(int e) { store_row(middles, e, 0.5 * (load_row(m.x, ends(e, 0)) + load_row(m.x, ends(e, 1)))); });
  percuss::find_owners(ExecSpace(), parts_->bisection().tree(), middles, to_view("contact::edge_ids", ids), owners);
  ExecSpace().fence();
  const auto host = to_host(owners);
  owners_.clear();
  for (std::size_t e = 0; e < host.extent(0); ++e) owners_.push_back(parts_->find_rank(host(e)));
}

/// Sends owners the points of their edges, so that they know which boxes must reach them.
void RankedEdges::send_points_to_owners(const SurfaceMotion& motion, const ContactDecomposition& decomposition) {
  if (!data_) return;
  if (divide_again(points_.ends, motion.x, share_.edge_piece, divided_edges_))
    points_ = list_edge_points(divided_edges_, points_.ends, {}).points;
  half_piece_ = find_half_piece_of_all(motion);
  const AssignedParts& parts = decomposition.parts();
  if (!parts_ || parts_->rank_of_part() != parts.rank_of_part()) parts_.emplace(ranks_.ranks, parts.rank_of_part());
  if (decomposition.was_rebalanced() || !knows_owners_) {
    parts_->bisection().restore(parts.bisection().cuts());
    find_owners(motion);
    knows_owners_ = true;
  }
  const Rows3<double> places("contact::edge_places", at(points_.num_points));
  place_edge_points(ExecSpace(), points_, motion.x, places);
  ExecSpace().fence();
  const auto host = to_host(places);
  std::vector<int> to;
  std::vector<std::array<double, 3>> points;
  for (std::size_t e = 0; e < share_.edges.size(); ++e) {
    for (int k = 0; k < divided_edges_[e].pieces; ++k) {
      const std::size_t i = points.size();
      points.push_back({host(i, 0), host(i, 1), host(i, 2)});
      to.push_back(owners_[e]);
    }
  }
  const SendOrder order = order_by_destination(to);
  const std::vector<std::array<double, 3>> own =
      data_->exchange(exchange_->plan(order.to), ItemExchange::arrange(order, points));
  parts_->bisection().refit(ExecSpace(), to_rows("contact::owned_edge_points", own));
}

Point3 RankedEdges::find_half_piece_of_all(const SurfaceMotion& motion) const {
  const Point3 own = find_half_piece(ExecSpace(), points_, motion.x);
  double half[3] = {own.x, own.y, own.z};
  all_reduce(ranks_.ranks, Reduce::largest, half);
  return {half[0], half[1], half[2]};
}

/// The ranks whose points the boxes of edges may hold.
void RankedEdges::find_reached_ranks(const SurfaceMotion& motion, double margin) {
  if (!data_) return;
  const Point3 widened = find_edge_margin(half_piece_, margin, 2 * share_.largest_offset);
  bound_edges(ExecSpace(), points_.ends, motion, widened, boxes_);
  ExecSpace().fence();
  reached_ = list_reached_parts(ranks_.ranks, parts_->bisection().tree(), boxes_, static_cast<int>(share_.edges.size()),
                                widened.x);
}

void RankedEdges::send_overlapping_edges(const SurfaceMotion& motion) {
  static_assert(sizeof(EdgeRecord) == record_bytes);
  if (!data_) return;
  const auto boxes = to_host(boxes_);
  const auto x = to_host(motion.x);
  const auto box = to_host(reached_.box), part = to_host(reached_.part);
  std::vector<int> to;
  std::vector<EdgeRecord> records;
  for (std::size_t i = 0; i < box.extent(0); ++i) {
    const auto e = at(box(i));
    EdgeRecord record{};
    record.edge = divided_edges_[e];
    to.push_back(parts_->find_rank(part(i)));
    record.is_owned = to.back() == owners_[e];
    for (std::size_t k = 0; k < 6; ++k) {
      record.box[k] = boxes(e, k);
      record.ends[k] = x(at(share_.edge_ends[e][k / 3]), k % 3);
    }
    records.push_back(record);
  }
  const SendOrder order = order_by_destination(to);
  std::vector<EdgeRecord> received = data_->exchange(exchange_->plan(order.to), ItemExchange::arrange(order, records));
  std::sort(received.begin(), received.end(),
            [](const EdgeRecord& a, const EdgeRecord& b) { return a.edge.number < b.edge.number; });
  edges_.clear();
  is_owned_.clear();
  places_.clear();
  edge_boxes_ = Boxes("contact::received_boxes", received.size());
  const auto host = Kokkos::create_mirror_view(edge_boxes_);
  for (const EdgeRecord& record : received) {
    for (std::size_t k = 0; k < 6; ++k) host(edges_.size(), k) = record.box[k];
    edges_.push_back(record.edge);
    is_owned_.push_back(record.is_owned ? 1 : 0);
    places_.push_back(std::to_array(record.ends));
  }
  copy_values(edge_boxes_, host);
}

/// Pairs among the edges that reached this rank, of which it has the points of A.
std::int64_t RankedEdges::find_pairs_here(const Point3& slack, std::int64_t limit) {
  EdgeSpace& space = check_.space();
  std::vector<std::int64_t> numbers;
  for (const EdgeTopology& edge : edges_) {
    numbers.insert(numbers.end(), std::begin(edge.ends), std::end(edge.ends));
    numbers.insert(numbers.end(), std::begin(edge.wings), std::end(edge.wings));
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  const NumberMap rows(numbers);
  std::vector<std::array<double, 3>> x(numbers.size());
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 3; ++k) x[at(rows.find(edges_[e].ends[i]))][k] = places_[e][3 * i + k];
  // Wings have numbers here but no places, which the check alone reads.
  set_edge_surface(make_edge_surface(
                       edges_, [&](std::int64_t number) { return rows.find(number); }, share_),
                   space);
  const EdgePointLists lists = list_edge_points(edges_, space.surface.ends, is_owned_);
  const Rows3<double> places("contact::edge_places", at(lists.points.num_points));
  const Rows3<const double> ends = to_rows("contact::edge_end_places", x);
  std::int64_t hits = 0;
  run_where_it_pays(static_cast<int>(edges_.size()) / 2, [&](const auto& where) {
    place_edge_points(where, lists.points, ends, places);
    const EdgeQuery query{lists.names, places, ends, edge_boxes_, slack};
    hits = find_edge_pairs(where, space.surface, query, limit, scratch_, space.pairs);
  });
  return hits;
}

std::int64_t RankedEdges::find_candidates(double margin) {
  if (!data_) return 0;
  const std::int64_t limit = find_edge_pair_limit(share_);
  const std::int64_t hits = find_pairs_here(find_edge_slack(half_piece_, margin), std::min(limit, most_indexed_pairs));
  std::int64_t sums[3] = {hits, check_.space().pairs.num_pairs, hits > most_indexed_pairs ? 1 : 0};
  all_reduce(ranks_.ranks, Reduce::sum, sums);
  refuse_too_many_pairs(sums[0], limit, margin);
  refuse_crowded_ranks(sums[2]);
  check_.take_pairs(edges_, sums[1], *exchange_, *data_);
  return sums[1];
}

}  // namespace percuss
