// The check in the contact decomposition, in every step: what it reads comes from the FE owners, what it finds goes
// back.

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "src/contact/search/ranked_finder.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {

struct RankedFinder::TouchRecord {
  std::int64_t node = -1;     // number
  std::int64_t face = -1;     // number
  std::int64_t corners[4]{};  // numbers
  Touch touch{};
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

KOKKOS_INLINE_FUNCTION int find_remembered_face(const Array<const std::int64_t>& numbers, std::int64_t number) {
  return number < 0 ? -1 : find_face(numbers, number);
}

}  // namespace

/// The motion of the nodes that the check reads, and what FE owners remember of the checked ones.
SurfaceMotion RankedFinder::receive(const SurfaceMotion& motion, const ContactHistory& history) {
  const CheckPart& part = *read_;
  motion_.begin(data_, part.motion, motion);
  const int sent = static_cast<int>(part.published_history.extent(0));
  const int own = static_cast<int>(part.own_history_rows.extent(0));
  const int received = static_cast<int>(part.history_rows.extent(0));
  const Array<HistoryItem> send(Kokkos::view_alloc("contact::sent_history", Kokkos::WithoutInitializing),
                                part.published_history.extent(0));
  const Array<HistoryItem> receive(Kokkos::view_alloc("contact::received_history", Kokkos::WithoutInitializing),
                                   part.history_rows.extent(0));
  const Array<const std::int64_t> remembered = history.face, numbers = check_.face_numbers;
  const Array<const int> published = part.published_history, places = part.own_history_places;
  const Array<const int> rows = part.history_rows, own_rows = part.own_history_rows;
  const Array<int> faces = check_.history_face;
  run_where_it_pays((sent + own) / 10, [&](const auto& space) {
    using Space = std::decay_t<decltype(space)>;
    Kokkos::parallel_for(
        "contact::pack_history", RangeOf<Space>(space, 0, sent), KOKKOS_LAMBDA(int i) {
          for (int slot = 0; slot < max_touches; ++slot)
            send(i).face[slot] = remembered(max_touches * published(i) + slot);
        });
    Kokkos::parallel_for(
        "contact::copy_own_history", RangeOf<Space>(space, 0, own), KOKKOS_LAMBDA(int i) {
          for (int slot = 0; slot < max_touches; ++slot)
            faces(max_touches * own_rows(i) + slot) =
                find_remembered_face(numbers, remembered(max_touches * places(i) + slot));
        });
    space.fence();
  });
  const auto send_buffer = to_host(send);
  const auto receive_buffer = Kokkos::create_mirror_view(receive);
  history_data_.begin<HistoryItem>(reverse(part.history.request), {send_buffer.data(), send_buffer.extent(0)},
                                   {receive_buffer.data(), receive_buffer.extent(0)});
  const SurfaceMotion here = motion_.end(data_, part.motion, motion);
  history_data_.end();
  Kokkos::deep_copy(receive, receive_buffer);
  run_where_it_pays(received / 10, [&](const auto& space) {
    Kokkos::parallel_for(
        "contact::unpack_history", RangeOf<std::decay_t<decltype(space)>>(space, 0, received), KOKKOS_LAMBDA(int i) {
          for (int slot = 0; slot < max_touches; ++slot)
            faces(max_touches * rows(i) + slot) = find_remembered_face(numbers, receive(i).face[slot]);
        });
    space.fence();
  });
  return here;
}

// (5.7) Results to the FE owners of their nodes, among those of a part whose histories were asked for.
template <class Record>
std::vector<Record> RankedFinder::send_results_to_fe_owners(const CheckPart& part, std::vector<Record> records) {
  std::vector<int> owners;
  owners.reserve(records.size());
  for (const Record& record : records) owners.push_back(ranks_.numbering.find_node_owner(record.node));
  return send_to_partners(data_, ranks_.ranks.rank(), part.history.request, owners, std::move(records));
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
  if (total_pairs_ == 0) {
    forget_touches(check_);
    return {};
  }
  check_candidates(receive(motion, history), check_);  // (5.6), second half
  std::vector<TouchRecord> records;
  records.reserve(at(check_.touches.count));
  if (check_.touches.count > 0) {
    const auto by_node = to_host(check_.touches.by_node);
    const auto friction = to_host(check_.surface.pair_friction);
    const auto pair_number = to_host(check_.surface.pair_number);
    const auto node_class = to_host(check_.surface.node_class);
    const CandidateList& pairs = check_.checked_pairs();
    const auto nodes = to_host(pairs.nodes);
    for (int i = 0; i < pairs.num_nodes; ++i) {
      const NodeTouches& touches = by_node(nodes(i));
      for (int j = 0; j < touches.count; ++j) {
        const FaceTopology& face = faces_[at(touches.touch[j].face)];
        const int pair = node_class(nodes(i)) * share_.num_classes + face.surface_class;
        TouchRecord record;
        record.node = nodes_[at(nodes(i))];
        record.face = face.number;
        std::copy(std::begin(face.corners), std::end(face.corners), record.corners);
        record.touch = touches.touch[j];
        record.friction = friction(pair);
        record.pair = pair_number(pair);
        record.order = j;
        records.push_back(record);
      }
    }
  }
  std::vector<RowTouch> rows = make_row_touches(send_results_to_fe_owners(*read_, std::move(records)));
  if (asked_.near > 0) select_near();
  return rows;
}

/// Touches of this rank's contact nodes as rows need them, by (node, face). Corners that other ranks own are numbered
/// as foreign nodes.
std::vector<RowTouch> RankedFinder::make_row_touches(std::vector<TouchRecord> records) const {
  const auto comes_before = [](const TouchRecord& a, const TouchRecord& b) {
    return a.node != b.node ? a.node < b.node : a.order < b.order;
  };
  // Where this rank has found all of them itself, they are in order.
  if (!std::is_sorted(records.begin(), records.end(), comes_before))
    std::sort(records.begin(), records.end(), comes_before);
  std::vector<RowTouch> rows;
  rows.reserve(records.size());
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
      const int corner = find_contact_node(record.corners[i]);
      row.node[i + 1] = corner >= 0 ? share_.nodes.mesh_nodes[at(corner)] : -1 - foreign++;
      row.node_number[i + 1] = record.corners[i];
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<Penetration> RankedFinder::find_penetrations(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  const PenetrationTable table = measure_candidates(motion_.receive(data_, of_all_.motion, motion), check_);
  const auto depth = to_host(table.depth), ratio = to_host(table.ratio), limit = to_host(table.limit);
  const auto size = to_host(check_.faces.size);
  const auto face = to_host(table.face);
  struct Record {
    std::int64_t node;
    Penetration penetration;
  };
  std::vector<Record> records;
  for (const int n : searched_nodes_) {
    if (check_.candidates.num_pairs == 0 || face(n) < 0) continue;
    const FaceTopology& of = faces_[at(face(n))];
    records.push_back({nodes_[at(n)], {0, of.number, depth(n), ratio(n), size(face(n)), of.part, limit(n)}});
  }
  std::vector<Penetration> found;
  for (Record& record : send_results_to_fe_owners(of_all_, std::move(records))) {
    record.penetration.node = find_contact_node(record.node);
    found.push_back(record.penetration);
  }
  std::sort(found.begin(), found.end(), [](const Penetration& a, const Penetration& b) { return a.node < b.node; });
  return found;
}

std::vector<PartGap> RankedFinder::find_gaps(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  std::vector<int> parts;
  parts.reserve(faces_.size());
  for (const FaceTopology& face : faces_) parts.push_back(face.part);
  return measure_gaps(motion_.receive(data_, of_all_.motion, motion), check_, parts);
}

}  // namespace percuss
