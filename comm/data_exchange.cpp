#include "comm/data_exchange.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace percuss {

namespace {

constexpr int data_tag = 1;

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
  for_each_piece(run, item_bytes, message_limit_, [&](std::int64_t offset, int length) {
    MPI_Request request = MPI_REQUEST_NULL;
    check_mpi(MPI_Isend(buffer + offset, length, MPI_BYTE, run.rank, data_tag, ranks_->handle(), &request),
              "MPI_Isend");
    requests_.push_back(request);
    ++traffic_.messages;
    traffic_.bytes += length;
  });
}

namespace {

/// What stays on this rank is copied without MPI.
void copy_own(const PeerRun& from, const PeerRun& to, const std::byte* send, std::byte* receive,
              std::size_t item_bytes) {
  std::memcpy(receive + static_cast<std::size_t>(to.first) * item_bytes,
              send + static_cast<std::size_t>(from.first) * item_bytes,
              static_cast<std::size_t>(from.count) * item_bytes);
}

}  // namespace

// Receives first, so that messages find their place.
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

}  // namespace percuss
