#pragma once
// How many threads a run uses when the user does not say.

namespace percuss {

/// Cores that this process may use: its affinity, and the quota of its container if there is one. At least 1.
int count_available_cores();

/// Without OMP_WAIT_POLICY or GOMP_SPINCOUNT, starts the program again with threads that spin only briefly before they
/// sleep. GNU's OpenMP spins for milliseconds by default, which on a machine with other work slows a step tenfold and
/// more, and it reads its environment before main() begins. To be called first thing; argv as given to main().
void shorten_waiting(char** argv);

/// Cores that the ranks of this machine may use together: those that are there, and the quota of the container.
int count_machine_cores();

/// To be called before Kokkos starts: without OMP_NUM_THREADS every available core gets a thread, and ranks that are
/// not bound to cores of their own share those of the machine equally; without OMP_PROC_BIND threads are not bound, and
/// Kokkos does not warn about it. ranks_here: ranks on this machine.
void choose_threads(int ranks_here);

}  // namespace percuss
