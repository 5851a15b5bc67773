#include "comm/exchange/data_exchange.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace percuss {

namespace {

constexpr int data_tag = 1;
constexpr int sized_tag = 2;  // of messages whose length the receiver learns from them

/// Calls send_piece(offset, length) for the messages that a run is cut into, in bytes; MPI keeps their order.
template <class Piece>
void for_each_piece(const PeerRun& run, std::size_t item_bytes, std::int64_t limit, const Piece& piece) {
  const auto size = static_cast<std::int64_t>(item_bytes);
  const std::int64_t end = (run.first + run.count) * size;
  for (std::int64_t offset = run.first * size; offset < end; offset += limit) {
    piece(offset, static_cast<int>(std::min(limit, end - offset)));
  }
}

}  // namespace

DataExchange::~DataExchange() {
  if (!requests_.empty()) MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

void DataExchange::check_room(const ExchangePlan& plan, std::size_t send, std::size_t receive) const {
  if (!requests_.empty()) throw std::logic_error("an exchange was begun (the one before it has not ended)");
  if (static_cast<std::int64_t>(send) < plan.send_count() ||
      static_cast<std::int64_t>(receive) < plan.receive_count()) {
    throw std::logic_error("buffers of " + std::to_string(send) + " and " + std::to_string(receive) +
                           " items were given to an exchange (its plan sends " + std::to_string(plan.send_count()) +
                           " and receives " + std::to_string(plan.receive_count()) + ")");
  }
}

void DataExchange::begin_receive(const PeerRun& run, std::byte* buffer, std::size_t item_bytes) {
  for_each_piece(run, item_bytes, message_limit_, [&](std::int64_t offset, int length) {
    MPI_Request request = MPI_REQUEST_NULL;
    check_mpi(MPI_Irecv(buffer + offset, length, MPI_BYTE, run.rank, data_tag, ranks_->handle(), &request),
              "MPI_Irecv");
    requests_.push_back(request);
  });
}

void DataExchange::begin_send(const PeerRun& run, const std::byte* buffer, std::size_t item_bytes) {
  for_each_piece(run, item_bytes, message_limit_,
                 [&](std::int64_t offset, int length) { begin_message(buffer + offset, length, run.rank, data_tag); });
}

void DataExchange::begin_message(const std::byte* data, int length, int rank, int tag) {
  MPI_Request request = MPI_REQUEST_NULL;
  check_mpi(MPI_Isend(data, length, MPI_BYTE, rank, tag, ranks_->handle(), &request), "MPI_Isend");
  requests_.push_back(request);
  ++traffic_.messages;
  traffic_.bytes += length;
}

namespace {

/// Copies what stays on this rank, without MPI.
void copy_own(const PeerRun& from, const PeerRun& to, const std::byte* send, std::byte* receive,
              std::size_t item_bytes) {
  std::memcpy(receive + static_cast<std::size_t>(to.first) * item_bytes,
              send + static_cast<std::size_t>(from.first) * item_bytes,
              static_cast<std::size_t>(from.count) * item_bytes);
}

}  // namespace

// Posts receives first, so that messages find their buffers.
void DataExchange::begin_bytes(const ExchangePlan& plan, const std::byte* send, std::byte* receive,
                               std::size_t item_bytes) {
  PeerRun own;
  for (const PeerRun& run : plan.from) {
    if (run.rank == ranks_->rank()) {
      own = run;
    } else {
      begin_receive(run, receive, item_bytes);
    }
  }
  for (const PeerRun& run : plan.to) {
    if (run.rank == ranks_->rank()) {
      copy_own(run, own, send, receive, item_bytes);
    } else {
      begin_send(run, send, item_bytes);
    }
  }
}

void DataExchange::end() {
  wait_mpi([&] { return MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); },
           "MPI_Waitall");
  requests_.clear();
}

/// Appends what a rank sends to sized_: messages up to the first that is not as long as a message may be.
void DataExchange::receive_sized(int source) {
  int length = 0;
  do {
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    check_mpi(MPI_Mprobe(source, sized_tag, ranks_->handle(), &message, &status), "MPI_Mprobe");
    check_mpi(MPI_Get_count(&status, MPI_BYTE, &length), "MPI_Get_count");
    const std::size_t first = sized_.size();
    sized_.resize(first + static_cast<std::size_t>(length));
    check_mpi(MPI_Mrecv(sized_.data() + first, length, MPI_BYTE, &message, MPI_STATUS_IGNORE), "MPI_Mrecv");
  } while (length == message_limit_);
}

std::span<const std::byte> DataExchange::exchange_sized_bytes(const ExchangePlan& partners,
                                                              const std::vector<int>& counts, const std::byte* items,
                                                              std::size_t item_bytes) {
  if (!requests_.empty()) throw std::logic_error("an exchange was begun (the one before it has not ended)");
  if (counts.size() != partners.to.size()) throw std::logic_error("an exchange needs a count for each of its partners");
  std::span<const std::byte> own;
  for (std::size_t r = 0; r < partners.to.size(); ++r) {
    const std::size_t bytes = static_cast<std::size_t>(counts[r]) * item_bytes;
    if (partners.to[r].rank == ranks_->rank()) {
      own = {items, bytes};
    } else {
      auto left = static_cast<std::int64_t>(bytes);
      const std::byte* next = items;
      for (; left >= message_limit_; left -= message_limit_, next += message_limit_)
        begin_message(next, static_cast<int>(message_limit_), partners.to[r].rank, sized_tag);
      begin_message(next, static_cast<int>(left), partners.to[r].rank, sized_tag);
    }
    items += bytes;
  }
  sized_.clear();
  {
    const WaitScope waits;  // one for all: reading the clock of a thread takes half a microsecond
    for (const PeerRun& run : partners.from) {
      if (run.rank == ranks_->rank())
        sized_.insert(sized_.end(), own.begin(), own.end());
      else
        receive_sized(run.rank);
    }
    check_mpi(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  }
  requests_.clear();
  return sized_;
}

}  // namespace percuss
