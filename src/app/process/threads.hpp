#pragma once
// How many threads a run uses when the user does not say, and whether this process may have them.

#include <functional>

namespace percuss {

/// Cores that this process may use: its affinity, and the quota of its container if there is one. At least 1.
int count_available_cores();

/// Starts the program again where something must be other than it was before main() began; argv as given to main().
/// A run without OMP_WAIT_POLICY or GOMP_SPINCOUNT: with threads that spin only briefly before they sleep, and not at
/// all if other programs want the cores. GNU's OpenMP spins for milliseconds by default, which on a machine with other
/// work slows a step tenfold and more. With a stack that is
/// too small although a larger one is allowed: with the larger one, which threads get as well.
void start_again_if_needed(char** argv);

/// Cores that the ranks of this machine may use together: those that are there, and the quota of the container.
int count_machine_cores();

/// To be called before Kokkos starts: without OMP_NUM_THREADS the threads that `choose` makes of the available cores;
/// ranks that are not bound to cores of their own share those of the machine equally. Without OMP_PROC_BIND threads are
/// not bound, and Kokkos does not warn about it. ranks_here: ranks on this machine.
void choose_threads(int ranks_here, const std::function<int(int available)>& choose);

/// Throws SystemError if the stack is too small for a run, or if the threads that choose_threads() or OMP_NUM_THREADS
/// requests cannot be started: libraries end the program without a word then. Before Kokkos starts.
void check_threads();

}  // namespace percuss
