#include "src/app/process/threads.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "src/error.hpp"

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

// A run was seen to need 64 to 100 KiB; scenes, compilers and libraries differ.
constexpr rlim_t least_stack = rlim_t{512} << 10, usual_stack = rlim_t{8} << 20;

// Kokkos 3.4 to 4.x keep the data of this many threads, and write behind their end without a word.
[[maybe_unused]] constexpr int most_threads = 512;

rlimit find_stack_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0) limit.rlim_cur = limit.rlim_max = RLIM_INFINITY;
  return limit;
}

bool raise_stack_limit() {
  rlimit limit = find_stack_limit();
  if (limit.rlim_cur >= least_stack || limit.rlim_cur >= limit.rlim_max) return false;
  limit.rlim_cur = std::min(limit.rlim_max, usual_stack);
  return setrlimit(RLIMIT_STACK, &limit) == 0;
}

#ifdef _OPENMP
/// Processes and threads that run or want to, this one among them; 1 if the system does not say.
int count_running() {
  std::ifstream file("/proc/loadavg");
  double mean = 0;
  int running = 0;
  return file >> mean >> mean >> mean >> running ? std::max(1, running) : 1;
}

/// Whether others leave fewer cores free than so many threads want: the middle one of some looks, milliseconds apart.
bool is_machine_busy(int threads) {
  std::array<int, 5> counts{};
  for (int& running : counts) {
    running = count_running();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
  return counts[counts.size() / 2] - 1 + threads > count_online_cores();
}

/// Turns of a waiting loop, of the kind that OpenMP waits in, within some time.
long count_turns(double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr int turns = 256;
  double least = seconds;
  for (int look = 0; look < 8; ++look) {
    const auto start = Clock::now();
    for (int i = 0; i < turns; ++i) {
#if defined(__x86_64__)
      __builtin_ia32_pause();
#else
      __asm__ volatile("" ::: "memory");
#endif
    }
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return std::lround(seconds / std::max(least, 1e-9) * turns);
}
#endif

bool shorten_waiting([[maybe_unused]] char** argv) {
#ifdef _OPENMP
  constexpr const char* name = "GOMP_SPINCOUNT";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(name) != nullptr) return false;
  if (argv[0] == nullptr || argv[1] == nullptr || std::string_view(argv[1]) != "run") return false;
  if (omp_get_max_threads() == 1) return false;
  // Longer than the gap between two kernels, shorter than what another process' turn costs.
  constexpr double seconds = 20e-6;
  const long turns = is_machine_busy(omp_get_max_threads()) ? 0 : count_turns(seconds);
  return setenv(name, std::to_string(turns).c_str(), 0) == 0;
#else
  return false;
#endif
}

void check_stack() {
  const rlimit limit = find_stack_limit();
  if (limit.rlim_cur >= least_stack) return;
  throw SystemError(
      fmt::format("the stack is limited to {} KiB (a run needs at least {} KiB): raise the limit with `ulimit -s {}`, "
                  "in a new shell if this one refuses",
                  limit.rlim_cur >> 10, least_stack >> 10, usual_stack >> 10));
}

/// Starts `count` threads at once and ends them. Throws std::system_error if the system refuses one.
[[maybe_unused]] void try_threads(int count) {
  std::mutex mutex;
  std::condition_variable change;
  bool all_started = false;
  std::vector<std::thread> threads;
  const auto end_all = [&] {
    {
      const std::lock_guard lock(mutex);
      all_started = true;
    }
    change.notify_all();
    for (std::thread& thread : threads) thread.join();
  };
  try {
    for (int i = 0; i < count; ++i) {
      threads.emplace_back([&] {
        std::unique_lock lock(mutex);
        change.wait(lock, [&] { return all_started; });
      });
    }
  } catch (...) {
    end_all();
    throw;
  }
  end_all();
}

}  // namespace

int count_available_cores() { return std::min(count_cores_by_affinity(), read_container_quota()); }

int count_machine_cores() { return std::min(count_online_cores(), read_container_quota()); }

void start_again_if_needed(char** argv) {
  const bool raised = raise_stack_limit(), shortened = shorten_waiting(argv);
  if (raised || shortened) execv("/proc/self/exe", argv);  // returns only if it fails: then all is as it was
}

void choose_threads([[maybe_unused]] int ranks_here, [[maybe_unused]] const std::function<int(int available)>& choose) {
#ifdef _OPENMP
  if (std::getenv("OMP_NUM_THREADS") == nullptr) {
    const bool is_bound = count_cores_by_affinity() < count_online_cores();
    omp_set_num_threads(choose(is_bound ? count_available_cores() : std::max(1, count_available_cores() / ranks_here)));
  }
#endif
  // The OpenMP runtime has read its environment by now; this only tells Kokkos that the choice is made, and that
  // warnings about crowded cores are ours to give, once for all ranks (src/app/process/placement.hpp).
  setenv("OMP_PROC_BIND", "false", 0);
  setenv("KOKKOS_DISABLE_WARNINGS", "1", 0);
}

void check_threads() {
  check_stack();
#ifdef _OPENMP
  const int count = omp_get_max_threads();
  if (count > most_threads) {
    throw SystemError(
        fmt::format("{} threads are too many for one rank (it can have {}): set OMP_NUM_THREADS to the number of cores "
                    "per rank; {} are available here",
                    count, most_threads, count_available_cores()));
  }
  try {
    try_threads(count - 1);
  } catch (const std::system_error& error) {
    throw SystemError(
        fmt::format("{} threads cannot be started ({}): set OMP_NUM_THREADS to fewer, or raise the limits of the shell "
                    "(ulimit -u, ulimit -v)",
                    count, error.code().message()));
  }
#endif
}

}  // namespace percuss
