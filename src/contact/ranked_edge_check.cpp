// The check of edge pairs in the contact decomposition, in every step: motion and history come from homes, touches go
// back.

#include <algorithm>
#include <numeric>

#include "comm/sized_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/number_map.hpp"
#include "src/contact/ranked_edges.hpp"

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
  std::vector<int> counts;
  std::vector<HistoryItem> items;
  for (const int e : history_.published) {
    const std::int64_t number = share_.edges[at(e)].number;
    const std::int64_t* const all = a.data();
    const std::size_t before = items.size();
    for (auto r = static_cast<int>(std::lower_bound(all, all + history.count, number) - all);
         r < history.count && a(r) == number; ++r)
      if (holds(r) != 0) items.push_back({a(r), b(r), {normal(r, 0), normal(r, 1), normal(r, 2)}});
    counts.push_back(static_cast<int>(items.size() - before));
  }
  const ExchangePlan answer = reverse(history_.request);
  std::vector<HistoryItem> received = exchange_sized(*data_, answer, sum_by_run(answer.to, counts), items);
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

// (5.7) Results to the homes of their edges A. records: by paired edge; counts: [paired] records of each.
template <class Record>
std::vector<Record> RankedEdges::send_home(const std::vector<Record>& records, const std::vector<int>& counts) {
  std::vector<int> first(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  std::vector<int> ordered_counts;
  std::vector<Record> ordered;
  ordered.reserve(records.size());
  for (const int i : history_.order) {
    ordered_counts.push_back(counts[at(i)]);
    ordered.insert(ordered.end(), records.begin() + first[at(i)], records.begin() + first[at(i) + 1]);
  }
  std::vector<Record> received =
      exchange_sized(*data_, history_.request, sum_by_run(history_.request.to, ordered_counts), ordered);
  std::sort(received.begin(), received.end(), comes_before<Record>);
  return received;
}

/// The touches of the last check, by paired edge.
std::vector<RankedEdges::TouchRecord> RankedEdges::list_touches(std::vector<int>& counts) const {
  const auto list = to_host(space_.touches.list), a = to_host(space_.pairs.a), b = to_host(space_.pairs.b);
  const auto touches = to_host(space_.touches.by_pair);
  const auto friction = to_host(share_.pair_friction);
  const auto pair_number = to_host(share_.pair_number);
  std::vector<TouchRecord> records;
  counts.assign(paired_.size(), 0);
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
    ++counts[static_cast<std::size_t>(std::lower_bound(paired_.begin(), paired_.end(), of_a) - paired_.begin())];
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
  if (total_pairs_ == 0) return;
  check_edge_pairs(motion_.receive(*data_, motion), receive_history(history), space_);
  std::vector<int> counts;
  const std::vector<TouchRecord> sent = list_touches(counts);
  const std::vector<TouchRecord> records = send_home(sent, counts);
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
  const std::vector<EdgePenetration> found = measure_edge_pairs(motion_.receive(*data_, motion), space_);
  std::vector<int> counts(paired_.size(), 0);
  for (const EdgePenetration& p : found) {
    const auto place = std::lower_bound(paired_.begin(), paired_.end(), p.a,
                                        [&](int e, std::int64_t n) { return edges_[at(e)].number < n; });
    ++counts[static_cast<std::size_t>(place - paired_.begin())];
  }
  return send_home(found, counts);
}

}  // namespace percuss
