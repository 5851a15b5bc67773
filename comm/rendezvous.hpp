#pragma once
// Tells a failure that all ranks have met from one that this rank has met alone.
//
// Ranks that have thrown the same error at the same place all come here. A rank that failed alone waits in vain, for
// the others hang in the collective that it has left, and must end them.

#include "comm/communicator.hpp"

namespace percuss {

class Rendezvous {
 public:
  /// Ranks may come here while others are in a collective of `ranks`. Collective. Throws MpiError.
  explicit Rendezvous(const Communicator& ranks) : ranks_(OwnedCommunicator::duplicate(ranks)) {}

  /// Waits for all ranks, some seconds at most. True: all are here. After false no rank may come here again. Throws
  /// nothing: an MPI that fails counts as a rank that does not come.
  bool meet() noexcept;

 private:
  /// Much longer than ranks of a busy machine come apart, short enough for somebody who watches a run fail.
  static constexpr double patience = 5;  // seconds

  OwnedCommunicator ranks_;
};

}  // namespace percuss
