#include "comm/rcb/probing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss {

namespace {

constexpr std::int64_t lowest_id = std::numeric_limits<std::int64_t>::min();

/// All points from this coordinate on.
CoordinateKey probe_at(double coordinate) { return {order_coordinate(coordinate), lowest_id}; }

void sort(Probes& probes) { std::sort(std::begin(probes.keys), std::end(probes.keys)); }

}  // namespace

Probes probe_around(const Cut& previous) {
  constexpr int steps = probe_count / 2;
  constexpr double least_ratio = 4, reach_of_travel = 4;
  // Between q and 4 q from the old cut lie 3 q / spacing points: let them be three quarters of what is gathered.
  constexpr double points_in_step = 0.75 * gathered_keys / (least_ratio - 1);
  const double center = restore_coordinate(previous.key.coordinate);
  const double smallest = std::abs(center) * std::numeric_limits<double>::epsilon();
  double step = std::max(points_in_step * previous.spacing, smallest);
  double ratio = least_ratio;
  if (step > 0) ratio = std::max(ratio, std::pow(reach_of_travel * previous.travel / step, 1.0 / (steps - 1)));
  Probes probes;
  probes.keys[0] = previous.key;
  for (int k = 1; k < probe_count; k += 2) {
    probes.keys[k] = probe_at(center - step);
    probes.keys[k + 1] = probe_at(center + step);
    step *= ratio;
  }
  sort(probes);
  return probes;
}

Probes probe_evenly(const Bracket& bracket) {
  Probes probes;
  const double low = restore_coordinate(bracket.lowest.coordinate),
               high = restore_coordinate(bracket.highest.coordinate);
  const auto ids = static_cast<std::uint64_t>(bracket.highest.id) - static_cast<std::uint64_t>(bracket.lowest.id);
  for (int k = 0; k < probe_count; ++k) {
    const double share = (k + 1.0) / bin_count;
    if (bracket.lowest.coordinate < bracket.highest.coordinate) {
      probes.keys[k] = probe_at((1 - share) * low + share * high);
    } else {
      const auto offset = static_cast<std::uint64_t>(share * static_cast<double>(ids)) + 1;
      probes.keys[k] = {bracket.lowest.coordinate,
                        static_cast<std::int64_t>(static_cast<std::uint64_t>(bracket.lowest.id) + offset)};
    }
  }
  return probes;
}

Probes probe_quantiles(std::vector<KeySample> samples, const Bracket& bracket) {
  std::sort(samples.begin(), samples.end(), [](const KeySample& a, const KeySample& b) { return a.key < b.key; });
  double total = 0, passed = 0;
  for (const KeySample& sample : samples) total += sample.weight;
  Probes probes;
  int k = 0;
  for (const KeySample& sample : samples) {
    passed += sample.weight;
    while (k < probe_count - 1 && passed * probe_count > (k + 1) * total) probes.keys[k++] = sample.key;
  }
  probes.keys[probe_count - 1] = bracket.highest;
  sort(probes);
  return probes;
}

Bracket narrow(const Bracket& bracket, const ProbeCounts& counts, int& bin) {
  Bracket narrower;
  narrower.target = bracket.target;
  bin = 0;
  while (narrower.target >= counts.bins[bin].weight) narrower.target -= counts.bins[bin++].weight;
  const BinCount& count = counts.bins[bin];
  narrower.lowest = count.lowest;
  narrower.highest = count.highest;
  narrower.points = count.points;
  narrower.weight = count.weight;
  return narrower;
}

double measure_spacing(const ProbeCounts& counts, int bin) {
  constexpr std::int64_t enough_points = 2 * gathered_keys;
  CoordinateKey lowest = counts.bins[bin].lowest, highest = counts.bins[bin].highest;
  std::int64_t points = counts.bins[bin].points;
  for (int distance = 1; distance < bin_count; ++distance) {
    if (points >= enough_points && lowest.coordinate < highest.coordinate) break;
    for (const int neighbour : {bin - distance, bin + distance}) {
      if (neighbour < 0 || neighbour >= bin_count) continue;
      lowest = std::min(lowest, counts.bins[neighbour].lowest);
      highest = std::max(highest, counts.bins[neighbour].highest);
      points += counts.bins[neighbour].points;
    }
  }
  return (restore_coordinate(highest.coordinate) - restore_coordinate(lowest.coordinate)) / static_cast<double>(points);
}

// Every weight is at least 1: nothing but the lowest point can meet a target of 0, and where all weights are 1 nothing
// but the highest can meet the highest target.
bool find_at_ends(Bracket& bracket) {
  if (!bracket.keys_are_exact) return false;
  if (bracket.target == 0) bracket.highest = bracket.lowest;
  if (bracket.target == bracket.weight - 1 && bracket.weight == bracket.points) {
    bracket.lowest = bracket.highest;
    bracket.target = 0;
  }
  return bracket.lowest == bracket.highest;
}

}  // namespace percuss
