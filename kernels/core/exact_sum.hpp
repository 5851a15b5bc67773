#pragma once
// Sums of doubles without rounding: the same bits in any order, on any number of threads and ranks.
//
// The sum is a fixed-point number of 2176 bits, wide enough for every finite double (Kulisch and Miranker 1986). Its
// limbs have 32 bits and are stored in 64; the upper halves take up the carries of 2^31 additions. An addition touches
// three limbs. Sums are merged limb by limb, as integers, and rounded once, at the end.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

struct ExactSum {
  static constexpr int limb_count = 68;
  static constexpr int limb_bits = 32;
  static constexpr int lowest_exponent = -1074;  // of the last bit of limb 0

  std::int64_t limb[limb_count] = {};  // value = sum of limb[i] 2^(32 i - 1074)
  std::int64_t not_finite = 0;         // how many infinities and NaNs were added

  KOKKOS_INLINE_FUNCTION void add(double value) {
    if (value == 0) return;
    union {
      double number;
      std::uint64_t bits;
    } both;
    both.number = value;
    const auto exponent = static_cast<int>(both.bits >> 52 & 0x7ff);
    std::uint64_t mantissa = both.bits & 0xfffffffffffffull;
    if (exponent == 0x7ff) {
      ++not_finite;
      return;
    }
    if (exponent > 0) mantissa |= 1ull << 52;
    const int place = exponent > 0 ? exponent - 1 : 0;  // of the mantissa's last bit above the lowest
    const int shift = place % limb_bits;
    const std::uint64_t low = mantissa << shift, high = shift > 0 ? mantissa >> (64 - shift) : 0;
    const std::int64_t sign = both.bits >> 63 != 0 ? -1 : 1;
    std::int64_t* const first = &limb[place / limb_bits];
    first[0] += sign * static_cast<std::int64_t>(low & 0xffffffffull);
    first[1] += sign * static_cast<std::int64_t>(low >> 32);
    first[2] += sign * static_cast<std::int64_t>(high);
  }

  KOKKOS_INLINE_FUNCTION void merge(const ExactSum& other) {
    for (int i = 0; i < limb_count; ++i) limb[i] += other.limb[i];
    not_finite += other.not_finite;
  }

  /// Moves carries up: limbs 0 to limb_count - 2 are in [0, 2^32) then, and 2^30 such sums may be merged.
  KOKKOS_INLINE_FUNCTION void normalize() {
    for (int i = 0; i + 1 < limb_count; ++i) {
      const std::int64_t carry = limb[i] >> limb_bits;  // towards minus infinity
      limb[i] -= carry * (std::int64_t{1} << limb_bits);
      limb[i + 1] += carry;
    }
  }

  /// The double nearest to the sum; NaN if something that is not finite was added. On the host.
  double round() const {
    if (not_finite != 0) return std::nan("");
    ExactSum magnitude = *this;
    magnitude.normalize();
    const bool negative = magnitude.limb[limb_count - 1] < 0;
    if (negative) {
      for (std::int64_t& l : magnitude.limb) l = -l;
      magnitude.normalize();
    }
    int top = limb_count - 1;
    while (top > 0 && magnitude.limb[top] == 0) --top;
    if (top < 2) top = 2;
    // The three highest limbs hold at least 65 bits of the sum; what lies below them only breaks ties.
    bool sticky = false;
    for (int i = 0; i < top - 2; ++i) sticky = sticky || magnitude.limb[i] != 0;
    const auto high = static_cast<std::uint64_t>(magnitude.limb[top]);
    const auto low = static_cast<std::uint64_t>(magnitude.limb[top - 1]) << 32 |
                     static_cast<std::uint64_t>(magnitude.limb[top - 2]) | (sticky ? 1U : 0U);
    int shift = 0;  // the highest 64 bits of high : low, with what falls out as sticky bit
    std::uint64_t bits = low;
    if (high != 0) {
      while (high >> shift != 0) ++shift;
      const std::uint64_t lost = low & ((std::uint64_t{1} << shift) - 1);
      bits = low >> shift | high << (64 - shift) | (lost != 0 ? 1U : 0U);
    }
    const double value = std::ldexp(static_cast<double>(bits), shift + limb_bits * (top - 2) + lowest_exponent);
    return negative ? -value : value;
  }
};

/// Adds to one of several exact sums.
struct ExactAdder {
  ExactSum* sums;
  KOKKOS_INLINE_FUNCTION void operator()(int sum, double value) const { sums[sum].add(value); }
};

/// K exact sums over items in parallel. Each block of items adds to sums of its own, which are merged on the host.
template <int K>
class ExactSums {
 public:
  using Totals = std::array<ExactSum, K>;

  /// shortest: items of a block at least, so that clearing and merging its sums costs less than filling them.
  explicit ExactSums(const std::string& label, int shortest = 256)
      : label_(label), shortest_(shortest), blocks_(label, 0) {}

  /// body(i, add) is called for every item 0 <= i < count, in no order, with an ExactAdder: add(k, value) adds to sum
  /// k. Returns the sums with their carries moved up.
  template <class Body>
  Totals operator()(const WorkSpace& space, int count, const Body& body) {
    const int most = 4 * space.concurrency();
    int blocks = (count + shortest_ - 1) / shortest_;
    if (blocks > most) blocks = most;
    Totals totals{};
    if (blocks == 0) return totals;
    if (static_cast<int>(blocks_.extent(0)) < blocks) {
      blocks_ = Blocks(Kokkos::view_alloc(label_, Kokkos::WithoutInitializing), static_cast<std::size_t>(blocks));
    }
    const Blocks sums = blocks_;
    parallel_for(
        label_.c_str(), RangeOf(space, 0, blocks), KOKKOS_LAMBDA(const int b) {
          for (int k = 0; k < K; ++k) sums(b, k) = ExactSum{};
          const auto begin = static_cast<int>(static_cast<std::int64_t>(count) * b / blocks);
          const auto end = static_cast<int>(static_cast<std::int64_t>(count) * (b + 1) / blocks);
          const ExactAdder add{&sums(b, 0)};
          for (int i = begin; i < end; ++i) body(i, add);
        });
    space.fence();
    const auto host = to_host(sums);
    for (int b = 0; b < blocks; ++b) {
      for (int k = 0; k < K; ++k) {
        ExactSum& sum = host(b, k);
        sum.normalize();
        totals[static_cast<std::size_t>(k)].merge(sum);
      }
    }
    return totals;
  }

 private:
  using Blocks = Kokkos::View<ExactSum* [K], Kokkos::LayoutRight, MemSpace>;
  std::string label_;
  int shortest_;
  Blocks blocks_;
};

}  // namespace percuss
