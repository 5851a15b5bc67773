#include "src/contact/history/carried_history.hpp"

#include <algorithm>
#include <numeric>

#include "comm/gather_items.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/core/views.hpp"
#include "src/contact/history/edge_records.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr int touches = contact_limits::max_touches;

/// A history on the host.
struct HostHistory {
  explicit HostHistory(const ContactHistory& history)
      : face(to_host(history.face)),
        impulse(to_host(history.impulse)),
        slip(to_host(history.slip)),
        reference(to_host(history.reference)),
        held(to_host(history.held)),
        to_push(to_host(history.to_push)),
        ties(to_host(history.ties)) {}

  void copy_record(std::size_t to, const HostHistory& from, std::size_t record) const {
    for (std::size_t k = 0; k < 3; ++k) {
      impulse(to, k) = from.impulse(record, k);
      slip(to, k) = from.slip(record, k);
    }
    reference(to) = from.reference(record);
    if (held.extent(0) > 0) held(to) = from.held(record);
    if (to_push.extent(0) > 0) to_push(to) = from.to_push(record);
  }

  void write_to(const ContactHistory& history) const {
    copy_values(history.face, face);
    copy_values(history.impulse, impulse);
    copy_values(history.slip, slip);
    copy_values(history.reference, reference);
    copy_values(history.held, held);
    copy_values(history.to_push, to_push);
    copy_values(history.ties, ties);
  }

  HostMirror<Array<std::int64_t>> face;
  HostMirror<Rows3<double>> impulse, slip;
  HostMirror<Array<double>> reference, held, to_push;
  HostMirror<Rows3<double>> ties;
};

void carry_nodes(const HostHistory& old, const HistoryOwners& before, const HistoryOwners& now, HostHistory& out) {
  for (std::size_t n = 0, o = 0; n < now.nodes.size(); ++n) {
    while (o < before.nodes.size() && before.nodes[o] < now.nodes[n]) ++o;
    if (o == before.nodes.size() || before.nodes[o] != now.nodes[n]) continue;
    for (std::size_t i = 0; i < touches; ++i) {
      out.face(touches * n + i) = old.face(touches * o + i);
      out.copy_record(touches * n + i, old, touches * o + i);
    }
  }
  const NumberMap places(before.wall_pairs);
  for (std::size_t p = 0; p < now.wall_pairs.size(); ++p) {
    const int o = places.find(now.wall_pairs[p]);
    if (o >= 0) out.copy_record(touches * now.nodes.size() + p, old, touches * before.nodes.size() + at(o));
  }
  for (std::size_t t = 0; t < now.ties.size(); ++t) {
    const int o = find_number(before.ties, now.ties[t]);
    for (std::size_t k = 0; o >= 0 && k < 3; ++k) out.ties(t, k) = old.ties(at(o), k);
  }
}

/// An edge by what stays of it.
struct EdgeName {
  std::int64_t number, ends[2], elements[2];

  explicit EdgeName(const EdgeTopology& edge)
      : number(edge.number), ends{edge.ends[0], edge.ends[1]}, elements{edge.elements[0], edge.elements[1]} {}
  EdgeName() = default;
  bool has_ends_of(const EdgeName& o) const { return ends[0] == o.ends[0] && ends[1] == o.ends[1]; }
  bool shares_element(const EdgeName& o) const {
    return elements[0] == o.elements[0] || elements[0] == o.elements[1] || elements[1] == o.elements[0] ||
           elements[1] == o.elements[1];
  }
};

bool is_before(const EdgeName& a, const EdgeName& b) {
  if (a.ends[0] != b.ends[0]) return a.ends[0] < b.ends[0];
  return a.ends[1] != b.ends[1] ? a.ends[1] < b.ends[1] : a.number < b.number;
}

/// Names of the edges whose number, or whose ends, some record of any rank has.
template <class IsWanted>
std::vector<EdgeName> gather_names(const Communicator& ranks, const std::vector<EdgeTopology>& edges,
                                   const IsWanted& is_wanted) {
  std::vector<EdgeName> names;
  for (const EdgeTopology& edge : edges)
    if (is_wanted(EdgeName(edge))) names.emplace_back(edge);
  names = gather_items(ranks, names);
  std::sort(names.begin(), names.end(), is_before);
  return names;
}

/// Where edges that records name are now: new number of each of `old`, -1 for one that is gone. Of several edges with
/// the same ends it is the one that shares an element.
std::vector<std::int64_t> find_new_numbers(const std::vector<EdgeName>& old, const std::vector<EdgeName>& now) {
  std::vector<std::int64_t> numbers;
  for (const EdgeName& name : old) {
    std::int64_t number = -1;
    const auto [first, last] = std::equal_range(now.begin(), now.end(), name, [](const EdgeName& a, const EdgeName& b) {
      return a.ends[0] != b.ends[0] ? a.ends[0] < b.ends[0] : a.ends[1] < b.ends[1];
    });
    for (auto edge = first; edge != last && number < 0; ++edge)
      if (edge->shares_element(name)) number = edge->number;
    numbers.push_back(number);
  }
  return numbers;
}

/// A record on its way to the new home of its edge.
struct SentRecord {
  std::int64_t a, b;
  double values[HeldRecords::value_count];
};

std::vector<SentRecord> gather_records(const Communicator& ranks, const EdgeHistory& history) {
  std::vector<SentRecord> records;
  if (history.count > 0) {
    const HeldRecords held = take_held(history);
    for (std::size_t r = 0; r < held.a.size(); ++r) {
      SentRecord record{held.a[r], held.b[r], {}};
      std::copy_n(held.values.begin() + static_cast<std::ptrdiff_t>(HeldRecords::value_count * r),
                  HeldRecords::value_count, record.values);
      records.push_back(record);
    }
  }
  return gather_items(ranks, records);
}

}  // namespace

ContactHistory make_history(const SurfaceShare& share, const WallPairs& walls, const ContactDeck& contact) {
  const auto faces = std::size_t{contact_limits::max_touches} * static_cast<std::size_t>(share.nodes.count());
  const std::size_t records = faces + walls.node.extent(0);
  ContactHistory history{
      Array<std::int64_t>("contact::history_face", faces), Rows3<double>("contact::history_impulse", records),
      Rows3<double>("contact::history_slip", records), Array<double>("contact::history_reference", records)};
  if (share.springs != SpringRows::none) history.held = Array<double>("contact::history_held", records);
  if (contact.overlap == ContactDeck::Overlap::push_out)
    history.to_push = Array<double>("contact::history_to_push", records);
  set_values(history.face, std::int64_t{-1});
  return history;
}

HistoryOwners list_history_owners(const ChunkedMesh& chunked, const SurfaceShare& share, const WallPairs& walls,
                                  const std::vector<std::int64_t>& tie_keys) {
  HistoryOwners owners;
  owners.nodes = share.nodes.numbers;
  for (const FaceTopology& face : share.faces) owners.faces.push_back(face.number);
  const auto wall = to_host(walls.wall), node = to_host(walls.node);
  for (std::size_t p = 0; p < wall.extent(0); ++p)
    owners.wall_pairs.push_back(wall(p) * chunked.numbering.node_count() + chunked.mesh.node_numbers[at(node(p))]);
  owners.ties = tie_keys;
  owners.edges = share.edges;
  return owners;
}

EdgeHistory carry_edges(const Communicator& ranks, const EdgeHistory& old, const std::vector<EdgeTopology>& before,
                        const std::vector<EdgeTopology>& now) {
  std::vector<SentRecord> records = gather_records(ranks, old);
  if (records.empty()) return {};
  std::vector<std::int64_t> used;
  for (const SentRecord& record : records) used.insert(used.end(), {record.a, record.b});
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const std::vector<EdgeName> old_names = gather_names(
      ranks, before, [&](const EdgeName& e) { return std::binary_search(used.begin(), used.end(), e.number); });
  const std::vector<EdgeName> new_names = gather_names(ranks, now, [&](const EdgeName& e) {
    EdgeName low = e;
    low.number = -1;
    const auto place = std::lower_bound(old_names.begin(), old_names.end(), low, is_before);
    return place != old_names.end() && place->has_ends_of(e);
  });
  const std::vector<std::int64_t> new_numbers = find_new_numbers(old_names, new_names);
  std::vector<std::int64_t> numbers_of_used(used.size(), -1);
  for (std::size_t i = 0; i < old_names.size(); ++i)
    numbers_of_used[at(find_number(used, old_names[i].number))] = new_numbers[i];
  std::vector<std::int64_t> own;
  own.reserve(now.size());
  for (const EdgeTopology& edge : now) own.push_back(edge.number);
  std::vector<SentRecord> kept;
  for (SentRecord& record : records) {
    record.a = numbers_of_used[at(find_number(used, record.a))];
    record.b = numbers_of_used[at(find_number(used, record.b))];
    if (record.b >= 0 && find_number(own, record.a) >= 0) kept.push_back(record);
  }
  std::sort(kept.begin(), kept.end(),
            [](const SentRecord& p, const SentRecord& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  HeldRecords held;
  for (const SentRecord& record : kept) {
    held.a.push_back(record.a);
    held.b.push_back(record.b);
    held.values.insert(held.values.end(), std::begin(record.values), std::end(record.values));
  }
  return make_edge_history(held);
}

ContactHistory carry_history(const Communicator& ranks, const ContactHistory& old, const HistoryOwners& before,
                             const HistoryOwners& now, ContactHistory history) {
  history.ties = Rows3<double>("contact::history_ties", now.ties.size());
  HostHistory out(history);
  carry_nodes(HostHistory(old), before, now, out);
  out.write_to(history);
  history.edges = carry_edges(ranks, old.edges, before.edges, now.edges);
  return history;
}

}  // namespace percuss
