#include "comm/exchange/unstructured_exchange.hpp"

#include <algorithm>

#include "comm/exchange/consensus.hpp"
#include "kernels/core/contract.hpp"

namespace percuss {

namespace {

// Within the object's own communicator. The consensus alternates between two tags.
constexpr int size_tag = 1;
constexpr int first_consensus_tag = 2;

/// (2.1) Form vector of 0/1 denoting who I send to.
std::vector<int> form_send_vector(const Communicator& ranks, const std::vector<PeerRun>& to) {
  std::vector<int> sends(static_cast<std::size_t>(ranks.size()), 0);
  for (const PeerRun& run : to) sends[static_cast<std::size_t>(run.rank)] = 1;
  return sends;
}

/// (2.2) Fold vector over all P processors, (2.3) gather number of receives for my processor: nrecvs = vector(q).
int fold_send_vector(const Communicator& ranks, const std::vector<int>& sends) {
  int receive_count = 0;
  wait_mpi([&] { return MPI_Reduce_scatter_block(sends.data(), &receive_count, 1, MPI_INT, MPI_SUM, ranks.handle()); },
           "MPI_Reduce_scatter_block");
  return receive_count;
}

/// (2.4) For each processor I have data for, send message containing size of the data.
std::vector<MPI_Request> send_sizes(const Communicator& ranks, const std::vector<PeerRun>& to) {
  std::vector<MPI_Request> requests(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    check_mpi(MPI_Isend(&to[i].count, 1, MPI_INT64_T, to[i].rank, size_tag, ranks.handle(), &requests[i]), "MPI_Isend");
  }
  return requests;
}

/// (2.5) Receive nrecvs messages with sizes coming to me. In the order of arrival.
std::vector<PeerRun> receive_sizes(const Communicator& ranks, int receive_count) {
  std::vector<PeerRun> from(static_cast<std::size_t>(receive_count));
  const WaitScope waits;  // one for all: reading the clock of a thread takes half a microsecond
  for (PeerRun& run : from) {
    MPI_Status status;
    check_mpi(MPI_Recv(&run.count, 1, MPI_INT64_T, MPI_ANY_SOURCE, size_tag, ranks.handle(), &status), "MPI_Recv");
    run.rank = status.MPI_SOURCE;
  }
  return from;
}

// Nobody's next sizes can be taken for these: the next fold ends only after every rank has come to it.
std::vector<PeerRun> exchange_sizes_by_fold(const Communicator& ranks, const std::vector<PeerRun>& to) {
  const int receive_count = fold_send_vector(ranks, form_send_vector(ranks, to));
  std::vector<MPI_Request> sends = send_sizes(ranks, to);
  std::vector<PeerRun> from = receive_sizes(ranks, receive_count);
  wait_mpi([&] { return MPI_Waitall(static_cast<int>(sends.size()), sends.data(), MPI_STATUSES_IGNORE); },
           "MPI_Waitall");
  return from;
}

void lay_out_by_source(std::vector<PeerRun>& from) {
  std::sort(from.begin(), from.end(), [](const PeerRun& a, const PeerRun& b) { return a.rank < b.rank; });
  std::int64_t next = 0;
  for (PeerRun& run : from) {
    run.first = next;
    next += run.count;
  }
}

}  // namespace

ExchangePlan UnstructuredExchange::plan(const std::vector<PeerRun>& to, PlanMethod method) {
  ExchangePlan plan;
  std::vector<PeerRun> to_others;
  std::vector<PeerRun> to_self;
  for (const PeerRun& run : to) {
    if (run.count == 0) continue;
    PERCUSS_EXPECT(plan.to.empty() || (run.rank > plan.to.back().rank && run.first == plan.send_count()));
    plan.to.push_back(run);
    (run.rank == ranks_->rank() ? to_self : to_others).push_back(run);
  }
  if (method == PlanMethod::automatic) {
    method = ranks_->size() < consensus_from_ranks ? PlanMethod::reduce_scatter : PlanMethod::consensus;
  }
  if (method == PlanMethod::reduce_scatter) {
    plan.from = exchange_sizes_by_fold(*ranks_, to_others);
  } else {
    plan.from = exchange_sizes_by_consensus(*ranks_, to_others, first_consensus_tag + consensus_round_);
    consensus_round_ = 1 - consensus_round_;
  }
  plan.from.insert(plan.from.end(), to_self.begin(), to_self.end());
  lay_out_by_source(plan.from);
  return plan;
}

}  // namespace percuss
