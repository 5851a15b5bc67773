#pragma once
// Distinguishes a failure of all ranks from a failure of this rank alone.
//
// Ranks that have thrown the same error at the same place all come here. A rank that failed alone waits without an
// answer, since the others hang in the collective that it has left. It must end them.

#include "comm/communicator.hpp"

namespace percuss {

class Rendezvous {
 public:
  /// Ranks may come here while others are in a collective of `ranks`. patience: seconds; much longer than ranks of a
  /// busy machine come apart, short enough for somebody who watches a run fail. Collective. Throws MpiError.
  explicit Rendezvous(const Communicator& ranks, double patience = 5)
      : ranks_(OwnedCommunicator::duplicate(ranks)), patience_(patience) {}

  /// Waits for the others after a meeting in vain: end them before.
  ~Rendezvous();
  Rendezvous(const Rendezvous&) = delete;
  Rendezvous& operator=(const Rendezvous&) = delete;

  /// Waits for all ranks, until patience is at its end. True: all are here. After false not to be called again. Throws
  /// nothing: an MPI that fails counts as a rank that does not come.
  bool meet() noexcept;

 private:
  OwnedCommunicator ranks_;
  double patience_;
  MPI_Request waiting_ = MPI_REQUEST_NULL;  // a meeting that not all have come to
};

}  // namespace percuss
