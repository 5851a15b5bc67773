#pragma once
// Kokkos for as long as a command computes, with as many threads as its scene can use.

#include <Kokkos_Core.hpp>
#include <string>

#include "comm/communicator.hpp"
#include "kernels/core/guarded_memory.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// A thread gets at least so many elements, unless OMP_NUM_THREADS is set: the loops of a step are many and short, and
/// each costs what its threads need to meet, more of them on more threads (docs/performance.md).
inline constexpr double elements_of_thread = 1000;

/// Elements of the parts of a deck; of mesh files as many as their size lets expect.
double estimate_elements(const Deck& deck);

/// Threads of a rank out of those that are available.
int choose_thread_count(double elements, int ranks, int available);

class ComputeSession {
 public:
  /// Collective. Throws SystemError, the same on all ranks, if a rank cannot have its threads.
  ComputeSession(const Communicator& ranks, const Deck& deck);

  /// Says why there are fewer threads than cores; empty if there are not, or if OMP_NUM_THREADS is set.
  const std::string& note() const { return note_; }

 private:
  std::string note_;
  Kokkos::ScopeGuard kokkos_;
#if defined(PERCUSS_MEMORY_APART)
  MemoryGuard guard_;
#endif
};

}  // namespace percuss
