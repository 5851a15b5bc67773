#pragma once
// Wall seconds by phase of the step, and the profiling region that tools see.

#include <chrono>

#include "kernels/core/views.hpp"

namespace percuss {

/// Adds its lifetime to a sum of seconds and names it as a Kokkos profiling region. Fences at its end, so that the
/// time is that of the work and not of its launch.
class Phase {
 public:
  Phase(const char* name, double& seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {
    Kokkos::Profiling::pushRegion(name);
  }
  ~Phase() {
    ExecSpace().fence();
    Kokkos::Profiling::popRegion();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace percuss
