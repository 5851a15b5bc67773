#include "comm/exchange/consensus.hpp"

namespace percuss {

namespace {

std::vector<MPI_Request> begin_synchronous_sends(const Communicator& ranks, const std::vector<PeerRun>& to, int tag) {
  std::vector<MPI_Request> requests(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    check_mpi(MPI_Issend(&to[i].count, 1, MPI_INT64_T, to[i].rank, tag, ranks.handle(), &requests[i]), "MPI_Issend");
  }
  return requests;
}

void receive_if_arrived(const Communicator& ranks, int tag, std::vector<PeerRun>& from) {
  int arrived = 0;
  MPI_Status status;
  check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, tag, ranks.handle(), &arrived, &status), "MPI_Iprobe");
  if (arrived == 0) return;
  PeerRun run{status.MPI_SOURCE, 0, 0};
  wait_mpi([&] { return MPI_Recv(&run.count, 1, MPI_INT64_T, run.rank, tag, ranks.handle(), MPI_STATUS_IGNORE); },
           "MPI_Recv");
  from.push_back(run);
}

bool are_complete(std::vector<MPI_Request>& requests) {
  int done = 0;
  check_mpi(MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE), "MPI_Testall");
  return done != 0;
}

}  // namespace

std::vector<PeerRun> exchange_sizes_by_consensus(const Communicator& ranks, const std::vector<PeerRun>& to, int tag) {
  const WaitScope waits;
  std::vector<PeerRun> from;
  std::vector<MPI_Request> sends = begin_synchronous_sends(ranks, to, tag);
  std::vector<MPI_Request> barrier;
  while (barrier.empty() || !are_complete(barrier)) {
    receive_if_arrived(ranks, tag, from);
    if (barrier.empty() && are_complete(sends)) {
      barrier.resize(1);
      check_mpi(MPI_Ibarrier(ranks.handle(), barrier.data()), "MPI_Ibarrier");
    }
  }
  return from;
}

}  // namespace percuss
