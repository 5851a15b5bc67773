// A library for Kokkos Tools: seconds, calls and share of every kernel and profiling region of a run.
//
// KOKKOS_PROFILE_LIBRARY=build/release/perf/profile/libkernel_times.so percuss run deck.yaml
//
// Regions contain what is inside of them, kernels included. Written to standard error when the program ends; with
// KERNEL_TIMES=FILE to that file, with the process id appended if it is one of several ranks.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Total {
  double seconds = 0;
  long calls = 0;
};

struct Begun {
  std::string name;
  Clock::time_point at;
};

struct Profile {
  Clock::time_point start = Clock::now();
  std::map<std::string, Total> kernels, regions;
  std::vector<Begun> open_kernels, open_regions;  // stacks: launches come from one thread
};

Profile& profile() {
  static Profile all;
  return all;
}

void begin(std::vector<Begun>& open, const char* name) { open.push_back({name, Clock::now()}); }

void end(std::vector<Begun>& open, std::map<std::string, Total>& totals) {
  if (open.empty()) return;
  Total& total = totals[open.back().name];
  total.seconds += std::chrono::duration<double>(Clock::now() - open.back().at).count();
  total.calls += 1;
  open.pop_back();
}

void print(std::FILE* out, const char* title, const std::map<std::string, Total>& totals, double wall) {
  std::vector<std::pair<std::string, Total>> rows(totals.begin(), totals.end());
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second.seconds > b.second.seconds; });
  std::fprintf(out, "%-48s %10s %7s %10s %12s\n", title, "seconds", "share", "calls", "us a call");
  constexpr std::size_t most = 25;
  Total rest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [name, total] = rows[i];
    if (i >= most) {
      rest.seconds += total.seconds;
      rest.calls += total.calls;
      continue;
    }
    std::fprintf(out, "%-48s %10.3f %5.1f %% %10ld %12.2f\n", name.c_str(), total.seconds, 100 * total.seconds / wall,
                 total.calls, 1e6 * total.seconds / static_cast<double>(total.calls));
  }
  if (rows.size() > most) {
    std::fprintf(out, "%-48s %10.3f %5.1f %% %10ld\n", ("and " + std::to_string(rows.size() - most) + " more").c_str(),
                 rest.seconds, 100 * rest.seconds / wall, rest.calls);
  }
}

void begin_kernel(const char* name, std::uint64_t* id) {
  *id = 0;
  begin(profile().open_kernels, name);
}

void end_kernel() { end(profile().open_kernels, profile().kernels); }

}  // namespace

// The names and arguments are those of the interface of Kokkos Tools.
extern "C" {

void kokkosp_init_library(int, std::uint64_t, std::uint32_t, void*) { profile(); }

void kokkosp_finalize_library() {
  const double wall = std::chrono::duration<double>(Clock::now() - profile().start).count();
  const char* path = std::getenv("KERNEL_TIMES");
  std::FILE* out = stderr;
  if (path != nullptr) {
    const bool is_rank = std::getenv("OMPI_COMM_WORLD_RANK") != nullptr;
    out = std::fopen((std::string(path) + (is_rank ? "." + std::to_string(getpid()) : "")).c_str(), "w");
    if (out == nullptr) return std::perror(path);
  }
  std::fprintf(out, "%.3f s from the start to the end of Kokkos\n\n", wall);
  print(out, "region", profile().regions, wall);
  std::fprintf(out, "\n");
  print(out, "kernel", profile().kernels, wall);
  if (out != stderr) std::fclose(out);
}

void kokkosp_begin_parallel_for(const char* name, std::uint32_t, std::uint64_t* id) { begin_kernel(name, id); }
void kokkosp_end_parallel_for(std::uint64_t) { end_kernel(); }
void kokkosp_begin_parallel_reduce(const char* name, std::uint32_t, std::uint64_t* id) { begin_kernel(name, id); }
void kokkosp_end_parallel_reduce(std::uint64_t) { end_kernel(); }
void kokkosp_begin_parallel_scan(const char* name, std::uint32_t, std::uint64_t* id) { begin_kernel(name, id); }
void kokkosp_end_parallel_scan(std::uint64_t) { end_kernel(); }
void kokkosp_push_profile_region(const char* name) { begin(profile().open_regions, name); }
void kokkosp_pop_profile_region() { end(profile().open_regions, profile().regions); }

}  // extern "C"
