#include "comm/exchange/counted_exchange.hpp"

#include <algorithm>

namespace percuss {

namespace {

constexpr int counted_tag = 1;

}  // namespace

/// Sends in messages of which the last is shorter than a message may be.
void CountedExchange::send(const PeerRun& run, const std::byte* items, std::size_t item_bytes) {
  std::int64_t left = run.count * static_cast<std::int64_t>(item_bytes);
  const std::byte* next = items + static_cast<std::size_t>(run.first) * item_bytes;
  for (;;) {
    const auto length = static_cast<int>(std::min(left, message_limit_));
    requests_.push_back(MPI_REQUEST_NULL);
    check_mpi(MPI_Isend(next, length, MPI_BYTE, run.rank, counted_tag, ranks_->handle(), &requests_.back()),
              "MPI_Isend");
    ++traffic_.messages;
    traffic_.bytes += length;
    if (length < message_limit_) return;
    left -= length;
    next += length;
  }
}

CountedExchange::Message CountedExchange::receive() const {
  Message all{MPI_ANY_SOURCE, {}};
  int length = 0;
  do {
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    check_mpi(MPI_Mprobe(all.rank, counted_tag, ranks_->handle(), &message, &status), "MPI_Mprobe");
    check_mpi(MPI_Get_count(&status, MPI_BYTE, &length), "MPI_Get_count");
    all.rank = status.MPI_SOURCE;
    const std::size_t first = all.bytes.size();
    all.bytes.resize(first + static_cast<std::size_t>(length));
    check_mpi(MPI_Mrecv(all.bytes.data() + first, length, MPI_BYTE, &message, MPI_STATUS_IGNORE), "MPI_Mrecv");
  } while (length == message_limit_);
  return all;
}

void CountedExchange::exchange_bytes(const std::vector<PeerRun>& to, const std::byte* items, std::size_t item_bytes,
                                     int senders) {
  messages_.clear();
  for (const PeerRun& run : to) send(run, items, item_bytes);
  const WaitScope waits;
  for (int i = 0; i < senders; ++i) messages_.push_back(receive());
  check_mpi(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  requests_.clear();
  std::sort(messages_.begin(), messages_.end(), [](const Message& a, const Message& b) { return a.rank < b.rank; });
}

}  // namespace percuss
