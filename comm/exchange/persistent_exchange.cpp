#include "comm/exchange/persistent_exchange.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace percuss {

namespace {

constexpr int persistent_tag = 1;

/// Calls make(offset, length) for the messages that a run is cut into, in bytes.
template <class Make>
void for_each_message(const PeerRun& run, std::size_t item_bytes, std::int64_t limit, const Make& make) {
  const auto size = static_cast<std::int64_t>(item_bytes);
  const std::int64_t end = (run.first + run.count) * size;
  for (std::int64_t offset = run.first * size; offset < end; offset += limit)
    make(offset, static_cast<int>(std::min(limit, end - offset)));
}

void refuse_own_runs(const std::vector<PeerRun>& runs, int own) {
  for (const PeerRun& run : runs)
    if (run.rank == own) throw std::logic_error("a repeated exchange has a run of the rank itself");
}

}  // namespace

// As in ~MpiSession, a failure here cannot be reported.
PersistentExchange::~PersistentExchange() {
  if (is_under_way_) MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (MPI_Request& request : requests_) MPI_Request_free(&request);
}

void PersistentExchange::free_requests() {
  for (MPI_Request& request : requests_) check_mpi(MPI_Request_free(&request), "MPI_Request_free");
  requests_.clear();
}

// Receives first, so that messages find their buffers.
void PersistentExchange::prepare_bytes(const ExchangePlan& plan, const Buffers& buffers) {
  if (is_under_way_) throw std::logic_error("a repeated exchange was prepared (the one before it has not ended)");
  if (preparations_ > 0 && buffers.is_same(buffers_) && plan.to == plan_.to && plan.from == plan_.from) return;
  const auto size = static_cast<std::int64_t>(buffers.item_bytes);
  if (static_cast<std::int64_t>(buffers.send.size()) < plan.send_count() * size ||
      static_cast<std::int64_t>(buffers.receive.size()) < plan.receive_count() * size)
    throw std::logic_error("buffers of " + std::to_string(buffers.send.size()) + " and " +
                           std::to_string(buffers.receive.size()) + " bytes are too short for an exchange");
  refuse_own_runs(plan.to, ranks_->rank());
  refuse_own_runs(plan.from, ranks_->rank());
  free_requests();
  once_ = {};
  plan_ = plan;
  buffers_ = buffers;
  ++preparations_;
  for (const PeerRun& run : plan.from)
    for_each_message(run, buffers.item_bytes, message_limit_, [&](std::int64_t offset, int length) {
      requests_.push_back(MPI_REQUEST_NULL);
      check_mpi(MPI_Recv_init(buffers.receive.data() + offset, length, MPI_BYTE, run.rank, persistent_tag,
                              ranks_->handle(), &requests_.back()),
                "MPI_Recv_init");
    });
  for (const PeerRun& run : plan.to)
    for_each_message(run, buffers.item_bytes, message_limit_, [&](std::int64_t offset, int length) {
      requests_.push_back(MPI_REQUEST_NULL);
      check_mpi(MPI_Send_init(buffers.send.data() + offset, length, MPI_BYTE, run.rank, persistent_tag,
                              ranks_->handle(), &requests_.back()),
                "MPI_Send_init");
      ++once_.messages;
      once_.bytes += length;
    });
}

void PersistentExchange::begin() {
  if (is_under_way_) throw std::logic_error("a repeated exchange was begun (the one before it has not ended)");
  if (!requests_.empty()) check_mpi(MPI_Startall(static_cast<int>(requests_.size()), requests_.data()), "MPI_Startall");
  is_under_way_ = true;
  traffic_.messages += once_.messages;
  traffic_.bytes += once_.bytes;
}

void PersistentExchange::end() {
  if (!requests_.empty())
    wait_mpi([&] { return MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); },
             "MPI_Waitall");
  is_under_way_ = false;
}

}  // namespace percuss
