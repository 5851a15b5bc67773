#pragma once
// Numbers for tests that damage their input: the same everywhere, unlike the distributions of <random>.

#include <cstddef>
#include <cstdint>

namespace percuss::test {

/// Marsaglia's xorshift.
class RandomIndex {
 public:
  /// A number in [0, n).
  std::size_t below(std::size_t n) {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return static_cast<std::size_t>(state_ % n);
  }

 private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15ULL;
};

}  // namespace percuss::test
