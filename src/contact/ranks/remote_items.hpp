#pragma once
// Items that a rank requests from others by number, and subsets of them that it requests again without naming them.

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "comm/exchange/item_exchange.hpp"

namespace percuss {

/// The named items that are requested: in messages, and on this rank.
struct ItemPart {
  ExchangePlan request;         // to those who have the items, from those who asked this rank; without this rank
  std::vector<int> asked;       // item k of the answers is the asker's item asked[k]
  std::vector<int> published;   // places, where they are, of the items that this rank sends, as in its messages
  std::vector<int> own;         // the asker's items that this rank has itself...
  std::vector<int> own_places;  // ... and their places
};

class RemoteItems {
 public:
  /// owners: [numbers] the rank that has each; find(number): its place there, >= 0, requested in the order of the
  /// numbers of one asker after the other. Collective. Throws MpiError.
  template <class Find>
  void name(UnstructuredExchange& exchange, DataExchange& data, const std::vector<int>& owners,
            const std::vector<std::int64_t>& numbers, Find&& find) {
    const int rank = exchange.ranks().rank();
    all_ = {};
    std::vector<int> of_others, to;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (owners[i] == rank) {
        all_.own.push_back(static_cast<int>(i));
        all_.own_places.push_back(find(numbers[i]));
      } else {
        of_others.push_back(static_cast<int>(i));
        to.push_back(owners[i]);
      }
    }
    const SendOrder order = order_by_destination(to);
    std::vector<std::int64_t> sent;
    sent.reserve(order.items.size());
    for (const int k : order.items) {
      all_.asked.push_back(of_others[static_cast<std::size_t>(k)]);
      sent.push_back(numbers[static_cast<std::size_t>(all_.asked.back())]);
    }
    all_.request = exchange.plan(order.to);
    for (const std::int64_t number : data.exchange(all_.request, sent)) all_.published.push_back(find(number));
  }

  const ItemPart& all() const { return all_; }

  /// The items requested. is_wanted: [numbers]. One message to each rank of the request. Collective. Throws MpiError.
  ItemPart select(DataExchange& data, const std::vector<char>& is_wanted) const {
    return select_among(all_, data, is_wanted);
  }
  /// As select(), of a part that was requested before and holds all that is wanted: only its ranks send messages.
  static ItemPart select_among(const ItemPart& part, DataExchange& data, const std::vector<char>& is_wanted);

 private:
  ItemPart all_;
};

/// Sends records to partners, those of a plan and this rank itself. to: [records] rank that each goes to. Returns what
/// is for this rank: its own in their order, then those of others by rank, as sent. Every rank of the plan calls it.
/// Throws MpiError; std::logic_error if a record goes to a rank that is no partner.
template <class Record>
std::vector<Record> send_to_partners(DataExchange& data, int own_rank, const ExchangePlan& partners,
                                     const std::vector<int>& to, std::vector<Record> records) {
  std::vector<int> destinations;
  std::vector<Record> of_others;
  std::size_t own = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (to[i] != own_rank) {
      destinations.push_back(to[i]);
      of_others.push_back(records[i]);
    } else {
      if (own != i) records[own] = records[i];
      ++own;
    }
  }
  records.resize(own);
  const SendOrder order = order_by_destination(destinations);
  std::vector<int> counts;
  auto run = order.to.begin();
  for (const PeerRun& partner : partners.to) {  // ranks ascend in both
    const bool has_some = run != order.to.end() && run->rank == partner.rank;
    counts.push_back(has_some ? static_cast<int>((run++)->count) : 0);
  }
  if (run != order.to.end()) throw std::logic_error("a record goes to a rank that is no partner");
  const std::vector<Record> received = data.exchange_sized(partners, counts, ItemExchange::arrange(order, of_others));
  records.insert(records.end(), received.begin(), received.end());
  return records;
}

}  // namespace percuss
