#include "src/app/process/placement.hpp"

#include <fmt/format.h>

#include <string>
#include <tuple>

#include "comm/all_reduce.hpp"
#include "comm/merge_reduction.hpp"
#include "src/app/process/threads.hpp"

namespace percuss {

namespace {

/// A machine and the ranks on it.
struct Crowd {
  int ranks = 0, threads = 0, cores = 1;

  void merge(const Crowd& other) {
    const auto mine = static_cast<long>(threads) * other.cores, its = static_cast<long>(other.threads) * cores;
    if (std::tuple(its, other.threads, other.ranks) > std::tuple(mine, threads, ranks)) *this = other;
  }
};

/// Ranks that are bound to fewer cores than they have threads.
struct Bound {
  int ranks = 0, threads = 0, cores = 0;

  void merge(const Bound& other) {
    const int total = ranks + other.ranks;
    const bool takes =
        ranks == 0 || (other.ranks > 0 && std::tuple(other.cores, other.threads) < std::tuple(cores, threads));
    if (takes) *this = other;
    ranks = total;
  }
};

Crowd find_own_machine(const Communicator& ranks, int threads) {
  const OwnedCommunicator here = OwnedCommunicator::of_machine(ranks);
  Crowd crowd{here->size(), threads, count_machine_cores()};
  all_reduce(*here, Reduce::sum, crowd.threads);
  return crowd;
}

Warning warn(const std::string& text) { return {"crowded_cores", text, "", 0, 1}; }

}  // namespace

Placement find_placement(const Communicator& ranks, int threads) {
  Crowd crowd = find_own_machine(ranks, threads);
  MergeReduction<Crowd>()(ranks, crowd);
  const int cores = count_available_cores();
  Bound bound = cores < threads ? Bound{1, threads, cores} : Bound{};
  MergeReduction<Bound>()(ranks, bound);
  return {crowd.ranks, crowd.threads, crowd.cores, bound.ranks, bound.threads, bound.cores};
}

std::optional<Warning> describe_crowding(const Placement& p, int rank_count) {
  if (p.threads > p.cores) {
    return warn(fmt::format(
        "{} rank{} with {} thread{} together share the {} core{} of a machine (the cores are oversubscribed, and every "
        "step waits for the slowest thread): start fewer ranks, or set OMP_NUM_THREADS",
        p.ranks, p.ranks == 1 ? "" : "s", p.threads, p.threads == 1 ? "" : "s", p.cores, p.cores == 1 ? "" : "s"));
  }
  if (p.bound_ranks > 0) {
    return warn(fmt::format(
        "{} of {} rank{} {} bound to fewer cores than threads: {} thread{} on {} core{} (the cores are "
        "oversubscribed): unbind with mpirun --bind-to none, or bind to more with --map-by slot:PE={}, or set "
        "OMP_NUM_THREADS",
        p.bound_ranks, rank_count, rank_count == 1 ? "" : "s", p.bound_ranks == 1 ? "is" : "are", p.bound_threads,
        p.bound_threads == 1 ? "" : "s", p.bound_cores, p.bound_cores == 1 ? "" : "s", p.bound_threads));
  }
  return std::nullopt;
}

}  // namespace percuss
