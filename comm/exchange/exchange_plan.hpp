#pragma once
// Who sends how many items to whom: the pattern of an exchange, apart from its data and its buffers.
//
// An item is the unit that the caller exchanges (a contact node, a slot's force): a fixed number of bytes, chosen when
// data are sent. A plan is made once (comm/exchange/unstructured_exchange.hpp) and used for any number of exchanges
// (comm/exchange/data_exchange.hpp), in either direction.

#include <cstdint>
#include <vector>

namespace percuss {

/// A run of items, contiguous in a buffer, that goes to one rank or comes from one.
struct PeerRun {
  int rank = 0;
  std::int64_t first = 0;  // its first item in the buffer
  std::int64_t count = 0;  // items
  friend bool operator==(const PeerRun&, const PeerRun&) = default;
};

/// The pattern as one rank sees it. Runs follow each other without gaps, in ascending rank, none of them empty; the
/// rank itself may be among them. Received items therefore lie in a fixed order: by source rank, then as sent.
struct ExchangePlan {
  std::vector<PeerRun> to;    // runs of the send buffer
  std::vector<PeerRun> from;  // runs of the receive buffer

  std::int64_t send_count() const { return to.empty() ? 0 : to.back().first + to.back().count; }
  std::int64_t receive_count() const { return from.empty() ? 0 : from.back().first + from.back().count; }
};

/// The plan that carries answers back: what was received is sent, to where it came from.
ExchangePlan reverse(const ExchangePlan& plan);

/// Items in the order in which a send buffer holds them.
struct SendOrder {
  std::vector<int> items;   // [items] place k of the send buffer holds the caller's item items[k]
  std::vector<PeerRun> to;  // runs of the send buffer
};

/// Puts items in ascending order of destination; those of one destination keep their order.
/// destinations: [items] rank that each goes to. An item for several ranks is listed once for each by the caller.
/// Linear in the items; memory beyond the result grows with the number of different destinations only.
SendOrder order_by_destination(const std::vector<int>& destinations);

}  // namespace percuss
