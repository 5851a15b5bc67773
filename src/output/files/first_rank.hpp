#pragma once
// What rank 0 does with a file for all ranks.

#include "src/fail_together.hpp"

namespace percuss {

/// Calls work() on rank 0. If it throws there, it throws on all ranks. Returns when all know that it is done. No
/// message is sent where there is one rank. Collective. Throws MpiError.
template <class Work>
void run_on_first_rank(const Communicator& ranks, const Work& work) {
  if (ranks.size() == 1) {
    work();
    return;
  }
  fail_together(ranks, [&] {
    if (ranks.rank() == 0) work();
  });
}

}  // namespace percuss
