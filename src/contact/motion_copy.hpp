#pragma once
// What a rank asks others for by number, and gets in every step until it asks again: places and velocities of nodes.

#include <cstdint>
#include <vector>

#include "comm/item_exchange.hpp"
#include "src/contact/contact_finder.hpp"

namespace percuss {

/// Items asked for by number, from those who have them; `order` puts what comes back to its place.
struct Subscription {
  ExchangePlan request;        // to those who have the items
  std::vector<int> order;      // item k of the messages is the asker's item order[k]
  std::vector<int> published;  // the places, where they are, of the items that this rank sends, as in its messages
};

/// owners: [numbers] the rank that has each; find(number): its place there. Collective.
template <class Find>
Subscription subscribe(UnstructuredExchange& exchange, DataExchange& data, const std::vector<int>& owners,
                       const std::vector<std::int64_t>& numbers, const Find& find) {
  SendOrder order = order_by_destination(owners);
  const std::vector<std::int64_t> ordered = ItemExchange::arrange(order, numbers);
  Subscription made;
  made.request = exchange.plan(order.to);
  made.order = std::move(order.items);
  for (const std::int64_t number : data.exchange(made.request, ordered)) made.published.push_back(find(number));
  return made;
}

/// The motion of nodes that other ranks own, one row a node.
class MotionCopy {
 public:
  /// Asks the FE owners of the nodes, by number, for their motion from now on. Collective.
  void ask(const ContactRanks& ranks, UnstructuredExchange& exchange, DataExchange& data,
           const std::vector<std::int64_t>& numbers);

  /// Their motion in this step; rows as asked for. motion: of this rank's mesh nodes. Collective.
  SurfaceMotion receive(DataExchange& data, const SurfaceMotion& motion);

 private:
  Subscription nodes_;
  Array<int> order_ = Array<int>("contact::motion_order", 0);
  Array<int> published_ = Array<int>("contact::published_nodes", 0);
  Rows3<double> x_ = Rows3<double>("contact::check_x", 0), v_ = Rows3<double>("contact::check_v", 0);
};

}  // namespace percuss
