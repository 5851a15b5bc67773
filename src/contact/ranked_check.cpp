// The check in the contact decomposition, in every step: what it reads comes from the FE owners, what it finds goes
// back.

#include <algorithm>
#include <numeric>

#include "comm/sized_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/number_map.hpp"
#include "src/contact/ranked_finder.hpp"

namespace percuss {

struct RankedFinder::TouchRecord {
  std::int64_t node = -1;     // number
  std::int64_t face = -1;     // number
  std::int64_t corners[4]{};  // numbers
  Touch touch;
  double friction = 0;
  int pair = 0;
  int order = 0;  // among the touches of its node
};

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

constexpr int max_touches = contact_limits::max_touches;

/// The faces that pushed a node in the last step.
struct HistoryItem {
  std::int64_t face[max_touches];
};

}  // namespace

/// What the FE owners remember of the checked nodes.
void RankedFinder::receive_history(const ContactHistory& history) {
  const auto face = to_host(history.face);
  std::vector<HistoryItem> items;
  items.reserve(history_.published.size());
  for (const int n : history_.published) {
    HistoryItem item{};
    for (int slot = 0; slot < max_touches; ++slot) item.face[slot] = face(max_touches * n + slot);
    items.push_back(item);
  }
  const std::vector<HistoryItem> received = data_.exchange(reverse(history_.request), items);
  const auto local = Kokkos::create_mirror_view(check_.history_face);
  const auto numbers = to_host(check_.face_numbers);
  for (std::size_t k = 0; k < received.size(); ++k) {
    const int node = checked_nodes_[at(history_.order[k])];
    for (int slot = 0; slot < max_touches; ++slot) {
      const std::int64_t number = received[k].face[slot];
      local(max_touches * node + slot) = number < 0 ? -1 : find_face(numbers, number);
    }
  }
  Kokkos::deep_copy(check_.history_face, local);
}

// (5.7) Results to the FE owners of their nodes. records: by checked node; counts: [checked] records of each.
template <class Record>
std::vector<Record> RankedFinder::send_results_to_fe_owners(const std::vector<Record>& records,
                                                            const std::vector<int>& counts) {
  std::vector<int> first(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  std::vector<int> ordered_counts;
  std::vector<Record> ordered;
  ordered.reserve(records.size());
  for (const int i : history_.order) {
    ordered_counts.push_back(counts[at(i)]);
    ordered.insert(ordered.end(), records.begin() + first[at(i)], records.begin() + first[at(i) + 1]);
  }
  return exchange_sized(data_, history_.request, sum_by_run(history_.request.to, ordered_counts), ordered);
}

int RankedFinder::check(const SurfaceMotion& motion, const ContactHistory& history, Array<RowTouch>& touches) {
  std::vector<RowTouch> rows = check_faces(motion, history);
  edges_.append_touches(motion, history.edges, rows);
  reserve(touches, static_cast<int>(rows.size()));
  Kokkos::View<const RowTouch*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(rows.data(),
                                                                                                 rows.size());
  Kokkos::deep_copy(Kokkos::subview(touches, std::pair<std::size_t, std::size_t>(0, rows.size())), host);
  return static_cast<int>(rows.size());
}

std::vector<RowTouch> RankedFinder::check_faces(const SurfaceMotion& motion, const ContactHistory& history) {
  if (total_pairs_ == 0) return {};
  const SurfaceMotion here = motion_.receive(data_, motion);
  receive_history(history);
  check_candidates(here, check_);  // (5.6), second half
  std::vector<TouchRecord> records;
  std::vector<int> counts;
  const auto by_node = to_host(check_.touches.by_node);
  const auto friction = to_host(check_.surface.pair_friction);
  const auto pair_number = to_host(check_.surface.pair_number);
  const auto node_class = to_host(check_.surface.node_class);
  const CandidateList& pairs = check_.checked_pairs();
  const auto nodes = to_host(pairs.nodes);
  int next = 0;  // of the nodes whose pairs were checked
  for (const int n : checked_nodes_) {
    const bool is_checked = next < pairs.num_nodes && nodes(next) == n;
    const int place = is_checked ? next++ : 0;
    counts.push_back(is_checked ? by_node(place).count : 0);
    for (int j = 0; j < counts.back(); ++j) {
      TouchRecord record;
      record.touch = by_node(place).touch[j];
      record.order = j;
      const FaceTopology& face = check_faces_[at(record.touch.face)];
      record.node = check_nodes_[at(n)];
      record.face = face.number;
      std::copy(std::begin(face.corners), std::end(face.corners), record.corners);
      record.friction = friction(node_class(n) * share_.num_classes + face.surface_class);
      record.pair = pair_number(node_class(n) * share_.num_classes + face.surface_class);
      records.push_back(record);
    }
  }
  return make_row_touches(send_results_to_fe_owners(records, counts));
}

/// Touches of this rank's contact nodes as rows need them, by (node, face). Corners that other ranks own are numbered
/// as foreign nodes.
std::vector<RowTouch> RankedFinder::make_row_touches(std::vector<TouchRecord> records) const {
  std::sort(records.begin(), records.end(), [](const TouchRecord& a, const TouchRecord& b) {
    return a.node != b.node ? a.node < b.node : a.order < b.order;
  });
  std::vector<RowTouch> rows;
  int foreign = 0;
  for (const TouchRecord& record : records) {
    const int node = find_contact_node(record.node);
    RowTouch row = make_row_touch(record.touch);
    row.face = record.face;
    row.key = make_face_row_key(record.node, record.order);
    row.friction = record.friction;
    row.pair = record.pair;
    row.record = max_touches * node + record.order;
    row.old_record = record.touch.record < 0 ? -1 : max_touches * node + record.touch.record;
    row.node[0] = share_.nodes.mesh_nodes[at(node)];
    for (int i = 0; i < 4; ++i) {
      const bool is_own = ranks_.numbering.find_node_owner(record.corners[i]) == ranks_.ranks.rank();
      row.node[i + 1] = is_own ? find_mesh_node(record.corners[i]) : -1 - foreign++;
      row.node_number[i + 1] = record.corners[i];
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<Penetration> RankedFinder::find_penetrations(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  const PenetrationTable table = measure_candidates(motion_.receive(data_, motion), check_);
  const auto depth = to_host(table.depth), ratio = to_host(table.ratio), limit = to_host(table.limit);
  const auto size = to_host(check_.faces.size);
  const auto face = to_host(table.face);
  struct Record {
    std::int64_t node;
    Penetration penetration;
  };
  std::vector<Record> records;
  std::vector<int> counts;
  for (const int n : checked_nodes_) {
    counts.push_back(check_.candidates.num_pairs > 0 && face(n) >= 0 ? 1 : 0);
    if (counts.back() == 0) continue;
    const FaceTopology& of = check_faces_[at(face(n))];
    records.push_back({check_nodes_[at(n)], {0, of.number, depth(n), ratio(n), size(face(n)), of.part, limit(n)}});
  }
  std::vector<Penetration> found;
  for (Record& record : send_results_to_fe_owners(records, counts)) {
    record.penetration.node = find_contact_node(record.node);
    found.push_back(record.penetration);
  }
  std::sort(found.begin(), found.end(), [](const Penetration& a, const Penetration& b) { return a.node < b.node; });
  return found;
}

std::vector<PartGap> RankedFinder::find_gaps(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  std::vector<int> parts;
  for (const FaceTopology& face : check_faces_) parts.push_back(face.part);
  return measure_gaps(motion_.receive(data_, motion), check_, parts);
}

}  // namespace percuss
