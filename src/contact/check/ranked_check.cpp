#include "src/contact/check/ranked_check.hpp"

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"

namespace percuss {

struct RankedCheck::TouchRecord {
  std::int64_t node = -1;     // number
  std::int64_t face = -1;     // number
  std::int64_t corners[4]{};  // numbers
  Touch touch{};
  double friction = 0;
  int pair = 0;
  int order = 0;  // among the touches of its node
};

namespace {

constexpr int max_touches = contact_limits::max_touches;

/// The faces that pushed a node in the last step.
struct HistoryItem {
  std::int64_t face[max_touches];
};

/// Messages of what these contact nodes of the share remember.
void pack_history(const WorkSpace& space, const Array<const int>& nodes, const Array<const std::int64_t>& remembered,
                  const Array<HistoryItem>& send) {
  const Array<const int> of = nodes;
  const Array<const std::int64_t> from = remembered;
  const Array<HistoryItem> out = send;
  parallel_for(
      "contact::pack_history", RangeOf(space, 0, static_cast<int>(of.extent(0))), KOKKOS_LAMBDA(int i) {
        for (int slot = 0; slot < max_touches; ++slot) out(i).face[slot] = from(max_touches * of(i) + slot);
      });
}

/// The faces here that nodes remember: faces is out, [3 nodes], of the nodes in rows. remembered(i, slot): number.
template <class Remembered>
void find_remembered_faces(const WorkSpace& space, const Array<const int>& rows,
                           const Array<const std::int64_t>& numbers, const Remembered& remembered,
                           const Array<int>& faces) {
  const Array<const int> to = rows;
  const Array<const std::int64_t> of_faces = numbers;
  const Array<int> out = faces;
  parallel_for(
      "contact::find_remembered_faces", RangeOf(space, 0, static_cast<int>(to.extent(0))), KOKKOS_LAMBDA(int i) {
        for (int slot = 0; slot < max_touches; ++slot) {
          int& face = out(max_touches * to(i) + slot);
          face = find_remembered_face(of_faces, remembered(i, slot), face);
        }
      });
}

/// History of the contact nodes of the share, and of a message.
struct OwnMemory {
  Array<const std::int64_t> remembered;
  Array<const int> places;
  KOKKOS_INLINE_FUNCTION std::int64_t operator()(int i, int slot) const {
    return remembered(max_touches * places(i) + slot);
  }
};
struct SentMemory {
  Array<const HistoryItem> items;
  KOKKOS_INLINE_FUNCTION std::int64_t operator()(int i, int slot) const { return items(i).face[slot]; }
};

/// Marks the nodes whose motion the check of a list of pairs reads. is_wanted: out, [nodes].
void mark_read_nodes(const WorkSpace& space, const ContactSurface& surface, const CandidateList& pairs,
                     const Array<int>& is_wanted) {
  const ContactSurface s = surface;
  const Array<const int> faces = pairs.faces, is_candidate = pairs.is_candidate, nodes = pairs.nodes;
  parallel_for(
      "contact::clear_wanted", RangeOf(space, 0, s.num_nodes), KOKKOS_LAMBDA(int n) { is_wanted(n) = 0; });
  parallel_for(
      "contact::want_nodes", RangeOf(space, 0, pairs.num_nodes),
      KOKKOS_LAMBDA(int i) { Kokkos::atomic_fetch_or(&is_wanted(nodes(i)), 1); });
  parallel_for(
      "contact::want_corners", RangeOf(space, 0, pairs.num_faces), KOKKOS_LAMBDA(int i) {
        const int f = faces(i);
        for (int c = 0; c < 4; ++c) {
          Kokkos::atomic_fetch_or(&is_wanted(s.face_corners(f, c)), 1);
          if (is_candidate(i) != 0) Kokkos::atomic_fetch_or(&is_wanted(s.face_backs(f, c)), 1);
        }
      });
  space.fence();
}

}  // namespace

RankedCheck::RankedCheck(const ContactRanks& ranks, const SurfaceShare& share, DataExchange& data, bool keeps_still)
    : ranks_(ranks), share_(share), contact_nodes_(share.nodes.numbers), data_(data), history_data_(ranks.ranks) {
  space_.keeps_still = keeps_still;
}

void RankedCheck::take_surface(KnownSurface known, const ContactSurface& surface, UnstructuredExchange& exchange) {
  known_ = std::move(known);
  std::vector<std::int64_t> face_numbers, searched;
  face_numbers.reserve(known_.faces.size());
  for (const FaceTopology& face : known_.faces) face_numbers.push_back(face.number);
  searched.reserve(known_.searched_nodes.size());
  for (const int n : known_.searched_nodes) searched.push_back(known_.nodes[at(n)]);
  set_surface(surface, face_numbers, space_);
  motion_.name(ranks_, exchange, data_, known_.nodes);
  history_.name(exchange, data_, NodeOwners(ranks_.numbering).find(searched), searched,
                [&](std::int64_t number) { return find_contact_node(number); });
}

void RankedCheck::begin_pairs(std::int64_t total_pairs) {
  total_pairs_ = total_pairs;
  space_.near.forget();
  read_ = base_ = &of_all_;
  asked_ = {};
  if (total_pairs_ > 0) of_all_ = select(space_.candidates, nullptr);
}

/// Requests from the FE owners the input of the check of a list of pairs. among: of a list that contains it; null:
/// none. Collective.
RankedCheck::CheckPart RankedCheck::select(const CandidateList& pairs, const CheckPart* among) {
  reserve(wanted_, space_.surface.num_nodes);
  run_where_it_pays(space_.surface.num_nodes / 10,
                    [&](const auto& space) { mark_read_nodes(space, space_.surface, pairs, wanted_); });
  const auto marks = to_host(wanted_);
  CheckPart part;
  const std::vector<char> is_read(marks.data(), marks.data() + space_.surface.num_nodes);
  part.motion =
      among != nullptr ? MotionCopy::select_among(among->motion, data_, is_read) : motion_.select(data_, is_read);
  const auto nodes = to_host(pairs.nodes);
  std::vector<char> is_checked;
  is_checked.reserve(known_.searched_nodes.size());
  int next = 0;
  for (const int n : known_.searched_nodes) {
    is_checked.push_back(next < pairs.num_nodes && nodes(next) == n ? 1 : 0);
    next += is_checked.back();
  }
  part.history = among != nullptr ? RemoteItems::select_among(among->history, history_data_, is_checked)
                                  : history_.select(history_data_, is_checked);
  const auto list_rows = [&](const std::vector<int>& searched) {
    std::vector<int> rows;
    rows.reserve(searched.size());
    for (const int i : searched) rows.push_back(known_.searched_nodes[at(i)]);
    return to_view("contact::history_rows", rows);
  };
  part.history_rows = list_rows(part.history.asked);
  part.own_history_rows = list_rows(part.history.own);
  part.own_history_places = to_view("contact::own_history", part.history.own_places);
  part.published_history = to_view("contact::published_history", part.history.published);
  return part;
}

void RankedCheck::narrow(const NearWay& way) {
  space_.near.ask(way);
  asked_ = way;
  if (!way.keeps_first) base_ = &of_all_;
  read_ = base_;
}

/// After a check that made lists, requests only what these read. All ranks come here in the same step, also those that
/// have not found theirs worth it.
void RankedCheck::request_near_pairs() {
  if (total_pairs_ == 0 || asked_.near <= 0) return;
  if (asked_.search > 0) {
    of_reachable_ = select(space_.reachable_pairs(), &of_all_);
    base_ = &of_reachable_;
  }
  read_ = base_;
  of_near_ = select(space_.checked_pairs(), base_);
  read_ = &of_near_;
  asked_ = {};
}

/// The motion of the nodes that the check reads, and the contact history of the checked ones, from the FE owners.
/// (Section 4.2 of the paper: the check knows which nodes are in contact already, and with which faces.)
SurfaceMotion RankedCheck::receive(const SurfaceMotion& motion, const ContactHistory& history) {
  const CheckPart& part = *read_;
  motion_.begin(data_, part.motion, motion);
  const int sent = static_cast<int>(part.published_history.extent(0));
  const int own = static_cast<int>(part.own_history_rows.extent(0));
  const int received = static_cast<int>(part.history_rows.extent(0));
  const Array<HistoryItem> send(Kokkos::view_alloc("contact::sent_history", Kokkos::WithoutInitializing),
                                part.published_history.extent(0));
  const Array<HistoryItem> receive(Kokkos::view_alloc("contact::received_history", Kokkos::WithoutInitializing),
                                   part.history_rows.extent(0));
  run_where_it_pays((sent + own) / 10, [&](const auto& space) {
    pack_history(space, part.published_history, history.face, send);
    find_remembered_faces(space, part.own_history_rows, space_.face_numbers,
                          OwnMemory{history.face, part.own_history_places}, space_.history_face);
    space.fence();
  });
  const auto send_buffer = to_host(send);
  const auto receive_buffer = Kokkos::create_mirror_view(receive);
  history_data_.begin<HistoryItem>(reverse(part.history.request), {send_buffer.data(), send_buffer.extent(0)},
                                   {receive_buffer.data(), receive_buffer.extent(0)});
  const SurfaceMotion here = motion_.end(data_, part.motion, motion);
  history_data_.end();
  copy_values(receive, receive_buffer);
  run_where_it_pays(received / 10, [&](const auto& space) {
    find_remembered_faces(space, part.history_rows, space_.face_numbers, SentMemory{receive}, space_.history_face);
    space.fence();
  });
  return here;
}

/// Results to the FE owners of their nodes, among those of a part whose histories were requested.
template <class Record>
std::vector<Record> RankedCheck::send_to_fe_owners(const CheckPart& part, std::vector<Record> records) {
  std::vector<int> owners;
  owners.reserve(records.size());
  for (const Record& record : records) owners.push_back(ranks_.numbering.find_node_owner(record.node));
  return send_to_partners(data_, ranks_.ranks.rank(), part.history.request, owners, std::move(records));
}

/// Touches that the last check found, by (node, face).
std::vector<RankedCheck::TouchRecord> RankedCheck::list_touches() const {
  static_assert(sizeof(TouchRecord) == touch_bytes);
  std::vector<TouchRecord> records;
  if (space_.touches.count == 0) return records;
  records.reserve(at(space_.touches.count));
  const auto by_node = to_host(space_.touches.by_node);
  const auto friction = to_host(space_.surface.pair_friction);
  const auto pair_number = to_host(space_.surface.pair_number);
  const auto node_class = to_host(space_.surface.node_class);
  const CandidateList& pairs = space_.checked_pairs();
  const auto nodes = to_host(pairs.nodes);
  for (int i = 0; i < pairs.num_nodes; ++i) {
    const NodeTouches& touches = by_node(nodes(i));
    for (int j = 0; j < touches.count; ++j) {
      const FaceTopology& face = known_.faces[at(touches.touch[j].face)];
      const int pair = node_class(nodes(i)) * share_.num_classes + face.surface_class;
      TouchRecord record;
      record.node = known_.nodes[at(nodes(i))];
      record.face = face.number;
      std::copy(std::begin(face.corners), std::end(face.corners), record.corners);
      record.touch = touches.touch[j];
      record.friction = friction(pair);
      record.pair = pair_number(pair);
      record.order = j;
      records.push_back(record);
    }
  }
  return records;
}

// (5.6) Detailed check of the pairs that this rank has found.
void RankedCheck::check(const SurfaceMotion& motion, const ContactHistory& history) {
  if (total_pairs_ == 0)
    forget_touches(space_);
  else
    check_candidates(receive(motion, history), space_);
}

// (5.7) Touches to the FE owners of their nodes.
std::vector<RowTouch> RankedCheck::send_results_to_fe_owners() {
  if (total_pairs_ == 0) return {};
  return make_row_touches(send_to_fe_owners(*read_, list_touches()));
}

/// Touches of this rank's contact nodes as rows need them, by (node, face). Corners that other ranks own are numbered
/// as foreign nodes.
std::vector<RowTouch> RankedCheck::make_row_touches(std::vector<TouchRecord> records) const {
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

std::vector<Penetration> RankedCheck::find_penetrations(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  const PenetrationTable table = measure_candidates(motion_.receive(data_, of_all_.motion, motion), space_);
  const auto depth = to_host(table.depth), ratio = to_host(table.ratio), limit = to_host(table.limit);
  const auto size = to_host(space_.faces.size);
  const auto face = to_host(table.face);
  struct Record {
    std::int64_t node;
    Penetration penetration;
  };
  std::vector<Record> records;
  for (const int n : known_.searched_nodes) {
    if (space_.candidates.num_pairs == 0 || face(n) < 0) continue;
    const FaceTopology& of = known_.faces[at(face(n))];
    records.push_back({known_.nodes[at(n)], {0, of.number, depth(n), ratio(n), size(face(n)), of.part, limit(n)}});
  }
  std::vector<Penetration> found;
  for (Record& record : send_to_fe_owners(of_all_, std::move(records))) {
    record.penetration.node = find_contact_node(record.node);
    found.push_back(record.penetration);
  }
  std::sort(found.begin(), found.end(), [](const Penetration& a, const Penetration& b) { return a.node < b.node; });
  return found;
}

std::vector<PartGap> RankedCheck::find_gaps(const SurfaceMotion& motion) {
  if (total_pairs_ == 0) return {};
  std::vector<int> parts;
  parts.reserve(known_.faces.size());
  for (const FaceTopology& face : known_.faces) parts.push_back(face.part);
  return measure_gaps(motion_.receive(data_, of_all_.motion, motion), space_, parts);
}

}  // namespace percuss
