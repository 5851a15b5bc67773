#pragma once
// What one round of the median search counts: the points between neighbouring probes, on each rank and over all.

#include <array>
#include <cstdint>

#include "comm/rcb/rcb_points.hpp"

namespace percuss {

/// Probes of a round.
inline constexpr int probe_count = 15;
inline constexpr int bin_count = probe_count + 1;

/// Keys in ascending order; unused ones at the end are last_key. Bin k holds the points from probe k-1 up to, not
/// including, probe k.
struct Probes {
  CoordinateKey keys[probe_count];
  Probes() {
    for (CoordinateKey& key : keys) key = last_key;
  }
};

/// The points of one bin.
struct BinCount {
  std::int64_t points = 0;
  std::int64_t weight = 0;
  CoordinateKey lowest = last_key, highest = first_key;

  /// Adds point i of a source; its id is only looked at where it decides.
  template <class Source>
  KOKKOS_INLINE_FUNCTION void add(const Source& source, int i, std::uint64_t coordinate) {
    ++points;
    weight += source.weight(i);
    if (coordinate <= lowest.coordinate) {
      const CoordinateKey key{coordinate, source.id(i)};
      if (key < lowest) lowest = key;
    }
    if (coordinate >= highest.coordinate) {
      const CoordinateKey key{coordinate, source.id(i)};
      if (highest < key) highest = key;
    }
  }
  KOKKOS_INLINE_FUNCTION void merge(const BinCount& other) {
    points += other.points;
    weight += other.weight;
    if (other.lowest < lowest) lowest = other.lowest;
    if (highest < other.highest) highest = other.highest;
  }
};

/// A round's counts.
struct ProbeCounts {
  BinCount bins[bin_count];
  KOKKOS_INLINE_FUNCTION void merge(const ProbeCounts& other) {
    for (int k = 0; k < bin_count; ++k) bins[k].merge(other.bins[k]);
  }
};

/// The first round's: also where all points lie.
struct Survey {
  ProbeCounts counts;
  std::uint64_t lowest[3], highest[3];  // order_coordinate() of the extents along x, y, z
  int lowest_weight;
  KOKKOS_INLINE_FUNCTION Survey() : lowest_weight(1) {
    for (int k = 0; k < 3; ++k) {
      lowest[k] = last_key.coordinate;
      highest[k] = 0;
    }
  }
  KOKKOS_INLINE_FUNCTION void merge(const Survey& other) {
    counts.merge(other.counts);
    for (int k = 0; k < 3; ++k) {
      if (other.lowest[k] < lowest[k]) lowest[k] = other.lowest[k];
      if (other.highest[k] > highest[k]) highest[k] = other.highest[k];
    }
    if (other.lowest_weight < lowest_weight) lowest_weight = other.lowest_weight;
  }
};

/// Counts on this rank; holds the memory that it needs, from one search to the next.
class PointCounter {
 public:
  /// Counts n points and finds their extents.
  Survey survey(const ExecSpace& space, const AxisPoints& points, int n, const Probes& probes);

  /// Counts n points or candidates.
  ProbeCounts count(const ExecSpace& space, const AxisPoints& points, int n, const Probes& probes);
  ProbeCounts count(const ExecSpace& space, const CandidateKeys& candidates, int n, const Probes& probes);

  /// The candidates among the n just counted that are in `bin`, in their order. They stay valid through one more call.
  CandidateKeys take_bin(const ExecSpace& space, const AxisPoints& points, int n, int bin);
  CandidateKeys take_bin(const ExecSpace& space, const CandidateKeys& candidates, int n, int bin);

  /// Points of a bin on this rank, as last counted.
  int count_of(int bin) const { return static_cast<int>(last_counts_.bins[bin].points); }

  // Kernels of its own: nvcc takes none in a private function.
  template <class Source, class Extents>
  Survey count_blocks(const ExecSpace& space, const Source& source, int n, const Probes& probes,
                      const Extents& extents);
  template <class Source>
  CandidateKeys take(const ExecSpace& space, const Source& source, int n, int bin);

 private:
  ProbeCounts last_counts_;
  Array<unsigned char> bins_;    // [n] bin of each, as last counted
  Array<Survey> block_surveys_;  // [blocks]
  CandidateKeys candidates_[2];  // filled in turn: one is read while the other is filled
  int turn_ = 0;
};

}  // namespace percuss
