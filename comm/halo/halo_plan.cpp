#include "comm/halo/halo_plan.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "comm/exchange/data_exchange.hpp"
#include "kernels/core/counting_sort.hpp"

namespace percuss {

namespace {

/// A slot as a neighbour needs to know it.
struct SlotNotice {
  std::int64_t order = 0;
  std::int64_t shared_node = 0;  // place of its node among those shared with that neighbour
};

/// The slots of each node, in ascending order of their place in its sum. nodes, orders: [slots].
SlotLists list_slots(std::size_t node_count, const std::vector<int>& nodes, const std::vector<std::int64_t>& orders) {
  Buckets by_node = sort_into_buckets(nodes, node_count);
  SlotLists lists{std::move(by_node.first), std::move(by_node.items)};
  for (std::size_t n = 0; n < node_count; ++n) {
    std::sort(lists.slots.begin() + lists.first[n], lists.slots.begin() + lists.first[n + 1],
              [&](int a, int b) { return orders[static_cast<std::size_t>(a)] < orders[static_cast<std::size_t>(b)]; });
  }
  return lists;
}

/// Lists what every neighbour is sent, slot by slot, with the notices that say so. Returns the runs.
std::vector<PeerRun> list_sent_slots(const SharedNodes& shared, const SlotLists& local, const LocalSlots& slots,
                                     std::vector<int>& send_slots, std::vector<SlotNotice>& notices) {
  std::vector<PeerRun> to;
  for (std::size_t r = 0; r < shared.ranks.size(); ++r) {
    const auto begin = static_cast<std::int64_t>(send_slots.size());
    for (int i = shared.first[r]; i < shared.first[r + 1]; ++i) {
      const auto node = static_cast<std::size_t>(shared.nodes[static_cast<std::size_t>(i)]);
      for (int s = local.first[node]; s < local.first[node + 1]; ++s) {
        const int slot = local.slots[static_cast<std::size_t>(s)];
        send_slots.push_back(slot);
        notices.push_back({slots.orders[static_cast<std::size_t>(slot)], i - shared.first[r]});
      }
    }
    to.push_back({shared.ranks[r], begin, static_cast<std::int64_t>(send_slots.size()) - begin});
  }
  return to;
}

/// Adds the received slots after the local ones.
LocalSlots append_remote_slots(LocalSlots slots, const SharedNodes& shared, const ExchangePlan& plan,
                               const std::vector<SlotNotice>& notices) {
  for (const PeerRun& run : plan.from) {
    const auto neighbour = std::lower_bound(shared.ranks.begin(), shared.ranks.end(), run.rank) - shared.ranks.begin();
    const int first = shared.first[static_cast<std::size_t>(neighbour)];
    for (std::int64_t i = run.first; i < run.first + run.count; ++i) {
      const SlotNotice& notice = notices[static_cast<std::size_t>(i)];
      slots.nodes.push_back(shared.nodes[static_cast<std::size_t>(first + notice.shared_node)]);
      slots.orders.push_back(notice.order);
    }
  }
  return slots;
}

}  // namespace

Halo build_halo(UnstructuredExchange& exchange, const SharedNodes& shared, const LocalSlots& slots) {
  const std::size_t node_count = shared.owners.size();
  Halo halo;
  halo.plan.first_remote_slot = static_cast<int>(slots.nodes.size());
  std::vector<SlotNotice> notices;
  const SlotLists local = list_slots(node_count, slots.nodes, slots.orders);
  halo.plan.exchange = exchange.plan(list_sent_slots(shared, local, slots, halo.plan.send_slots, notices));
  DataExchange data(exchange.ranks());
  const std::vector<SlotNotice> received = data.exchange(halo.plan.exchange, notices);
  const LocalSlots all = append_remote_slots(slots, shared, halo.plan.exchange, received);
  halo.nodes_to_slots = list_slots(node_count, all.nodes, all.orders);
  return halo;
}

std::vector<char> mark_sending_chunks(const HaloPlan& plan, const std::vector<int>& first_slot) {
  std::vector<char> sends(first_slot.size() - 1, 0);
  for (const int slot : plan.send_slots) {
    // Slots past the chunks' belong to something else, such as pressure faces.
    const auto after = std::upper_bound(first_slot.begin(), first_slot.end(), slot);
    if (after != first_slot.end()) sends[static_cast<std::size_t>(after - first_slot.begin() - 1)] = 1;
  }
  return sends;
}

}  // namespace percuss
