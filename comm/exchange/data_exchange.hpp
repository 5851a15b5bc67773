#pragma once
// Moves data along a plan: step (2.6) of the paper, "send and receive messages".
//
// begin() posts everything and returns, end() waits: work that needs none of the data goes between. The plan, the
// buffers and the messages under way are three things with three owners: the caller keeps the first two alive until
// end(). After the first exchange of a pattern nothing is allocated.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/exchange/exchange_plan.hpp"

namespace percuss {

/// Messages and bytes sent to other ranks.
struct Traffic {
  std::int64_t messages = 0;
  std::int64_t bytes = 0;
};

class DataExchange {
 public:
  /// MPI counts with an int: more than this goes as several messages. 1 GiB.
  static constexpr std::int64_t longest_message = std::int64_t{1} << 30;

  /// message_limit: longest message in bytes; tests lower it. Collective over `ranks`. Throws MpiError.
  explicit DataExchange(const Communicator& ranks, std::int64_t message_limit = longest_message)
      : ranks_(OwnedCommunicator::duplicate(ranks)), message_limit_(message_limit) {}

  /// Waits for what is still under way: no message may write into memory that is gone.
  ~DataExchange();
  DataExchange(const DataExchange&) = delete;
  DataExchange& operator=(const DataExchange&) = delete;

  /// Starts an exchange. send: [plan.send_count()], receive: [plan.receive_count()] items, not overlapping, on the
  /// host. The send buffer must not change and the receive buffer must not be read before end(); the plan is read by
  /// this call alone. One exchange at a time; every rank of the plan calls it, in the same order of exchanges. Throws
  /// MpiError.
  template <class T>
  void begin(const ExchangePlan& plan, std::span<const T> send, std::span<T> receive) {
    static_assert(std::is_trivially_copyable_v<T>, "items travel as bytes");
    check_room(plan, send.size(), receive.size());
    begin_bytes(plan, reinterpret_cast<const std::byte*>(send.data()), reinterpret_cast<std::byte*>(receive.data()),
                sizeof(T));
  }

  /// Returns when all items have been sent and received. Throws MpiError.
  void end();

  /// begin() and end() with a receive buffer of its own. Returns the received items.
  template <class T>
  std::vector<T> exchange(const ExchangePlan& plan, const std::vector<T>& send) {
    std::vector<T> receive(static_cast<std::size_t>(plan.receive_count()));
    begin<T>(plan, send, receive);
    end();
    return receive;
  }

  /// Sends items in numbers that the receivers do not know, between the ranks of a plan made for something else: one
  /// message to each, empty where there is nothing for it. counts: [partners.to] items for each; items: in the order of
  /// these. Returns the received items by source rank, then as sent. Every rank of the plan calls it. Throws MpiError.
  template <class T>
  std::vector<T> exchange_sized(const ExchangePlan& partners, const std::vector<int>& counts,
                                const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>, "items travel as bytes");
    const std::span<const std::byte> received =
        exchange_sized_bytes(partners, counts, reinterpret_cast<const std::byte*>(items.data()), sizeof(T));
    std::vector<T> result(received.size() / sizeof(T));
    if (!result.empty()) std::memcpy(result.data(), received.data(), received.size());
    return result;
  }

  /// Messages sent since construction.
  const Traffic& traffic() const { return traffic_; }

 private:
  void check_room(const ExchangePlan& plan, std::size_t send, std::size_t receive) const;
  void begin_bytes(const ExchangePlan& plan, const std::byte* send, std::byte* receive, std::size_t item_bytes);
  std::span<const std::byte> exchange_sized_bytes(const ExchangePlan& partners, const std::vector<int>& counts,
                                                  const std::byte* items, std::size_t item_bytes);
  void receive_sized(int source);
  void begin_receive(const PeerRun& run, std::byte* buffer, std::size_t item_bytes);
  void begin_send(const PeerRun& run, const std::byte* buffer, std::size_t item_bytes);
  void begin_message(const std::byte* data, int length, int rank, int tag);

  OwnedCommunicator ranks_;
  std::int64_t message_limit_;
  std::vector<MPI_Request> requests_;
  std::vector<std::byte> sized_;  // as received last
  Traffic traffic_;
};

}  // namespace percuss
