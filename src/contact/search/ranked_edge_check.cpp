// The check of edge pairs in the contact decomposition, in every step: motion and history come from homes, touches go
// back.

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "src/contact/search/ranked_edges.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

/// A touch on its way to the home of its edge A.
struct RankedEdges::TouchRecord {
  std::int64_t a = -1, b = -1;  // numbers
  std::int64_t ends[4]{};       // numbers of the nodes of A and of B
  EdgeTouch touch;
  double friction = 0;
  int pair = 0;  // of surfaces
};

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A contact that is remembered, as the check reads it.
struct HistoryItem {
  std::int64_t a, b;
  double normal[3];
};

template <class Record>
bool comes_before(const Record& x, const Record& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

}  // namespace

/// What the homes remember of the paired edges' contacts: names, marks and normals.
EdgeHistory RankedEdges::receive_history(const EdgeHistory& history) {
  const auto a = to_host(history.a), b = to_host(history.b);
  const auto holds = to_host(history.holds);
  const auto normal = to_host(history.normal);
  std::vector<HistoryItem> items;
  const auto add_items_of = [&](int e) {
    const std::int64_t number = share_.edges[at(e)].number;
    const std::int64_t* const all = a.data();
    for (auto r = static_cast<int>(std::lower_bound(all, all + history.count, number) - all);
         r < history.count && a(r) == number; ++r)
      if (holds(r) != 0) items.push_back({a(r), b(r), {normal(r, 0), normal(r, 1), normal(r, 2)}});
  };
  const ItemPart& part = history_.all();
  const ExchangePlan answer = reverse(part.request);
  std::vector<int> counts;
  for (const PeerRun& run : answer.to) {
    const std::size_t before = items.size();
    for (std::int64_t k = run.first; k < run.first + run.count; ++k)
      add_items_of(part.published[static_cast<std::size_t>(k)]);
    counts.push_back(static_cast<int>(items.size() - before));
  }
  std::vector<HistoryItem> received = data_->exchange_sized(answer, counts, items);
  items.clear();
  for (const int e : part.own_places) add_items_of(e);
  received.insert(received.end(), items.begin(), items.end());
  std::sort(received.begin(), received.end(), comes_before<HistoryItem>);
  std::vector<std::int64_t> of_a, of_b;
  std::vector<std::array<double, 3>> normals;
  for (const HistoryItem& item : received) {
    of_a.push_back(item.a);
    of_b.push_back(item.b);
    normals.push_back(std::to_array(item.normal));
  }
  EdgeHistory here;
  here.count = static_cast<int>(received.size());
  here.a = to_view("contact::edge_history_a", of_a);
  here.b = to_view("contact::edge_history_b", of_b);
  here.holds = to_view("contact::edge_history_holds", std::vector<int>(received.size(), 1));
  here.normal = to_rows("contact::edge_history_normal", normals);
  return here;
}

// (5.7) Results to the homes of their edges A.
template <class Record>
std::vector<Record> RankedEdges::send_home(std::vector<Record> records) {
  std::vector<int> homes;
  homes.reserve(records.size());
  for (const Record& record : records) {
    const auto edge = std::lower_bound(edges_.begin(), edges_.end(), record.a,
                                       [](const EdgeTopology& e, std::int64_t number) { return e.number < number; });
    homes.push_back(edge->home);
  }
  std::vector<Record> received =
      send_to_partners(*data_, ranks_.ranks.rank(), history_.all().request, homes, std::move(records));
  std::sort(received.begin(), received.end(), comes_before<Record>);
  return received;
}

/// The touches of the last check, by paired edge.
std::vector<RankedEdges::TouchRecord> RankedEdges::list_touches() const {
  const auto list = to_host(space_.touches.list), a = to_host(space_.pairs.a), b = to_host(space_.pairs.b);
  const auto touches = to_host(space_.touches.by_pair);
  const auto friction = to_host(share_.pair_friction);
  const auto pair_number = to_host(share_.pair_number);
  std::vector<TouchRecord> records;
  for (int k = 0; k < space_.touches.count; ++k) {
    const int pair = list(k), of_a = a(pair);
    const EdgeTopology &edge = edges_[at(of_a)], &other = edges_[at(b(pair))];
    TouchRecord record;
    record.a = edge.number;
    record.b = other.number;
    for (int i = 0; i < 2; ++i) {
      record.ends[i] = edge.ends[i];
      record.ends[i + 2] = other.ends[i];
    }
    record.touch = touches(pair);
    record.friction = friction(edge.surface_class * share_.num_classes + other.surface_class);
    record.pair = pair_number(edge.surface_class * share_.num_classes + other.surface_class);
    records.push_back(record);
  }
  return records;
}

/// The row's touch but for its key and records. foreign: number of the next foreign node.
RowTouch RankedEdges::make_row_touch(const TouchRecord& record, int& foreign) const {
  RowTouch row = make_edge_row_touch(record.touch);
  row.face = record.b;
  row.friction = record.friction;
  row.pair = record.pair;
  for (int i = 0; i < 4; ++i) {
    const std::int64_t number = record.ends[i];
    const bool is_own = ranks_.numbering.find_node_owner(number) == ranks_.ranks.rank();
    row.node[i] = is_own ? find_number(ranks_.mesh.node_numbers, number) : -1 - foreign++;
    row.node_number[i] = number;
  }
  return row;
}

void RankedEdges::append_touches(const SurfaceMotion& motion, const EdgeHistory& history,
                                 std::vector<RowTouch>& touches) {
  if (total_pairs_ == 0) {
    forget_touches(space_);
    return;
  }
  check_edge_pairs(motion_.receive(*data_, read_, motion), receive_history(history), space_);
  const std::vector<TouchRecord> records = send_home(list_touches());
  int foreign = 0;
  for (const RowTouch& touch : touches)
    foreign += static_cast<int>(std::count_if(touch.node, touch.node + touch.count, [](int n) { return n < 0; }));
  const auto old_a = to_host(history.a), old_b = to_host(history.b);
  int order = 0, old = 0;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const TouchRecord& record = records[k];
    order = k > 0 && records[k - 1].a == record.a ? order + 1 : 0;
    RowTouch row = make_row_touch(record, foreign);
    row.key = make_edge_row_key(record.a, order);
    row.record = static_cast<int>(k);
    while (old < history.count && (old_a(old) < record.a || (old_a(old) == record.a && old_b(old) < record.b))) ++old;
    row.old_record = record.touch.record < 0 ? -1 : old;
    touches.push_back(row);
  }
}

std::vector<EdgePenetration> RankedEdges::find_penetrations(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  return send_home(measure_edge_pairs(motion_.receive(*data_, read_, motion), space_));
}

}  // namespace percuss
