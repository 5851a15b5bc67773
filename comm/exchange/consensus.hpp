#pragma once
// Non-blocking consensus: steps (2.1) to (2.5) of the paper without their P-long vector.
//
// Hoefler, Siebert, Lumsdaine, "Scalable communication protocols for dynamic sparse data exchange", PPoPP 2010,
// algorithm NBX. A synchronous send completes only once its message is received. A rank whose sends are complete enters
// a non-blocking barrier, and continues receiving until that barrier is passed by all: then every message has arrived.

#include <vector>

#include "comm/communicator.hpp"
#include "comm/exchange/exchange_plan.hpp"

namespace percuss {

/// Sends each receiver the size of its run and returns the runs of those who send here, in the order of their arrival,
/// with `first` not set. to: runs to other ranks, none empty. tag: not that of the consensus just before, because a
/// rank that has left it may send while another still listens. Collective. Throws MpiError.
std::vector<PeerRun> exchange_sizes_by_consensus(const Communicator& ranks, const std::vector<PeerRun>& to, int tag);

}  // namespace percuss
