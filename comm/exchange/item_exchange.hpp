#pragma once
// One exchange of items that each know their destination, for set-up: plan, data and buffers in one call.

#include <cstddef>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"

namespace percuss {

class ItemExchange {
 public:
  /// Collective over `ranks`. Throws MpiError.
  explicit ItemExchange(const Communicator& ranks) : exchange_(ranks), data_(ranks) {}

  const Communicator& ranks() const { return exchange_.ranks(); }

  /// Sends items[i] to rank destinations[i]. Returns what was sent to this rank: by source rank, then as listed there.
  /// Collective. Throws MpiError.
  template <class T>
  std::vector<T> send(const std::vector<int>& destinations, const std::vector<T>& items) {
    const SendOrder order = order_by_destination(destinations);
    return data_.exchange(exchange_.plan(order.to), arrange(order, items));
  }

  /// Items in the order of a send buffer.
  template <class T>
  static std::vector<T> arrange(const SendOrder& order, const std::vector<T>& items) {
    std::vector<T> arranged;
    arranged.reserve(items.size());
    for (const int item : order.items) arranged.push_back(items[static_cast<std::size_t>(item)]);
    return arranged;
  }

 private:
  UnstructuredExchange exchange_;
  DataExchange data_;
};

}  // namespace percuss
