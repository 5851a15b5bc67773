#include "comm/rcb/probe_counts.hpp"

#include <cstddef>
#include <string>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

namespace {

/// Points that one thread counts before its counts are merged with the others'.
constexpr int block_length = 4096;

/// Room for n entries; grows by a quarter more than requested, because counts change from step to step.
template <class View>
void make_room(View& view, const std::string& label, int n) {
  const auto wanted = static_cast<std::size_t>(n);
  if (view.extent(0) < wanted) view = View(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), wanted + wanted / 4);
}

/// Points whose bins are found at once, by loops over arrays that compilers turn into vector code: the loop over the
/// points is the inner one.
constexpr int run_length = 128;

struct Run {
  int first, count;
  std::uint64_t coordinates[run_length];
  std::uint64_t bins[run_length];  // as wide as the coordinates, for the vectors' sake
};

/// Points that lie on a probe's coordinate are before it if their ids are.
template <class Source>
KOKKOS_INLINE_FUNCTION void untie_bins(const Source& source, const Probes& probes, Run& run) {
  for (int i = 0; i < run.count; ++i) {
    std::uint64_t& bin = run.bins[i];
    while (bin > 0 && probes.keys[bin - 1].coordinate == run.coordinates[i] &&
           source.id(run.first + i) < probes.keys[bin - 1].id) {
      --bin;
    }
  }
}

/// Bin of each point: the number of probes that are not after it.
template <class Source>
KOKKOS_INLINE_FUNCTION void find_bins(const Source& source, const Probes& probes, Run& run) {
  for (int i = 0; i < run.count; ++i) {
    run.coordinates[i] = source.coordinate(run.first + i);
    run.bins[i] = 0;
  }
  std::uint64_t ties = 0;
  for (const CoordinateKey& probe : probes.keys) {
    const std::uint64_t coordinate = probe.coordinate;
    for (int i = 0; i < run.count; ++i) run.bins[i] += run.coordinates[i] >= coordinate ? 1 : 0;
    if (probe.id == first_key.id) continue;  // no point there is before it
    for (int i = 0; i < run.count; ++i) ties += run.coordinates[i] == coordinate ? 1 : 0;
  }
  if (ties > 0) untie_bins(source, probes, run);
}

struct NoExtents {
  KOKKOS_INLINE_FUNCTION void add(const Run&, Survey&) const {}
};

struct PointExtents {
  AxisPoints source;
  KOKKOS_INLINE_FUNCTION void add(const Run& run, Survey& survey) const {
    // Eight rows at a time, so that each place of the inner loop always meets the same direction.
    constexpr int width = 24;
    std::uint64_t lowest[width], highest[width];
    for (int j = 0; j < width; ++j) {
      lowest[j] = survey.lowest[j % 3];
      highest[j] = survey.highest[j % 3];
    }
    const double* const rows = &source.points.positions(run.first, 0);
    const int length = 3 * run.count, whole = length - length % width;
    for (int start = 0; start < whole; start += width) {
      for (int j = 0; j < width; ++j) widen(rows[start + j], lowest[j], highest[j]);
    }
    for (int j = 0; j < length - whole; ++j) widen(rows[whole + j], lowest[j], highest[j]);
    for (int j = 0; j < width; ++j) {
      survey.lowest[j % 3] = lowest[j] < survey.lowest[j % 3] ? lowest[j] : survey.lowest[j % 3];
      survey.highest[j % 3] = highest[j] > survey.highest[j % 3] ? highest[j] : survey.highest[j % 3];
    }
    for (int i = run.first; i < run.first + run.count; ++i) {
      if (source.weight(i) < survey.lowest_weight) survey.lowest_weight = source.weight(i);
    }
  }
  KOKKOS_INLINE_FUNCTION static void widen(double position, std::uint64_t& lowest, std::uint64_t& highest) {
    const std::uint64_t coordinate = order_coordinate(position);
    lowest = coordinate < lowest ? coordinate : lowest;
    highest = coordinate > highest ? coordinate : highest;
  }
};

}  // namespace

// Whole numbers and least keys: the same for any order of threads.
template <class Source, class Extents>
Survey PointCounter::count_blocks(const ExecSpace& space, const Source& source, int n, const Probes& probes,
                                  const Extents& extents) {
  const int block_count = (n + block_length - 1) / block_length;
  make_room(bins_, "percuss::rcb_bins", n);
  make_room(block_surveys_, "percuss::rcb_counts", block_count);
  const auto bins = bins_;
  const auto block_surveys = block_surveys_;
  parallel_for(
      "percuss::rcb_count", RangeOf(space, 0, block_count), KOKKOS_LAMBDA(const int block) {
        Survey survey;
        ProbeCounts others;  // of every other point: a count need not wait for the one just before
        Run run;
        const int end = (block + 1) * block_length < n ? (block + 1) * block_length : n;
        for (run.first = block * block_length; run.first < end; run.first += run_length) {
          run.count = end - run.first < run_length ? end - run.first : run_length;
          find_bins(source, probes, run);
          extents.add(run, survey);
          for (int i = 0; i < run.count; ++i) {
            bins(run.first + i) = static_cast<unsigned char>(run.bins[i]);
            ProbeCounts& counts = i % 2 == 0 ? survey.counts : others;
            counts.bins[run.bins[i]].add(source, run.first + i, run.coordinates[i]);
          }
        }
        survey.counts.merge(others);
        block_surveys(block) = survey;
      });
  space.fence();
  Survey total;
  const auto host = to_host(block_surveys);
  for (int block = 0; block < block_count; ++block) total.merge(host(block));
  last_counts_ = total.counts;
  return total;
}

Survey PointCounter::survey(const ExecSpace& space, const AxisPoints& points, int n, const Probes& probes) {
  return count_blocks(space, points, n, probes, PointExtents{points});
}

ProbeCounts PointCounter::count(const ExecSpace& space, const AxisPoints& points, int n, const Probes& probes) {
  return count_blocks(space, points, n, probes, NoExtents{}).counts;
}

ProbeCounts PointCounter::count(const ExecSpace& space, const CandidateKeys& candidates, int n, const Probes& probes) {
  return count_blocks(space, candidates, n, probes, NoExtents{}).counts;
}

template <class Source>
CandidateKeys PointCounter::take(const ExecSpace& space, const Source& source, int n, int bin) {
  CandidateKeys& candidates = candidates_[turn_];
  turn_ = 1 - turn_;
  make_room(candidates.keys, "percuss::rcb_candidates", count_of(bin));
  make_room(candidates.weights, "percuss::rcb_candidate_weights", count_of(bin));
  CandidateKeys taken = candidates;
  const auto bins = bins_;
  int total = 0;
  parallel_scan(
      "percuss::rcb_take", RangeOf(space, 0, n),
      KOKKOS_LAMBDA(const int i, int& place, const bool is_final) {
        if (bins(i) != bin) return;
        if (is_final) {
          taken.keys(place) = source.key(i);
          taken.weights(place) = source.weight(i);
        }
        ++place;
      },
      total);
  space.fence();
  return taken;
}

CandidateKeys PointCounter::take_bin(const ExecSpace& space, const AxisPoints& points, int n, int bin) {
  return take(space, points, n, bin);
}

CandidateKeys PointCounter::take_bin(const ExecSpace& space, const CandidateKeys& candidates, int n, int bin) {
  return take(space, candidates, n, bin);
}

}  // namespace percuss
