#include "src/contact/search/reuse_bound.hpp"

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "kernels/contact/search/capture_boxes.hpp"

namespace percuss {
namespace {

/// Margin of capture boxes in mean face edges: searches less often against more pairs to check.
constexpr double margin_edges = 0.5;

/// Travel of any node that uses up the margin: node and face may each move by it, and the reach of the check grows with
/// the edges of a face, 2 sqrt(3) * contact_limits::capture < 1 times as much.
constexpr double travels_in_margin = 3;

/// Near pairs are listed again after a share of the travel between two searches, or sooner if a step goes a short way:
/// fewer listings against more pairs. No list is made if the remaining travel to the next search is below the least
/// share, or if it would serve fewer steps than the least.
constexpr double near_share = 0.25, least_near_share = 0.06, near_steps = 12, least_near_steps = 3;

}  // namespace

ReuseBound::ReuseBound(const Communicator& ranks, const SurfaceShare& share, bool enabled)
    : ranks_(ranks),
      share_(share),
      enabled_(enabled),
      origin_("contact::search_origin", static_cast<std::size_t>(share.nodes.count())),
      velocity_("contact::search_velocity", static_cast<std::size_t>(share.nodes.count())),
      near_origin_("contact::near_origin", share.watched_list.extent(0)),
      first_origin_("contact::first_origin", share.watched_list.extent(0)) {}

void ReuseBound::redefine() {
  valid_ = false;
  margin_ = dt_ = near_travel_ = first_travel_ = 0;
  origin_ = Rows3<double>("contact::search_origin", static_cast<std::size_t>(share_.nodes.count()));
  velocity_ = Rows3<double>("contact::search_velocity", static_cast<std::size_t>(share_.nodes.count()));
  near_origin_ = Rows3<double>("contact::near_origin", share_.watched_list.extent(0));
  first_origin_ = Rows3<double>("contact::first_origin", share_.watched_list.extent(0));
}

double ReuseBound::find_largest(double value) const {
  all_reduce(ranks_, Reduce::largest, value);
  return value;
}

double ReuseBound::find_travel_here(const SurfaceMotion& motion) const {
  double travel = 0;
  run_where_it_pays(share_.nodes.count() / 10,
                    [&](const auto& space) { travel = find_largest_travel(space, share_.node_list, motion, origin_); });
  return travel;
}

double ReuseBound::find_step_here(const SurfaceMotion& motion) const {
  double step = 0;
  run_where_it_pays(share_.nodes.count() / 10,
                    [&](const auto& space) { step = find_largest_step(space, share_.watched_list, motion); });
  return step;
}

double ReuseBound::find_way(const SurfaceMotion& motion) const {
  return ways_ ? ways_->step : find_largest(find_step_here(motion));
}

void ReuseBound::enter_step(const SurfaceMotion& motion) {
  ways_.reset();
  if (!enabled_ || !valid_ || ranks_.size() == 1) return;
  double ways[4] = {near_travel_ > 0 ? find_distance_here(motion, near_origin_) : 0, find_travel_here(motion),
                    first_travel_ > 0 ? find_distance_here(motion, first_origin_) : 0, find_step_here(motion)};
  all_reduce(ranks_, Reduce::largest, ways);
  ways_ = {ways[0], ways[1], ways[2], ways[3]};
}

bool ReuseBound::covers(const SurfaceMotion& motion) {
  if (!enabled_ || !valid_) return false;
  travel_ = ways_ ? ways_->travel : find_largest(find_travel_here(motion));
  return travels_in_margin * travel_ <= margin_;
}

double ReuseBound::restart(const SurfaceMotion& motion, bool wide) {
  SearchSums sums;
  run_where_it_pays(share_.nodes.count() / 10, [&](const auto& space) {
    sums.move = find_largest_move(space, share_.node_list, motion);
    store_places(space, share_.node_list, motion.x, origin_);
    store_places(space, share_.node_list, motion.v, velocity_);
    space.fence();
  });
  // Without reuse the boxes only need what a node moves in this step.
  const bool has_margin = (enabled_ || wide) && share_.may_touch();
  if (has_margin) sums.edges = sum_edges_here(motion);
  if (ranks_.size() > 1) sum_(ranks_, sums);
  margin_ = sums.move;
  if (has_margin) margin_ += margin_edges * find_mean(sums.edges);
  dt_ = motion.dt;
  valid_ = true;
  travel_ = near_travel_ = first_travel_ = 0;
  return margin_;
}

double ReuseBound::find_distance_here(const SurfaceMotion& motion, const Rows3<double>& origin) const {
  double distance = 0;
  run_where_it_pays(share_.nodes.count() / 10, [&](const auto& space) {
    distance = find_largest_distance(space, share_.watched_list, motion, origin);
  });
  return distance;
}

void ReuseBound::store_watched(const SurfaceMotion& motion, const Rows3<double>& origin) const {
  run_where_it_pays(share_.nodes.count() / 10, [&](const auto& space) {
    store_places(space, share_.watched_list, motion.x, origin);
    space.fence();
  });
}

bool ReuseBound::covers_near(const SurfaceMotion& motion) const {
  if (!(near_travel_ > 0)) return false;
  return (ways_ ? ways_->near : find_largest(find_distance_here(motion, near_origin_))) <= near_travel_;
}

/// Near pairs are those that a travel of near_travel_ can bring within reach, of those that the way to the next search
/// can, of all candidate pairs: each list is right as long as its travel is not used up, and the first is used up
/// first.
NearWay ReuseBound::restart_near(const SurfaceMotion& motion) {
  const double whole = margin_ / travels_in_margin, left = 0.999 * (whole - travel_);  // so that covers() holds, too
  const bool is_worth_it = enabled_ && left >= least_near_share * whole;
  near_travel_ = 0;
  if (!is_worth_it && first_travel_ == 0) return {};
  store_watched(motion, near_origin_);
  double gone[2] = {ways_ ? ways_->step : find_step_here(motion), 0};
  if (first_travel_ > 0) gone[1] = ways_ ? ways_->first : find_distance_here(motion, first_origin_);
  if (!ways_) all_reduce(ranks_, Reduce::largest, gone);
  const double step = gone[0], travel = std::min(near_share * whole, left);
  if (is_worth_it && travel >= least_near_steps * step)
    near_travel_ = step > 0 ? std::min(travel, near_steps * step) : travel;
  NearWay way;
  way.near = near_travel_;
  // The way of contact nodes to the next search is bounded; those behind faces have to keep to it.
  way.keeps_first = first_travel_ > 0 && gone[1] + near_travel_ <= first_travel_;
  if (!way.keeps_first) first_travel_ = 0;
  if (near_travel_ > 0 && !way.keeps_first) {
    // By component, and from the place of the last search.
    way.search = first_travel_ = std::sqrt(3.0) * (whole + travel_);
    store_watched(motion, first_origin_);
  }
  return way;
}

PlannedLists plan_near_lists(double margin, double steps_per_search) {
  const double whole = margin / travels_in_margin, steps = std::min(near_share * steps_per_search, near_steps);
  if (steps < least_near_steps) return {};
  return {{0.999 * whole * steps / steps_per_search, std::sqrt(3.0) * whole, false}, steps};
}

void ReuseBound::archive(CheckpointArchive& archive, const ChunkRows& contact_nodes) {
  archive.integer("contact/search/valid", valid_);
  archive.number("contact/search/margin", margin_);
  archive.number("contact/search/dt", dt_);
  archive.rows("contact/search/origin", contact_nodes, 3, origin_);
  archive.rows("contact/search/velocity", contact_nodes, 3, velocity_);
  if (archive.is_loading()) travel_ = near_travel_ = first_travel_ = 0;
}

ExactSum ReuseBound::sum_edges_here(const SurfaceMotion& motion) const {
  ExactSum sum;
  run_where_it_pays(static_cast<int>(share_.searched_faces.size()) / 10,
                    [&](const auto& space) { sum = sum_shortest_edges(space, share_.corner_list, motion.x); });
  sum.normalize();
  return sum;
}

/// Mean length of an edge, from the sum over all faces; where beams alone touch, that of beams.
double ReuseBound::find_mean(const ExactSum& edges) const {
  if (share_.total_searched_faces == 0) return share_.edge_piece;
  return edges.round() / static_cast<double>(share_.total_searched_faces);
}

double ReuseBound::find_mean_edge(const SurfaceMotion& motion) const {
  if (!share_.may_touch()) return 0;
  SearchSums sums{0, sum_edges_here(motion)};
  if (ranks_.size() > 1) sum_(ranks_, sums);
  return find_mean(sums.edges);
}

}  // namespace percuss
