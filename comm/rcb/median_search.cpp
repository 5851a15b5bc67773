#include "comm/rcb/median_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "kernels/core/host_copy.hpp"

namespace percuss {

namespace {

/// A bracket that shrinks by less than this factor is probed at quantiles of its points instead of evenly.
constexpr std::int64_t least_shrinking = 4;

constexpr int samples_of_rank = 16;
constexpr int samples_of_all = 1024;

/// floor(weight * lower_ranks / ranks) without overflow.
std::int64_t find_lower_share(std::int64_t weight, int lower_ranks, int ranks) {
  return weight / ranks * lower_ranks + weight % ranks * lower_ranks / ranks;
}

/// The first n entries on the host.
template <class View>
auto copy_to_host(const View& view, int n) {
  return to_host(Kokkos::subview(view, std::make_pair(0, n)));
}

KeyList make_sorted_list(const CandidateKeys& candidates, int n) {
  const auto keys = copy_to_host(candidates.keys, n);
  const auto weights = copy_to_host(candidates.weights, n);
  KeyList list;
  std::vector<int> ascending(static_cast<std::size_t>(n));
  std::iota(ascending.begin(), ascending.end(), 0);
  std::sort(ascending.begin(), ascending.end(), [&](int a, int b) { return keys(a) < keys(b); });
  for (const int i : ascending) {
    list.keys[list.count] = keys(i);
    list.weights[list.count++] = weights(i);
  }
  return list;
}

}  // namespace

void KeyList::merge(const KeyList& other) {
  KeyList merged;
  int mine = 0, theirs = 0;
  while (mine < count || theirs < other.count) {
    const bool take_mine = theirs == other.count || (mine < count && keys[mine] < other.keys[theirs]);
    merged.keys[merged.count] = take_mine ? keys[mine] : other.keys[theirs];
    merged.weights[merged.count++] = take_mine ? weights[mine] : other.weights[theirs];
    ++(take_mine ? mine : theirs);
  }
  *this = merged;
}

/// One search under way.
struct MedianSearch::Progress {
  const ExecSpace& space;
  const Communicator& group;
  Bracket bracket;
  AxisPoints points;
  CandidateKeys candidates;          // this rank's share of the bracket...
  bool has_candidates = false;       // ... else it is all of its points
  int n = 0;                         // of the share
  std::int64_t previous_points = 0;  // of the bracket before the last round; 0: no round yet
  double spacing = 0;
  int rounds = 1;  // the survey's
};

GroupSurvey MedianSearch::survey(const ExecSpace& space, const Communicator& group, const RcbPoints& points,
                                 const Cut& previous) {
  GroupSurvey result;
  result.previous = previous;
  result.axis = previous.axis;
  if (is_made(previous)) result.probes = probe_around(previous);
  result.survey = counter_.survey(space, AxisPoints{points, result.axis}, points.count(), result.probes);
  reduce_survey_(group, result.survey);
  for (const BinCount& bin : result.survey.counts.bins) {
    result.points += bin.points;
    result.weight += bin.weight;
  }
  return result;
}

// Takes this rank's share of the bin that the cut is in.
void MedianSearch::narrow_to_bin(Progress& progress, const ProbeCounts& counts) {
  int bin = 0;
  progress.previous_points = progress.bracket.points;
  progress.bracket = narrow(progress.bracket, counts, bin);
  const int n = counter_.count_of(bin);
  progress.candidates = progress.has_candidates
                            ? counter_.take_bin(progress.space, progress.candidates, progress.n, bin)
                            : counter_.take_bin(progress.space, progress.points, progress.n, bin);
  progress.has_candidates = true;
  progress.n = n;
  const double spacing = measure_spacing(counts, bin);
  if (spacing > 0) progress.spacing = spacing;
}

void MedianSearch::count_round(Progress& progress, const Probes& probes) {
  ProbeCounts counts = progress.has_candidates ? counter_.count(progress.space, progress.candidates, progress.n, probes)
                                               : counter_.count(progress.space, progress.points, progress.n, probes);
  reduce_counts_(progress.group, counts);
  ++progress.rounds;
  narrow_to_bin(progress, counts);
}

Probes MedianSearch::choose_probes(Progress& progress) {
  const Bracket& bracket = progress.bracket;
  const bool is_tied = bracket.lowest.coordinate == bracket.highest.coordinate && !bracket.keys_are_exact;
  const bool is_slow = progress.previous_points > 0 && bracket.points * least_shrinking > progress.previous_points;
  if (!is_tied && !is_slow) return probe_evenly(bracket);
  ++progress.rounds;
  return probe_quantiles(gather_samples(progress), bracket);
}

std::vector<KeySample> MedianSearch::gather_samples(Progress& progress) {
  const int ranks = progress.group.size();
  const int wanted = std::clamp(samples_of_all / ranks, 1, samples_of_rank);
  std::vector<KeySample> mine(static_cast<std::size_t>(wanted));
  if (!progress.has_candidates) take_all(progress);
  const int taken = std::min(wanted, progress.n);
  const auto keys = copy_to_host(progress.candidates.keys, progress.n);
  const auto weights = copy_to_host(progress.candidates.weights, progress.n);
  for (int s = 0; s < taken; ++s) {
    auto place = static_cast<int>((2 * s + 1) * static_cast<std::int64_t>(progress.n) / (2 * taken));
    // The lowest key divides nothing.
    if (keys(place) == progress.bracket.lowest && progress.n > 1) place = place > 0 ? place - 1 : 1;
    mine[static_cast<std::size_t>(s)] = {keys(place), weights(place) * static_cast<double>(progress.n) / taken};
  }
  std::vector<KeySample> all(static_cast<std::size_t>(wanted) * static_cast<std::size_t>(ranks));
  const int bytes = wanted * static_cast<int>(sizeof(KeySample));
  wait_mpi(
      [&] { return MPI_Allgather(mine.data(), bytes, MPI_BYTE, all.data(), bytes, MPI_BYTE, progress.group.handle()); },
      "MPI_Allgather");
  all.erase(std::remove_if(all.begin(), all.end(), [](const KeySample& sample) { return sample.weight <= 0; }),
            all.end());
  return all;
}

void MedianSearch::take_all(Progress& progress) {
  counter_.count(progress.space, progress.points, progress.n, Probes{});
  progress.candidates = counter_.take_bin(progress.space, progress.points, progress.n, 0);
  progress.has_candidates = true;
}

// Gathers the keys that are left and passes the target's weight among them.
void MedianSearch::pick_gathered(Progress& progress) {
  if (!progress.has_candidates) take_all(progress);
  KeyList list = make_sorted_list(progress.candidates, progress.n);
  gather_keys_(progress.group, list);
  ++progress.rounds;
  Bracket& bracket = progress.bracket;
  int cut = 0;
  while (bracket.target >= list.weights[cut]) bracket.target -= list.weights[cut++];
  bracket.lowest = bracket.highest = list.keys[cut];
}

FoundCut MedianSearch::find_cut(const ExecSpace& space, const Communicator& group, const RcbPoints& points,
                                const GroupSurvey& survey, int axis, int lower_ranks) {
  FoundCut found;
  found.cut.axis = axis;
  if (survey.weight == 0) return found;

  const Cut& previous = survey.previous;
  const bool has_guess = is_made(previous) && previous.axis == axis;
  const std::int64_t target = find_lower_share(survey.weight, lower_ranks, group.size());
  const CoordinateKey lowest{survey.survey.lowest[axis], first_key.id},
      highest{survey.survey.highest[axis], last_key.id};
  Progress progress{
      space, group, {lowest, highest, false, survey.points, survey.weight, target}, AxisPoints{points, axis}, {}};
  Bracket& bracket = progress.bracket;
  progress.n = points.count();
  if (has_guess) {
    progress.spacing = previous.spacing;
    narrow_to_bin(progress, survey.survey.counts);
  }
  while (!find_at_ends(bracket) && bracket.points > gathered_keys) count_round(progress, choose_probes(progress));
  if (!find_at_ends(bracket)) pick_gathered(progress);

  Cut& cut = found.cut;
  cut.key = bracket.lowest;
  cut.lower_end = cut.upper_begin = restore_coordinate(cut.key.coordinate);
  cut.spacing = progress.spacing;
  if (has_guess) {
    const double travel = std::abs(cut.lower_end - restore_coordinate(previous.key.coordinate));
    cut.travel = std::max(travel, previous.travel / 2);
  }
  found.lower_weight = target - bracket.target;
  found.rounds = progress.rounds;
  return found;
}

}  // namespace percuss
