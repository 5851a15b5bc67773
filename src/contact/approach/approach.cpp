#include "src/contact/approach/approach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr double lowest_number = std::numeric_limits<double>::lowest();

/// [owned contact nodes] which group each belongs to, as a number that all ranks know it by; -1: none.
std::vector<std::int64_t> list_keys(const SurfaceShare& share) {
  std::vector<std::int64_t> keys(share.nodes.sizes.size(), -1);
  for (std::size_t n = 0; n < keys.size(); ++n) {
    const FaceTopology* const around = share.find_around(n);
    if (around != nullptr) keys[n] = std::int64_t{around->body} * share.num_classes + share.nodes.classes[n];
  }
  return keys;
}

/// Largest difference of two velocities of two ranges.
double find_range(double slow_a, double fast_a, double slow_b, double fast_b) {
  return std::max(std::abs(fast_a - slow_b), std::abs(fast_b - slow_a));
}

}  // namespace

std::string describe_approach(const Approach& approach, const Mesh& mesh) {
  const std::string& part = mesh.parts[at(approach.part)].name;
  if (approach.other < 0)
    return fmt::format("the approach of part '{}' and walls.{} at {:.4g}", part, -1 - approach.other, approach.speed);
  const std::string& other = mesh.parts[at(approach.other)].name;
  const std::string who = approach.part == approach.other ? fmt::format("bodies of part '{}'", part)
                                                          : fmt::format("parts '{}' and '{}'", part, other);
  return fmt::format("the approach of {} at {:.4g}", who, approach.speed);
}

/// A run may begin without it.
void archive_approach(CheckpointArchive& archive, Approach& approach) {
  if (!archive.has_number("contact/approach/step")) return;
  archive.number_or_infinity("contact/approach/step", approach.step);
  archive.number("contact/approach/travel_step", approach.travel_step);
  archive.number("contact/approach/speed", approach.speed);
  archive.integer("contact/approach/part", approach.part);
  archive.integer("contact/approach/other", approach.other);
}

ApproachWatch::ApproachWatch(const Communicator& ranks, const SurfaceShare& share) : ranks_(ranks), share_(share) {
  redefine();
}

void ApproachWatch::redefine() {
  has_groups_ = false;
  least_size_ = std::numeric_limits<double>::infinity();
  const OwnedContactNodes& nodes = share_.nodes;
  for (std::size_t n = 0; n < nodes.sizes.size(); ++n) {
    if (share_.find_around(n) != nullptr) least_size_ = std::min(least_size_, nodes.sizes[n]);
  }
  all_reduce(ranks_, Reduce::least, least_size_);
}

/// Groups of all ranks: those of any node here or elsewhere, in the order of their keys.
void ApproachWatch::find_groups() {
  if (has_groups_) return;
  has_groups_ = true;
  const std::vector<std::int64_t> keys = list_keys(share_);
  std::int64_t most = -1;
  for (const std::int64_t key : keys) most = std::max(most, key);
  all_reduce(ranks_, Reduce::largest, most);
  std::vector<std::int32_t> places(at(most + 1), 0);
  for (const std::int64_t key : keys)
    if (key >= 0) places[at(key)] = 1;
  all_reduce(ranks_, Reduce::largest, places);
  groups_.clear();
  for (std::size_t key = 0; key < places.size(); ++key) {
    if (places[key] == 0) continue;
    places[key] = static_cast<std::int32_t>(groups_.size());
    const auto number = static_cast<int>(key);
    groups_.push_back({number % share_.num_classes, number / share_.num_classes});
  }
  node_groups_.assign(keys.size(), -1);
  for (std::size_t n = 0; n < keys.size(); ++n)
    if (keys[n] >= 0) node_groups_[n] = places[at(keys[n])];
  measure_groups();
  const auto friction = to_host(share_.pair_friction);
  frictions_.assign(friction.extent(0), 0);
  for (std::size_t i = 0; i < frictions_.size(); ++i) frictions_[i] = friction(i);
}

/// Measures what stays constant as long as the surface does.
void ApproachWatch::measure_groups() {
  const OwnedContactNodes& nodes = share_.nodes;
  std::vector<double> values(3 * groups_.size(), lowest_number);  // -size, offset, part
  for (std::size_t n = 0; n < node_groups_.size(); ++n) {
    if (node_groups_[n] < 0) continue;
    double* const of = &values[3 * at(node_groups_[n])];
    of[0] = std::max(of[0], -nodes.sizes[n]);
    of[1] = std::max({of[1], share_.find_around(n)->offset, share_.find_radius(n)});
    of[2] = std::max(of[2], static_cast<double>(nodes.parts[n]));
  }
  all_reduce(ranks_, Reduce::largest, values);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].size = -values[3 * g];
    groups_[g].offset = values[3 * g + 1];
    groups_[g].part = static_cast<int>(values[3 * g + 2]);
  }
}

/// Boxes at the end of the motion, and ranges of its velocities.
void ApproachWatch::move_groups(const SurfaceMotion& motion) {
  constexpr std::size_t count = 12;  // -low, high, -slowest, fastest
  std::vector<double> values(count * groups_.size(), lowest_number);
  const auto x = to_host(motion.x), v = to_host(motion.v);
  for (std::size_t n = 0; n < node_groups_.size(); ++n) {
    if (node_groups_[n] < 0) continue;
    double* const of = &values[count * at(node_groups_[n])];
    const std::size_t node = at(share_.nodes.mesh_nodes[n]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double speed = v(node, k), place = x(node, k) + motion.dt * speed;
      of[k] = std::max(of[k], -place);
      of[3 + k] = std::max(of[3 + k], place);
      of[6 + k] = std::max(of[6 + k], -speed);
      of[9 + k] = std::max(of[9 + k], speed);
    }
  }
  all_reduce(ranks_, Reduce::largest, values);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const double* const of = &values[count * g];
    for (std::size_t k = 0; k < 3; ++k) {
      groups_[g].low[k] = -of[k] - groups_[g].offset;
      groups_[g].high[k] = of[3 + k] + groups_[g].offset;
      groups_[g].slowest[k] = -of[6 + k];
      groups_[g].fastest[k] = of[9 + k];
    }
  }
}

void ApproachWatch::average_velocities(const SurfaceMotion& motion) {
  std::vector<ExactSum> sums(3 * groups_.size());
  std::vector<std::int64_t> counts(groups_.size(), 0);
  const auto v = to_host(motion.v);
  for (std::size_t n = 0; n < node_groups_.size(); ++n) {
    if (node_groups_[n] < 0) continue;
    const std::size_t group = at(node_groups_[n]), node = at(share_.nodes.mesh_nodes[n]);
    ++counts[group];
    for (std::size_t k = 0; k < 3; ++k) sums[3 * group + k].add(v(node, k));
  }
  sum_over_ranks(ranks_, sums);
  all_reduce(ranks_, Reduce::sum, counts);
  for (std::size_t g = 0; g < groups_.size(); ++g)
    for (std::size_t k = 0; k < 3; ++k) groups_[g].mean[k] = sums[3 * g + k].round() / static_cast<double>(counts[g]);
}

bool ApproachWatch::may_touch(const Group& a, const Group& b) const {
  if (a.body == b.body) return false;
  const auto friction = [&](const Group& node, const Group& face) {
    return frictions_[at(node.surface_class) * at(share_.num_classes) + at(face.surface_class)];
  };
  return friction(a, b) >= 0 || friction(b, a) >= 0;
}

Approach ApproachWatch::find_approach(const Group& a, const Group& b, Moment moment) const {
  double entry = 0, range = 0, drift = 0;
  bool is_apart = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_above = b.low[k] > a.high[k];
    const double gap = is_above ? b.low[k] - a.high[k] : a.low[k] - b.high[k];
    const double closing = is_above ? a.fastest[k] - b.slowest[k] : b.fastest[k] - a.slowest[k];
    if (gap > 0 && !(closing > 0)) return {};
    if (gap > 0) entry = std::max(entry, gap / closing);
    is_apart = is_apart || gap > 0;
    range = std::hypot(range, find_range(a.slowest[k], a.fastest[k], b.slowest[k], b.fastest[k]));
    drift = std::hypot(drift, a.mean[k] - b.mean[k]);
  }
  const double speed = is_apart || moment == Moment::start ? range : drift;
  if (!(speed > 0)) return {};
  const double travel_step = approach_share * std::min(a.size, b.size) / speed;
  return {entry + travel_step, travel_step, speed, std::min(a.part, b.part), std::max(a.part, b.part)};
}

/// Shortest approach of all pairs of bodies whose boxes can meet within the horizon [time].
Approach ApproachWatch::find_shortest(double horizon, Moment moment) const {
  const auto reach_low = [&](const Group& g) { return g.low[0] + horizon * std::min(0.0, g.slowest[0]); };
  const auto reach_high = [&](const Group& g) { return g.high[0] + horizon * std::max(0.0, g.fastest[0]); };
  std::vector<std::size_t> order(groups_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return reach_low(groups_[a]) < reach_low(groups_[b]); });
  Approach shortest;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Group& a = groups_[order[i]];
    for (std::size_t j = i + 1; j < order.size() && reach_low(groups_[order[j]]) <= reach_high(a); ++j) {
      if (!may_touch(a, groups_[order[j]])) continue;
      const Approach found = find_approach(a, groups_[order[j]], moment);
      if (found.step < horizon && found.step < shortest.step) shortest = found;
    }
  }
  return shortest;
}

/// A node may move beside another by twice the way that each goes.
bool ApproachWatch::may_limit(double largest_way) const {
  return 2 * most_step_growth * largest_way > approach_share * least_size_;
}

Approach ApproachWatch::look_at_start(const Rows3<const double>& x, const Rows3<const double>& v, double dt) {
  if (!share_.may_touch()) return {};
  find_groups();
  move_groups({x, v, 0});
  return find_shortest(dt, Moment::start);
}

Approach ApproachWatch::look(const SurfaceMotion& motion, double largest_way) {
  if (!may_limit(largest_way)) return {};
  find_groups();
  move_groups(motion);
  average_velocities(motion);
  return find_shortest(most_step_growth * motion.dt, Moment::later);
}

}  // namespace percuss
