#pragma once
// Random numbers that are the same on every rank and with every library: SplitMix64 (Steele, Lea, Flood, 2014).

#include <cstdint>

namespace percuss::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// 0 <= value < end.
  int below(int end) { return static_cast<int>(bits() % static_cast<std::uint64_t>(end)); }

  /// low <= value < high.
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }

 private:
  std::uint64_t state_;
};

}  // namespace percuss::test
