#include "src/contact/check/ranked_edge_check.hpp"

#include <algorithm>
#include <numeric>

#include "kernels/core/host_copy.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/index.hpp"

namespace percuss {

/// A touch on its way to the home of its edge A.
struct RankedEdgeCheck::TouchRecord {
  std::int64_t a = -1, b = -1;  // numbers
  std::int64_t ends[4]{};       // numbers of the nodes of A and of B
  EdgeTouch touch;
  double friction = 0;
  int pair = 0;  // of surfaces
};

namespace {

/// A contact that is remembered, as the check reads it.
struct EdgeHistoryItem {
  std::int64_t a, b;
  double normal[3];
};

template <class Record>
bool comes_before(const Record& x, const Record& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

}  // namespace

RankedEdgeCheck::RankedEdgeCheck(const ContactRanks& ranks, const SurfaceShare& share, bool keeps_still)
    : ranks_(ranks), share_(share) {
  space_.keeps_still = keeps_still;
}

void RankedEdgeCheck::take_pairs(const std::vector<EdgeTopology>& edges, std::int64_t total_pairs,
                                 UnstructuredExchange& exchange, DataExchange& data) {
  total_pairs_ = total_pairs;
  space_.near.forget();
  asked_ = false;
  read_ = &of_all_;
  if (total_pairs_ == 0) return;
  const std::vector<std::int64_t> nodes = keep_paired_edges(edges);
  motion_.name(ranks_, exchange, data, nodes);
  num_nodes_ = nodes.size();
  name_history(exchange, data);
  of_all_ = {motion_.all(), history_.all()};
}

/// Keeps of the edges of a search those in pairs and numbers the pairs by them. Returns the numbers of their nodes,
/// which are the rows of the motion from now on, ascending.
std::vector<std::int64_t> RankedEdgeCheck::keep_paired_edges(const std::vector<EdgeTopology>& edges) {
  EdgePairs& pairs = space_.pairs;
  const auto list = to_host(pairs.edges), a = to_host(pairs.a), b = to_host(pairs.b);
  std::vector<int> place(edges.size(), -1);
  std::vector<std::int64_t> nodes;
  edges_.clear();
  for (int i = 0; i < pairs.num_edges; ++i) {
    place[at(list(i))] = i;
    edges_.push_back(edges[at(list(i))]);
    nodes.insert(nodes.end(), std::begin(edges_.back().ends), std::end(edges_.back().ends));
    nodes.insert(nodes.end(), std::begin(edges_.back().wings), std::end(edges_.back().wings));
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<int> pair_a, pair_b, all(edges_.size());
  for (int p = 0; p < pairs.num_pairs; ++p) {
    pair_a.push_back(place[at(a(p))]);
    pair_b.push_back(place[at(b(p))]);
  }
  std::iota(all.begin(), all.end(), 0);
  const NumberMap rows(nodes);
  set_edge_surface(make_edge_surface(
                       edges_, [&](std::int64_t number) { return rows.find(number); }, share_),
                   space_);
  pairs.num_pairs = static_cast<int>(pair_a.size());
  pairs.num_edges = static_cast<int>(edges_.size());
  pairs.a = to_view("contact::edge_pair_a", pair_a);
  pairs.b = to_view("contact::edge_pair_b", pair_b);
  pairs.edges = to_view("contact::pair_edges", all);
  return nodes;
}

/// Names the edges that are A of some pair to their homes, which have their contact history.
void RankedEdgeCheck::name_history(UnstructuredExchange& exchange, DataExchange& data) {
  const auto a = to_host(space_.pairs.a);
  std::vector<int> homes;
  std::vector<std::int64_t> numbers;
  for (int p = 0; p < space_.pairs.num_pairs; ++p) {  // ascending
    if (p > 0 && a(p) == a(p - 1)) continue;
    homes.push_back(edges_[at(a(p))].home);
    numbers.push_back(edges_[at(a(p))].number);
  }
  history_.name(exchange, data, homes, numbers, [&](std::int64_t number) {
    const auto edge = std::lower_bound(share_.edges.begin(), share_.edges.end(), number,
                                       [](const EdgeTopology& e, std::int64_t n) { return e.number < n; });
    return static_cast<int>(edge - share_.edges.begin());
  });
}

void RankedEdgeCheck::narrow(const NearWay& way) {
  space_.near.ask(way.near);
  asked_ = way.near > 0;
  read_ = &of_all_;
}

/// All ranks come here in the same step, also those that have not found their list worth it.
void RankedEdgeCheck::request_near_pairs(DataExchange& data) {
  if (total_pairs_ == 0 || !asked_) return;
  of_near_ = select(data);
  read_ = &of_near_;
  asked_ = false;
}

/// Requests what the check of the pairs that are near reads.
RankedEdgeCheck::EdgePart RankedEdgeCheck::select(DataExchange& data) const {
  const EdgePairs& near = space_.checked_pairs();
  const auto edges = to_host(near.edges), near_a = to_host(near.a), a = to_host(space_.pairs.a);
  const auto ends = to_host(space_.surface.ends);
  const auto wings = to_host(space_.surface.wings);
  std::vector<char> is_read(num_nodes_, 0), is_checked;
  for (int i = 0; i < near.num_edges; ++i) {
    for (std::size_t k = 0; k < 2; ++k) is_read[at(ends(edges(i), k))] = 1;
    for (std::size_t k = 0; k < 4; ++k) is_read[at(wings(edges(i), k))] = 1;
  }
  for (int p = 0, next = 0; p < space_.pairs.num_pairs; ++p) {  // named as in name_history()
    if (p > 0 && a(p) == a(p - 1)) continue;
    while (next < near.num_pairs && near_a(next) < a(p)) ++next;
    is_checked.push_back(next < near.num_pairs && near_a(next) == a(p) ? 1 : 0);
  }
  return {motion_.select(data, is_read), history_.select(data, is_checked)};
}

/// Contact history of the paired edges from their homes: names, marks and normals.
EdgeHistory RankedEdgeCheck::receive_history(const EdgeHistory& history, DataExchange& data) {
  const auto a = to_host(history.a), b = to_host(history.b);
  const auto holds = to_host(history.holds);
  const auto normal = to_host(history.normal);
  static_assert(sizeof(EdgeHistoryItem) == history_bytes);
  std::vector<EdgeHistoryItem> items;
  const auto add_items_of = [&](int e) {
    const std::int64_t number = share_.edges[at(e)].number;
    const std::int64_t* const all = a.data();
    for (auto r = static_cast<int>(std::lower_bound(all, all + history.count, number) - all);
         r < history.count && a(r) == number; ++r)
      if (holds(r) != 0) items.push_back({a(r), b(r), {normal(r, 0), normal(r, 1), normal(r, 2)}});
  };
  const ItemPart& part = read_->history;
  const ExchangePlan answer = reverse(part.request);
  std::vector<int> counts;
  for (const PeerRun& run : answer.to) {
    const std::size_t before = items.size();
    for (std::int64_t k = run.first; k < run.first + run.count; ++k)
      add_items_of(part.published[static_cast<std::size_t>(k)]);
    counts.push_back(static_cast<int>(items.size() - before));
  }
  std::vector<EdgeHistoryItem> received = data.exchange_sized(answer, counts, items);
  items.clear();
  for (const int e : part.own_places) add_items_of(e);
  received.insert(received.end(), items.begin(), items.end());
  std::sort(received.begin(), received.end(), comes_before<EdgeHistoryItem>);
  std::vector<std::int64_t> of_a, of_b;
  std::vector<std::array<double, 3>> normals;
  for (const EdgeHistoryItem& item : received) {
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

/// Results to the homes of their edges A.
template <class Record>
std::vector<Record> RankedEdgeCheck::send_results_to_homes(const EdgePart& part, DataExchange& data,
                                                           std::vector<Record> records) const {
  std::vector<int> homes;
  homes.reserve(records.size());
  for (const Record& record : records) {
    const auto edge = std::lower_bound(edges_.begin(), edges_.end(), record.a,
                                       [](const EdgeTopology& e, std::int64_t number) { return e.number < number; });
    homes.push_back(edge->home);
  }
  std::vector<Record> received =
      send_to_partners(data, ranks_.ranks.rank(), part.history.request, homes, std::move(records));
  std::sort(received.begin(), received.end(), comes_before<Record>);
  return received;
}

/// The touches of the last check, by paired edge.
std::vector<RankedEdgeCheck::TouchRecord> RankedEdgeCheck::list_touches() const {
  static_assert(sizeof(TouchRecord) == touch_bytes);
  const EdgePairs& pairs = space_.checked_pairs();
  const auto list = to_host(space_.touches.list), a = to_host(pairs.a), b = to_host(pairs.b);
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

/// The row's touch except for its key and records. foreign: number of the next foreign node.
RowTouch RankedEdgeCheck::make_row_touch(const TouchRecord& record, int& foreign) const {
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

void RankedEdgeCheck::check(const SurfaceMotion& motion, const EdgeHistory& history, DataExchange& data) {
  if (total_pairs_ == 0)
    forget_touches(space_);
  else
    check_edge_pairs(motion_.receive(data, read_->motion, motion), receive_history(history, data), space_);
}

void RankedEdgeCheck::append_touches(const EdgeHistory& history, DataExchange& data, std::vector<RowTouch>& touches) {
  if (total_pairs_ == 0) return;
  const std::vector<TouchRecord> records = send_results_to_homes(*read_, data, list_touches());
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

std::vector<EdgePenetration> RankedEdgeCheck::find_penetrations(const SurfaceMotion& motion, DataExchange& data) {
  if (total_pairs_ == 0) return {};
  return send_results_to_homes(of_all_, data,
                               measure_edge_pairs(motion_.receive(data, of_all_.motion, motion), space_));
}

}  // namespace percuss
