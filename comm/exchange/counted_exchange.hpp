#pragma once
// Messages to ranks that know how many will send to them, but not which, nor how much: one message to each receiver,
// without the size messages of a plan (unstructured_exchange.hpp).

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "comm/exchange/data_exchange.hpp"

namespace percuss {

class CountedExchange {
 public:
  /// message_limit: longest message in bytes; tests lower it. Collective over `ranks`. Throws MpiError.
  explicit CountedExchange(const Communicator& ranks, std::int64_t message_limit = DataExchange::longest_message)
      : ranks_(OwnedCommunicator::duplicate(ranks)), message_limit_(message_limit) {}

  /// Sends items along runs, none of them empty or to this rank, and receives what `senders` ranks send here. Returns
  /// it by source rank, then as sent; from: out, its runs. Between two exchanges all ranks must have met in a
  /// collective operation, such as the one that counts the senders. Throws MpiError.
  template <class T>
  std::vector<T> exchange(const std::vector<PeerRun>& to, const std::vector<T>& items, int senders,
                          std::vector<PeerRun>& from) {
    static_assert(std::is_trivially_copyable_v<T>, "items travel as bytes");
    exchange_bytes(to, reinterpret_cast<const std::byte*>(items.data()), sizeof(T), senders);
    std::vector<T> received;
    from.clear();
    for (const Message& message : messages_) {
      const std::size_t before = received.size(), count = message.bytes.size() / sizeof(T);
      received.resize(before + count);
      if (count > 0) std::memcpy(received.data() + before, message.bytes.data(), message.bytes.size());
      from.push_back({message.rank, static_cast<std::int64_t>(before), static_cast<std::int64_t>(count)});
    }
    return received;
  }

  /// Messages sent since construction.
  const Traffic& traffic() const { return traffic_; }

 private:
  struct Message {
    int rank = 0;
    std::vector<std::byte> bytes;
  };

  /// Fills messages_, ascending in rank.
  void exchange_bytes(const std::vector<PeerRun>& to, const std::byte* items, std::size_t item_bytes, int senders);
  void send(const PeerRun& run, const std::byte* items, std::size_t item_bytes);
  Message receive() const;

  OwnedCommunicator ranks_;
  std::int64_t message_limit_;
  std::vector<MPI_Request> requests_;
  std::vector<Message> messages_;
  Traffic traffic_;
};

}  // namespace percuss
