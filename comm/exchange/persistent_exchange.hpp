#pragma once
// An exchange that is repeated with the same plan and the same buffers, such as one in each iteration: one message to
// each neighbour, by requests that MPI prepares once (MPI_Send_init, MPI_Startall).
//
// data_exchange.hpp is for everything else.

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "comm/exchange/data_exchange.hpp"

namespace percuss {

class PersistentExchange {
 public:
  /// message_limit: longest message in bytes; tests lower it. Collective over `ranks`. Throws MpiError.
  explicit PersistentExchange(const Communicator& ranks, std::int64_t message_limit = DataExchange::longest_message)
      : ranks_(OwnedCommunicator::duplicate(ranks)), message_limit_(message_limit) {}

  /// Waits for what is still under way.
  ~PersistentExchange();
  PersistentExchange(const PersistentExchange&) = delete;
  PersistentExchange& operator=(const PersistentExchange&) = delete;

  /// Fixes the plan, which has no run of this rank itself, and the buffers: host memory that stays where it is until
  /// prepare() is called again. send: [plan.send_count()], receive: [plan.receive_count()] items, not overlapping.
  /// Prepares nothing where all of it is as it was. Not collective. Throws MpiError.
  template <class T>
  void prepare(const ExchangePlan& plan, std::span<const T> send, std::span<T> receive) {
    static_assert(std::is_trivially_copyable_v<T>, "items travel as bytes");
    prepare_bytes(plan, {std::as_bytes(send), std::as_writable_bytes(receive), sizeof(T)});
  }

  /// Starts the messages: the send buffer must not change and the receive buffer must not be read before end(). Every
  /// rank of the plan calls it. Throws MpiError.
  void begin();

  /// Returns when all items have been sent and received. Throws MpiError.
  void end();

  /// Messages sent since construction.
  const Traffic& traffic() const { return traffic_; }

  /// How often requests were prepared.
  int preparations() const { return preparations_; }

 private:
  struct Buffers {
    std::span<const std::byte> send;
    std::span<std::byte> receive;
    std::size_t item_bytes = 0;

    bool is_same(const Buffers& other) const {
      return send.data() == other.send.data() && receive.data() == other.receive.data() &&
             send.size() == other.send.size() && receive.size() == other.receive.size() &&
             item_bytes == other.item_bytes;
    }
  };

  void prepare_bytes(const ExchangePlan& plan, const Buffers& buffers);
  void free_requests();

  OwnedCommunicator ranks_;
  std::int64_t message_limit_;
  ExchangePlan plan_;
  Buffers buffers_;
  std::vector<MPI_Request> requests_;
  bool is_under_way_ = false;
  Traffic once_, traffic_;  // of one exchange, of all
  int preparations_ = 0;
};

}  // namespace percuss
