#pragma once
// A pulse of pressure over time.

#include <Kokkos_Core.hpp>

#include <cmath>

namespace percuss {

/// From `start` on, for a duration T, the sum of two pulses p (1 - t/T) exp(-b t/T), each with its peak p and its decay
/// b (Friedlander); zero before and after. With a negative phase the same formula continues where b > 0.
struct Pulse {
  double start = 0, duration = 0;
  double peaks[2] = {0, 0}, decays[2] = {0, 0};
  bool has_negative_phase = false;

  KOKKOS_INLINE_FUNCTION double operator()(double t) const {
    if (!(t >= start)) return 0;
    const double share = (t - start) / duration;
    const bool is_over = share > 1;
    if (is_over && !has_negative_phase) return 0;
    double sum = 0;
    for (int i = 0; i < 2; ++i)
      if (peaks[i] != 0 && (!is_over || decays[i] > 0)) sum += peaks[i] * (1 - share) * exp(-decays[i] * share);
    return sum;
  }
};

}  // namespace percuss
