#include "src/contact/enforcement/shared_entries.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// A slot of a touch with a foreign node.
struct ForeignSlot {
  RowNotice notice;
  int owner = 0, slot = 0, entry = 0;
};

std::vector<ForeignSlot> list_foreign_slots(const Numbering& numbering, const Array<const RowTouch>& touches,
                                            int num_touches) {
  const auto list = to_host(touches);
  std::vector<ForeignSlot> slots;
  for (int r = 0; r < num_touches; ++r) {
    for (int slot = 0; slot < list(r).count; ++slot) {
      if (list(r).node[slot] >= 0) continue;
      const RowNotice notice{list(r).node_number[slot], list(r).key};
      slots.push_back(
          {notice, numbering.find_node_owner(notice.node), static_cast<int>(slots.size()), r * row_nodes + slot});
    }
  }
  return slots;
}

/// Appends an item of a rank to runs that ascend in rank.
void extend_runs(int rank, std::vector<PeerRun>& runs) {
  const std::int64_t next = runs.empty() ? 0 : runs.back().first + runs.back().count;
  if (runs.empty() || runs.back().rank != rank) runs.push_back({rank, next, 0});
  ++runs.back().count;
}

/// Entries that are sent to one rank, or received from it.
struct Peer {
  std::vector<int> sent;
  std::vector<std::int64_t> key;
  std::vector<int> place;
};

/// The entries of one node: this rank's go to all others who have it, theirs come here.
void swap_node(const SharedEntry* first, const SharedEntry* end, int own_rank, std::map<int, Peer>& peers) {
  std::vector<int> ranks{first->owner};
  for (const SharedEntry* e = first; e != end; ++e) ranks.push_back(e->rank);
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  for (const SharedEntry* e = first; e != end; ++e) {
    if (e->rank != own_rank) {
      peers[e->rank].key.push_back(e->key);
      peers[e->rank].place.push_back(e->place);
      continue;
    }
    for (const int rank : ranks)
      if (rank != own_rank) peers[rank].sent.push_back(e->entry);
  }
}

void add_run(int rank, std::size_t first, std::size_t count, std::vector<PeerRun>& runs) {
  if (count > 0) runs.push_back({rank, static_cast<std::int64_t>(first), static_cast<std::int64_t>(count)});
}

}  // namespace

ForeignNodes find_foreign_nodes(const ContactRanks& ranks, const Array<const RowTouch>& touches, int num_touches) {
  std::vector<ForeignSlot> slots = list_foreign_slots(ranks.numbering, touches, num_touches);
  std::stable_sort(slots.begin(), slots.end(), [](const ForeignSlot& a, const ForeignSlot& b) {
    return a.owner != b.owner ? a.owner < b.owner : a.notice.node < b.notice.node;
  });
  ForeignNodes found;
  found.of_slot.resize(slots.size());
  for (const ForeignSlot& slot : slots) {
    if (found.numbers.empty() || found.numbers.back() != slot.notice.node) {
      found.numbers.push_back(slot.notice.node);
      extend_runs(slot.owner, found.owners);
    }
    found.of_slot[at(slot.slot)] = static_cast<int>(found.numbers.size()) - 1;
    found.notices.push_back(slot.notice);
    found.entries.push_back(slot.entry);
    extend_runs(slot.owner, found.notice_runs);
  }
  return found;
}

SwapLists list_swaps(std::vector<SharedEntry> entries, int own_rank) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SharedEntry& a, const SharedEntry& b) { return a.node < b.node; });
  std::map<int, Peer> peers;
  for (std::size_t first = 0, end = 0; first < entries.size(); first = end) {
    while (end < entries.size() && entries[end].node == entries[first].node) ++end;
    swap_node(&entries[first], entries.data() + end, own_rank, peers);
  }
  SwapLists lists;
  for (const auto& [rank, peer] : peers) {
    add_run(rank, lists.sent.size(), peer.sent.size(), lists.plan.to);
    add_run(rank, lists.key.size(), peer.key.size(), lists.plan.from);
    lists.sent.insert(lists.sent.end(), peer.sent.begin(), peer.sent.end());
    lists.key.insert(lists.key.end(), peer.key.begin(), peer.key.end());
    lists.place.insert(lists.place.end(), peer.place.begin(), peer.place.end());
  }
  return lists;
}

std::vector<SharedEntry> list_own_entries(const ContactRanks& ranks, const RowSources& sources, const RowSystem& system,
                                          const std::vector<char>& is_touched) {
  const auto touches = to_host(sources.touches);
  const auto place = to_host(system.place_of_node);
  const int own = ranks.ranks.rank();
  std::vector<SharedEntry> entries;
  const auto add = [&](int node, std::int64_t key, int entry) {
    entries.push_back({ranks.mesh.node_numbers[at(node)], key, own, place(at(node)), own, entry});
  };
  for (int r = 0; r < sources.num_touches; ++r) {
    for (int slot = 0; slot < touches(r).count; ++slot) {
      const int node = touches(r).node[slot];
      if (node >= 0 && is_touched[at(node)] != 0) add(node, touches(r).key, r * row_nodes + slot);
    }
  }
  if (system.num_rows == sources.num_touches) return entries;
  const auto near_walls = to_host(system.near_walls);
  const auto nodes = to_host(sources.walls.node), walls = to_host(sources.walls.wall);
  for (int r = sources.num_touches; r < system.num_rows; ++r) {
    const auto pair = at(near_walls(at(r - sources.num_touches)));
    const int node = nodes(pair);
    if (is_touched[at(node)] == 0) continue;
    add(node, make_wall_row_key(ranks.mesh.node_numbers[at(node)], walls(pair)), r * row_nodes);
  }
  return entries;
}

HostRowNodes::HostRowNodes(const RowSystem& system)
    : x_(to_host(system.at.x)),
      v_(to_host(system.at.v)),
      v_before_(to_host(system.at.v_before)),
      v_checked_(to_host(system.at.v_checked)),
      inverse_mass_(to_host(system.at.inverse_mass)),
      spring_(to_host(system.at.spring)),
      growth_(to_host(system.at.growth)),
      body_(to_host(system.bodies.of_place)),
      has_springs_(spring_.extent(0) > 0),
      has_bodies_(system.bodies.count() > 0) {}

NodeAnswer HostRowNodes::get(int place) const {
  const auto a = at(place);
  NodeAnswer answer{};
  for (std::size_t d = 0; d < 3; ++d) {
    answer.x[d] = x_(a, d);
    answer.v[d] = v_(a, d);
    answer.v_before[d] = v_before_(a, d);
    answer.v_checked[d] = v_checked_(a, d);
    answer.inverse_mass[d] = inverse_mass_(a, d);
  }
  answer.spring = has_springs_ ? spring_(a) : 0;
  answer.growth = has_springs_ ? growth_(a) : 1;
  answer.body = has_bodies_ ? body_(a) : -1;
  return answer;
}

void HostRowNodes::set(int place, const NodeAnswer& answer) {
  const auto a = at(place);
  for (std::size_t d = 0; d < 3; ++d) {
    x_(a, d) = answer.x[d];
    v_(a, d) = answer.v[d];
    v_before_(a, d) = answer.v_before[d];
    v_checked_(a, d) = answer.v_checked[d];
    inverse_mass_(a, d) = answer.inverse_mass[d];
  }
  if (has_springs_) {
    spring_(a) = answer.spring;
    growth_(a) = answer.growth;
  }
  if (has_bodies_) body_(a) = answer.body;
}

void HostRowNodes::write(RowSystem& system) const {
  copy_values(system.at.x, x_);
  copy_values(system.at.v, v_);
  copy_values(system.at.v_before, v_before_);
  copy_values(system.at.v_checked, v_checked_);
  copy_values(system.at.inverse_mass, inverse_mass_);
  if (has_springs_) {
    copy_values(system.at.spring, spring_);
    copy_values(system.at.growth, growth_);
  }
  if (has_bodies_) copy_values(system.bodies.of_place, body_);
}

}  // namespace percuss
