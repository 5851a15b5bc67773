#pragma once
// Floating-point sums in one fixed order, whatever the number of threads.
//
// Items are cut into blocks of fixed length; each block is summed by one thread in ascending order, then the block sums
// are added in ascending order. Cost and parallelism of an ordinary reduction, bits of a serial loop over blocks.

#include <array>
#include <string>

#include "kernels/core/views.hpp"

namespace percuss {

/// K sums at once over items of one kind. Holds the block sums, so that nothing is allocated in the step.
template <int K>
class OrderedSum {
 public:
  using Values = Kokkos::Array<double, K>;
  static constexpr int block_length = 1024;

  OrderedSum(const std::string& label, int count)
      : label_(label),
        count_(count),
        blocks_(label, static_cast<std::size_t>((count + block_length - 1) / block_length)) {}

  /// add(i, sums) adds item i to sums[0..K). Returns the K totals on the host.
  template <class Add>
  std::array<double, K> operator()(const ExecSpace& space, const Add& add) const {
    const auto blocks = blocks_;
    const int count = count_;
    Kokkos::parallel_for(
        label_, Range(space, 0, static_cast<int>(blocks.extent(0))), KOKKOS_LAMBDA(const int b) {
          Values sums;
          for (int k = 0; k < K; ++k) sums[k] = 0;
          const int end = (b + 1) * block_length < count ? (b + 1) * block_length : count;
          for (int i = b * block_length; i < end; ++i) add(i, sums);
          for (int k = 0; k < K; ++k) blocks(b, k) = sums[k];
        });
    const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), blocks);
    space.fence();
    std::array<double, K> total{};
    for (std::size_t b = 0; b < host.extent(0); ++b) {
      for (std::size_t k = 0; k < K; ++k) total[k] += host(b, k);
    }
    return total;
  }

 private:
  std::string label_;
  int count_;
  Kokkos::View<double* [K], Kokkos::LayoutRight, MemSpace> blocks_;
};

}  // namespace percuss
