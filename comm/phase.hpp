#pragma once
// How long a phase of the step takes, by the clock and as work of this thread, and its name for profiling tools.

#include <chrono>

#include "comm/communicator.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// Seconds since the start of a run.
struct PhaseClock {
  double wall = 0;
  double compute = 0;  // compute_seconds(): waits for other ranks and for the core left out

  PhaseClock& operator+=(const PhaseClock& other) {
    wall += other.wall;
    compute += other.compute;
    return *this;
  }
  PhaseClock& operator-=(const PhaseClock& other) {
    wall -= other.wall;
    compute -= other.compute;
    return *this;
  }
};

/// Adds its lifetime to a clock and names it as a Kokkos profiling region. Fences at its end, so that the time is that
/// of the work and not of its launch.
class Phase {
 public:
  Phase(const char* name, PhaseClock& clock)
      : clock_(clock), wall_start_(std::chrono::steady_clock::now()), compute_start_(compute_seconds()) {
    Kokkos::Profiling::pushRegion(name);
  }
  ~Phase() {
    ExecSpace().fence();
    Kokkos::Profiling::popRegion();
    clock_.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
    clock_.compute += compute_seconds() - compute_start_;
  }
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

 private:
  PhaseClock& clock_;
  std::chrono::steady_clock::time_point wall_start_;
  double compute_start_;
};

}  // namespace percuss
