#pragma once
// Unstructured communication: ranks that know what they send and to whom learn what they will receive and from whom.
//
// Figure 2 of the paper (section 4.1.3). Steps (2.1) to (2.5), or the non-blocking consensus that does without their
// P-long vector (Hoefler, Siebert, Lumsdaine: Scalable communication protocols for dynamic sparse data exchange, PPoPP
// 2010), make the plan; step (2.6), the data, is comm/exchange/data_exchange.hpp.

#include <vector>

#include "comm/communicator.hpp"
#include "comm/exchange/exchange_plan.hpp"

namespace percuss {

/// How ranks learn what they will receive. Both ways give the same plan.
enum class PlanMethod {
  automatic,       // consensus from consensus_from_ranks on
  reduce_scatter,  // (2.1) to (2.5): a fold over a vector of one entry a rank
  consensus,       // synchronous sends and a non-blocking barrier: messages to the receivers only
};

/// From this many ranks on the fold's vector, P entries sent by each of P ranks, costs more than the consensus.
inline constexpr int consensus_from_ranks = 256;

class UnstructuredExchange {
 public:
  /// Collective over `ranks`. Throws MpiError.
  explicit UnstructuredExchange(const Communicator& ranks) : ranks_(OwnedCommunicator::duplicate(ranks)) {}

  const Communicator& ranks() const { return *ranks_; }

  /// Steps (2.1) to (2.5). to: runs of the send buffer, in ascending rank, one after the other, as order_by_destination
  /// gives them; empty runs are allowed and leave no trace, the own rank is allowed. Collective. Throws MpiError.
  ExchangePlan plan(const std::vector<PeerRun>& to, PlanMethod method = PlanMethod::automatic);

 private:
  OwnedCommunicator ranks_;
  int consensus_round_ = 0;  // tells the messages of one consensus from those of the next
};

}  // namespace percuss
