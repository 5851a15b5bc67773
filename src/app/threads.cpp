#include "src/app/threads.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace percuss {
namespace {

int count_cores_by_affinity() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof(set), &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

int count_online_cores() { return std::max(1, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN))); }

// The processor quota of a control group (version 2) in cores, rounded up; large if there is none.
int read_container_quota() {
  constexpr int unlimited = 1 << 20;
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  double quota = 0, period = 0;
  if (!(file >> quota >> period) || quota <= 0 || period <= 0) return unlimited;  // "max 100000" is no number
  return std::max(1, static_cast<int>(std::min(std::ceil(quota / period), static_cast<double>(unlimited))));
}

}  // namespace

int count_available_cores() { return std::min(count_cores_by_affinity(), read_container_quota()); }

int count_machine_cores() { return std::min(count_online_cores(), read_container_quota()); }

void shorten_waiting([[maybe_unused]] char** argv) {
#ifdef _OPENMP
  constexpr const char* name = "GOMP_SPINCOUNT";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(name) != nullptr) return;
  // About 20 microseconds: longer than the gap between two kernels, shorter than what another process' turn costs.
  if (setenv(name, "10000", 0) == 0) execv("/proc/self/exe", argv);  // returns only if it fails: then waiting is long
#endif
}

void choose_threads([[maybe_unused]] int ranks_here) {
#ifdef _OPENMP
  if (std::getenv("OMP_NUM_THREADS") == nullptr) {
    const bool is_bound = count_cores_by_affinity() < count_online_cores();
    omp_set_num_threads(is_bound ? count_available_cores() : std::max(1, count_available_cores() / ranks_here));
  }
#endif
  // The OpenMP runtime has read its environment by now; this only tells Kokkos that the choice is made, and that
  // warnings about crowded cores are ours to give, once for all ranks (src/app/placement.hpp).
  setenv("OMP_PROC_BIND", "false", 0);
  setenv("KOKKOS_DISABLE_WARNINGS", "1", 0);
}

}  // namespace percuss
