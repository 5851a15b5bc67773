#include "perf/micro/ceilings.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "kernels/core/precision.hpp"
#include "kernels/core/simd.hpp"

namespace percuss {

namespace {

using Lanes = Pack<Real>;
constexpr int tries = 20;
#ifdef __AVX512F__
constexpr int flop_chains = 10;
#else
constexpr int flop_chains = 6;
#endif

template <class Work>
double time_least(const Work& work) {
  double least = 1e300;
  for (int i = 0; i < tries; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

volatile double sink = 0;

/// Chains enough to hide the latency of both units: four operations of three cycles each where 16 registers have to
/// hold them, two of four cycles where there are 32.
void multiply_and_add(int rounds) {
  constexpr int chains = flop_chains;
  Lanes product[chains], sum[chains];
  for (int i = 0; i < chains; ++i) product[i] = sum[i] = Lanes(static_cast<Real>(1 + 1e-3 * i));
  const Lanes factor(static_cast<Real>(1 + 1e-6)), term(static_cast<Real>(1e-6));
  for (int r = 0; r < rounds; ++r) {
    for (int i = 0; i < chains; ++i) {
      product[i] = product[i] * factor;
      sum[i] = sum[i] + term;
    }
  }
  Lanes all(0);
  for (int i = 0; i < chains; ++i) all = all + product[i] + sum[i];
  alignas(64) Real row[pack_size<Real>];
  store_pack(row, all);
  sink = row[0];
}

}  // namespace

Ceilings measure_ceilings() {
  constexpr int rounds = 100000;
  const double flop = 2.0 * flop_chains * rounds * pack_size<Real>;
  const double compute = time_least([] { multiply_and_add(rounds); });

  constexpr std::size_t length = 8'000'000;  // three arrays of 64 MB: past any cache
  std::vector<double> a(length, 1.0), b(length, 2.0), c(length, 3.0);
  const double triad = time_least([&] {
    for (std::size_t i = 0; i < length; ++i) a[i] = b[i] + 0.5 * c[i];
    sink = a[length / 2];
  });
  return {flop / compute, 3.0 * sizeof(double) * length / triad};
}

}  // namespace percuss
