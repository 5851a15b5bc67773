#include "comm/probe_counts.hpp"

#include <cstddef>
#include <string>

namespace percuss {

namespace {

/// Points that one thread counts before its counts are merged with the others'.
constexpr int block_length = 4096;

/// Room for n entries; grows by a quarter more than asked for, because counts change from step to step.
template <class View>
void make_room(View& view, const std::string& label, int n) {
  const auto wanted = static_cast<std::size_t>(n);
  if (view.extent(0) < wanted) view = View(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), wanted + wanted / 4);
}

struct NoExtents {
  KOKKOS_INLINE_FUNCTION void add(int, Survey&) const {}
};

struct PointExtents {
  AxisPoints source;
  KOKKOS_INLINE_FUNCTION void add(int i, Survey& survey) const {
    for (int k = 0; k < 3; ++k) {
      const std::uint64_t coordinate = order_coordinate(source.points.positions(i, k));
      if (coordinate < survey.lowest[k]) survey.lowest[k] = coordinate;
      if (coordinate > survey.highest[k]) survey.highest[k] = coordinate;
    }
    if (source.weight(i) < survey.lowest_weight) survey.lowest_weight = source.weight(i);
  }
};

}  // namespace

// Whole numbers and least keys: the same whatever the order of threads.
template <class Source, class Extents>
Survey PointCounter::count_blocks(const ExecSpace& space, const Source& source, int n, const Probes& probes,
                                  const Extents& extents) {
  const int block_count = (n + block_length - 1) / block_length;
  make_room(bins_, "percuss::rcb_bins", n);
  make_room(block_surveys_, "percuss::rcb_counts", block_count);
  const auto bins = bins_;
  const auto block_surveys = block_surveys_;
  Kokkos::parallel_for(
      "percuss::rcb_count", Range(space, 0, block_count), KOKKOS_LAMBDA(const int block) {
        Survey survey;
        const int end = (block + 1) * block_length < n ? (block + 1) * block_length : n;
        for (int i = block * block_length; i < end; ++i) {
          const CoordinateKey key = source.key(i);
          const int bin = find_bin(probes, key);
          bins(i) = static_cast<unsigned char>(bin);
          survey.counts.bins[bin].add(key, source.weight(i));
          extents.add(i, survey);
        }
        block_surveys(block) = survey;
      });
  space.fence();
  Survey total;
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), block_surveys);
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
  const CandidateKeys taken = candidates;
  const auto bins = bins_;
  Kokkos::parallel_scan(
      "percuss::rcb_take", Range(space, 0, n), KOKKOS_LAMBDA(const int i, int& place, const bool is_final) {
        if (bins(i) != bin) return;
        if (is_final) {
          taken.keys(place) = source.key(i);
          taken.weights(place) = source.weight(i);
        }
        ++place;
      });
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
