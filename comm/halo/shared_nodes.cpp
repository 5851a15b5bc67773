#include "comm/halo/shared_nodes.hpp"

#include <algorithm>
#include <tuple>

#include "comm/all_reduce.hpp"
#include "comm/exchange/data_exchange.hpp"

namespace percuss {

namespace {

/// A node as its holder knows it: the index in the message to the home identifies the local node.
struct Holding {
  std::int64_t id = 0;
  int rank = 0;
  std::int64_t place = 0;
  friend auto operator<=>(const Holding&, const Holding&) = default;
};

/// Message to a holder: another rank holds the node too.
struct Sighting {
  std::int64_t place = 0;
  int other_rank = 0;
};

/// A node shared with one neighbour.
struct Sharing {
  int rank = 0;
  std::int64_t id = 0;
  int node = 0;
  friend auto operator<=>(const Sharing&, const Sharing&) = default;
};

/// The home of each id: the range of all ids is cut into as many equal ranges as there are ranks.
std::vector<int> find_homes(const Communicator& ranks, const std::vector<std::int64_t>& ids) {
  std::int64_t end = 1;
  for (const std::int64_t id : ids) end = std::max(end, id + 1);
  all_reduce(ranks, Reduce::largest, end);
  const std::int64_t range = (end + ranks.size() - 1) / ranks.size();
  std::vector<int> homes(ids.size());
  std::transform(ids.begin(), ids.end(), homes.begin(), [&](std::int64_t id) { return static_cast<int>(id / range); });
  return homes;
}

/// Data received by a home, in ascending id and rank.
std::vector<Holding> sort_holdings(const ExchangePlan& plan, const std::vector<std::int64_t>& ids) {
  std::vector<Holding> holdings;
  holdings.reserve(ids.size());
  for (const PeerRun& run : plan.from) {
    for (std::int64_t place = 0; place < run.count; ++place) {
      holdings.push_back({ids[static_cast<std::size_t>(run.first + place)], run.rank, place});
    }
  }
  std::sort(holdings.begin(), holdings.end());
  return holdings;
}

/// Lists, for every holder of an id, one sighting of each other holder, with the rank that it is for.
void report_sightings(const std::vector<Holding>& holdings, std::vector<int>& for_rank,
                      std::vector<Sighting>& sightings) {
  for (auto begin = holdings.begin(); begin != holdings.end();) {
    const auto end = std::find_if(begin, holdings.end(), [&](const Holding& h) { return h.id != begin->id; });
    for (auto holder = begin; holder != end; ++holder) {
      for (auto other = begin; other != end; ++other) {
        if (other == holder) continue;
        for_rank.push_back(holder->rank);
        sightings.push_back({holder->place, other->rank});
      }
    }
    begin = end;
  }
}

SharedNodes gather_by_neighbour(std::vector<Sharing> sharings, std::size_t node_count, int me) {
  SharedNodes shared;
  shared.owners.assign(node_count, me);
  shared.first.push_back(0);
  std::sort(sharings.begin(), sharings.end());
  for (const Sharing& s : sharings) {
    if (shared.ranks.empty() || shared.ranks.back() != s.rank) {
      shared.ranks.push_back(s.rank);
      shared.first.push_back(shared.first.back());
    }
    shared.nodes.push_back(s.node);
    ++shared.first.back();
    int& owner = shared.owners[static_cast<std::size_t>(s.node)];
    owner = std::min(owner, s.rank);
  }
  return shared;
}

}  // namespace

SharedNodes find_shared_nodes(UnstructuredExchange& exchange, const std::vector<std::int64_t>& node_ids) {
  DataExchange data(exchange.ranks());
  const SendOrder to_homes = order_by_destination(find_homes(exchange.ranks(), node_ids));
  const ExchangePlan home_plan = exchange.plan(to_homes.to);
  std::vector<std::int64_t> ids;
  for (const int node : to_homes.items) ids.push_back(node_ids[static_cast<std::size_t>(node)]);
  const std::vector<Holding> holdings = sort_holdings(home_plan, data.exchange(home_plan, ids));

  std::vector<int> for_rank;
  std::vector<Sighting> sightings, ordered;
  report_sightings(holdings, for_rank, sightings);
  const SendOrder to_holders = order_by_destination(for_rank);
  for (const int s : to_holders.items) ordered.push_back(sightings[static_cast<std::size_t>(s)]);
  const ExchangePlan holder_plan = exchange.plan(to_holders.to);
  const std::vector<Sighting> answers = data.exchange(holder_plan, ordered);

  std::vector<Sharing> sharings;
  for (const PeerRun& home : holder_plan.from) {
    const auto sent = std::find_if(home_plan.to.begin(), home_plan.to.end(),
                                   [&](const PeerRun& run) { return run.rank == home.rank; });
    for (std::int64_t i = home.first; i < home.first + home.count; ++i) {
      const Sighting& s = answers[static_cast<std::size_t>(i)];
      const int node = to_homes.items[static_cast<std::size_t>(sent->first + s.place)];
      sharings.push_back({s.other_rank, node_ids[static_cast<std::size_t>(node)], node});
    }
  }
  return gather_by_neighbour(std::move(sharings), node_ids.size(), exchange.ranks().rank());
}

}  // namespace percuss
