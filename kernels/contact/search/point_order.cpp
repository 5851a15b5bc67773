#include "kernels/contact/search/point_order.hpp"

#include <utility>

namespace percuss {
namespace {

constexpr int digit_bits = 8;
constexpr int num_digits = 64 / digit_bits;
constexpr int num_bins = 1 << digit_bits;

KOKKOS_INLINE_FUNCTION int find_bin(std::uint64_t key, int digit) {
  return static_cast<int>((key >> (digit * digit_bits)) & (num_bins - 1));
}

/// Blocks of consecutive items, one a thread. The result does not depend on how many there are.
struct Blocks {
  int n = 0, count = 1;
  KOKKOS_INLINE_FUNCTION int begin(int b) const { return static_cast<int>(static_cast<std::int64_t>(n) * b / count); }
};

Blocks cut_blocks(const WorkSpace& space, int n) {
  constexpr int smallest = 2048;
  const int threads = space.concurrency();
  const int wanted = n / smallest < threads ? n / smallest : threads;
  return {n, wanted > 0 ? wanted : 1};
}

/// Bits in which any key differs from the first.
std::uint64_t find_varying_bits(const WorkSpace& space, const Array<std::uint64_t>& keys, int n) {
  std::uint64_t varying = 0;
  parallel_reduce(
      "contact::sort_varying", RangeOf(space, 0, n),
      KOKKOS_LAMBDA(int i, std::uint64_t& bits) { bits |= keys(i) ^ keys(0); }, Kokkos::BOr<std::uint64_t>(varying));
  return varying;
}

/// Turns counts by (block, bin) into first places, bins before blocks.
void scan_histogram(const WorkSpace& space, const Array<int>& histogram, int blocks) {
  parallel_for(
      "contact::sort_scan", RangeOf(space, 0, 1), KOKKOS_LAMBDA(int) {
        int place = 0;
        for (int bin = 0; bin < num_bins; ++bin)
          for (int b = 0; b < blocks; ++b) {
            const int count = histogram(b * num_bins + bin);
            histogram(b * num_bins + bin) = place;
            place += count;
          }
      });
}

struct Stream {
  Array<std::uint64_t> keys;
  Array<int> items;
};

/// One stable pass over a digit.
void sort_digit(const WorkSpace& space, const Blocks& blocks, int digit, const Stream& from, const Stream& to,
                const Array<int>& histogram) {
  parallel_for(
      "contact::sort_count", RangeOf(space, 0, blocks.count), KOKKOS_LAMBDA(int b) {
        for (int bin = 0; bin < num_bins; ++bin) histogram(b * num_bins + bin) = 0;
        for (int i = blocks.begin(b); i < blocks.begin(b + 1); ++i)
          ++histogram(b * num_bins + find_bin(from.keys(i), digit));
      });
  scan_histogram(space, histogram, blocks.count);
  parallel_for(
      "contact::sort_scatter", RangeOf(space, 0, blocks.count), KOKKOS_LAMBDA(int b) {
        for (int i = blocks.begin(b); i < blocks.begin(b + 1); ++i) {
          const int place = histogram(b * num_bins + find_bin(from.keys(i), digit))++;
          to.keys(place) = from.keys(i);
          to.items(place) = from.items(i);
        }
      });
}

}  // namespace

void rank_points(const WorkSpace& space, const PointsAlongAxis& points, SortScratch& scratch, const Array<int>& order,
                 const Array<int>& rank) {
  const int n = points.n;
  const Blocks blocks = cut_blocks(space, n);
  reserve(scratch.keys[0], n);
  reserve(scratch.keys[1], n);
  reserve(scratch.items, n);
  reserve(scratch.histogram, blocks.count * num_bins);
  Stream from{scratch.keys[0], order}, to{scratch.keys[1], scratch.items};
  const Array<std::uint64_t> keys = from.keys;
  const PointsAlongAxis p = points;
  parallel_for(
      "contact::sort_keys", RangeOf(space, 0, n), KOKKOS_LAMBDA(int i) {
        keys(i) = make_sort_key(p.x(p.points(i), p.axis));
        order(i) = i;
      });
  const std::uint64_t varying = n > 0 ? find_varying_bits(space, keys, n) : 0;
  for (int digit = 0; digit < num_digits; ++digit) {
    if (((varying >> (digit * digit_bits)) & (num_bins - 1)) == 0) continue;
    sort_digit(space, blocks, digit, from, to, scratch.histogram);
    std::swap(from, to);
  }
  const Array<int> sorted = from.items;
  parallel_for(
      "contact::sort_ranks", RangeOf(space, 0, n), KOKKOS_LAMBDA(int i) {
        order(i) = sorted(i);  // the same memory after an even number of passes
        rank(sorted(i)) = i;
      });
}

}  // namespace percuss
