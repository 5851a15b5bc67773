#pragma once
// Checks whether ranks and threads have enough cores. Reports to the user and changes nothing.

#include <optional>

#include "comm/communicator.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Where ranks and their threads run, as one machine sees it.
struct Placement {
  int ranks = 1, threads = 1, cores = 1;   // of the most crowded machine
  int bound_ranks = 0;                     // of all: bound to fewer cores than they have threads
  int bound_threads = 0, bound_cores = 0;  // of the one of them with the fewest cores
};

/// Looks at all ranks. threads: of this rank. The same on all ranks. Collective. Throws MpiError.
Placement find_placement(const Communicator& ranks, int threads);

/// Whether ranks and threads take turns on cores.
inline bool are_cores_shared(const Placement& placement) {
  return placement.threads > placement.cores || placement.bound_ranks > 0;
}

/// A warning that names the numbers, if cores are too few. rank_count: of the whole run.
std::optional<Warning> describe_crowding(const Placement& placement, int rank_count);

}  // namespace percuss
