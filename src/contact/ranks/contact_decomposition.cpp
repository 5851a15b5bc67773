#include "src/contact/ranks/contact_decomposition.hpp"

#include <algorithm>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "kernels/contact/search/capture_boxes.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Growth of the copies of faces at which cuts are worth renewing.
constexpr double ghost_growth = 1.15;
/// Change of the number of points, where erosion redefines the surface, at which they are.
constexpr double point_growth = 1.1;

/// A point on its way to the rank that owned it before.
struct SentPoint {
  std::int64_t id = 0;
  double x[3] = {0, 0, 0};
};

/// A place of a node, and a capture box, on their way.
struct PlaceItem {
  double x[3];
};
struct BoxItem {
  double side[6];
};

/// Sorts records by number. Returns the place of each in the sorted list. Sorted are numbers with places: a record is
/// a line of memory or more, moved once.
template <class Record>
std::vector<int> sort_by_number(std::vector<Record>& records) {
  std::vector<std::pair<std::int64_t, int>> numbers;
  numbers.reserve(records.size());
  for (const Record& record : records) numbers.emplace_back(record.number, static_cast<int>(numbers.size()));
  std::sort(numbers.begin(), numbers.end());
  std::vector<int> place(records.size());
  std::vector<Record> sorted;
  sorted.reserve(records.size());
  for (const auto& [number, before] : numbers) {
    place[at(before)] = static_cast<int>(sorted.size());
    sorted.push_back(records[at(before)]);
  }
  records = std::move(sorted);
  return place;
}

/// Sends rows along a plan: row from(k) of `sent` arrives as row to(k) of `received`. Item: a row as it travels.
template <class Item, class Rows>
void send_rows(DataExchange& data, const ExchangePlan& plan, const Rows& sent, const Array<const int>& from,
               const Rows& received, const Array<const int>& to) {
  constexpr int width = sizeof(Item) / sizeof(double);
  const Array<Item> send(Kokkos::view_alloc("contact::sent_rows", Kokkos::WithoutInitializing), from.extent(0));
  const Array<Item> receive(Kokkos::view_alloc("contact::received_rows", Kokkos::WithoutInitializing), to.extent(0));
  parallel_for(
      "contact::pack_rows", RangeOf(ExecSpace(), 0, static_cast<int>(from.extent(0))), KOKKOS_LAMBDA(int i) {
        double* const item = reinterpret_cast<double*>(&send(i));
        for (int k = 0; k < width; ++k) item[k] = sent(from(i), k);
      });
  ExecSpace().fence();
  const auto send_buffer = to_host(send);
  const auto receive_buffer = Kokkos::create_mirror_view(receive);
  data.begin<Item>(plan, {send_buffer.data(), send_buffer.extent(0)},
                   {receive_buffer.data(), receive_buffer.extent(0)});
  data.end();
  copy_values(receive, receive_buffer);
  parallel_for(
      "contact::unpack_rows", RangeOf(ExecSpace(), 0, static_cast<int>(to.extent(0))), KOKKOS_LAMBDA(int i) {
        const double* const item = reinterpret_cast<const double*>(&receive(i));
        for (int k = 0; k < width; ++k) received(to(i), k) = item[k];
      });
  ExecSpace().fence();
}

}  // namespace

ContactDecomposition::ContactDecomposition(const Communicator& ranks, const SurfaceShare& share,
                                           ContactDeck::Rebalance rebalance)
    : share_(share),
      rebalance_(rebalance),
      exchange_(ranks),
      data_(ranks),
      boxes_("contact::boxes", share.searched_faces.size()) {
  std::vector<std::int64_t> ids;
  for (int n = 0; n < share.nodes.count(); ++n) {
    if (share.nodes.searched[at(n)] == 0) continue;
    searched_nodes_.push_back(n);
    ids.push_back(2 * share.nodes.numbers[at(n)]);
  }
  for (const int f : share.searched_faces) ids.push_back(2 * share.faces[at(f)].number + 1);
  points_ = {Rows3<double>("contact::point_positions", ids.size()), to_view("contact::point_ids", ids)};
}

void ContactDecomposition::take_over(const ContactDecomposition& before) {
  searches_ = before.searches_;
  ghosts_after_rebalance_ = before.ghosts_after_rebalance_;
  points_at_rebalance_ = before.points_at_rebalance_;
  warm_rounds_ = before.warm_rounds_;
  report_ = before.report_;
  if (report_.rebalances == 0) return;
  parts_ = before.parts_;
  std::int64_t counts[2] = {static_cast<std::int64_t>(points_.ids.extent(0)), points_at_rebalance_};
  all_reduce(exchange_.ranks(), Reduce::sum, counts);
  const auto points = static_cast<double>(counts[0]), earlier = static_cast<double>(counts[1]);
  const bool has_changed = points > point_growth * earlier || earlier > point_growth * points;
  is_due_ = before.is_due_ || (has_changed && rebalance_ != ContactDeck::Rebalance::never);
}

// (5.1) Points go to the rank that owned them before, so that bisection finds nearly all where they belong.
void ContactDecomposition::send_contact_data_to_previous_owners(const SurfaceMotion& motion) {
  begin_search(motion);
  are_nodes_others_ = adopt_cuts();
  if (is_due_) arrived_ = send_points_to_previous_owners();
}

// (5.2) Recursive coordinate bisection, where it is due.
void ContactDecomposition::rebalance() {
  if (!is_due_) return;
  divided_ = parts_->bisection().divide(ExecSpace(), arrived_);
  just_rebalanced_ = true;
}

// (5.3) Every FE owner then knows who owns its nodes.
void ContactDecomposition::share_cuts() {
  if (!just_rebalanced_) return;
  parts_->bisection().share_cuts(divided_);
  arrived_ = {};
  take_report(divided_);
  are_nodes_others_ = find_new_owners() || are_nodes_others_;
}

// Nodes where they have another owner, places in every search. Cuts that are kept follow the places.
void ContactDecomposition::send_points_to_owners() {
  if (are_nodes_others_) send_nodes_to_owners();
  send_places_to_owners();
}

// (5.4) For all my faces: which ranks does the capture box reach, and do these know the face? If not, faces go to the
// ranks that need them and to those that soon may.
void ContactDecomposition::find_reached_ranks(const SurfaceMotion& motion, double margin) {
  are_reached_known_ = are_faces_sent_ && are_reached_parts_known(motion, margin);
  if (are_reached_known_) return;
  const double wide = are_faces_sent_ ? (1 + sent_margins) * margin : margin;
  bound_faces(ExecSpace(), share_.bounded_faces(), motion, wide, boxes_);
  known_ = list_reached_parts(exchange_.ranks(), parts_->bisection().tree(), boxes_,
                              static_cast<int>(share_.searched_faces.size()), wide);
  are_faces_sent_ = true;
  are_reached_parts_known(motion, margin);  // boxes and counts of this search
}

// (5.5) Faces to ranks that do not know them, boxes of this search to all.
void ContactDecomposition::send_overlapping_faces() {
  if (!are_reached_known_) send_faces();
  has_changed_ = are_nodes_others_ || !are_reached_known_;
  send_boxes();  // in every search
}

void ContactDecomposition::begin_search(const SurfaceMotion& motion) {
  ++searches_;
  if (!parts_) parts_ = std::make_shared<AssignedParts>(exchange_.ranks());
  just_rebalanced_ = false;
  locate_points(motion);
}

/// Finds the owners of the points of a new surface by the cuts of the previous one. Returns whether nodes have other
/// owners now, on any rank.
bool ContactDecomposition::adopt_cuts() { return !knows_owners_ && report_.rebalances > 0 && find_new_owners(); }

void ContactDecomposition::locate_points(const SurfaceMotion& motion) {
  const Array<const int> list = share_.node_list;
  const Array<int> searched = to_view("contact::searched_nodes", searched_nodes_);
  const Rows4<const int> corners = share_.corner_list;
  const Rows3<double> out = points_.positions;
  const SurfaceMotion m = motion;
  const int num_nodes = static_cast<int>(searched_nodes_.size());
  const int num_points = num_nodes + static_cast<int>(share_.searched_faces.size());
  parallel_for(
      "contact::locate_points", RangeOf(ExecSpace(), 0, num_points), KOKKOS_LAMBDA(int i) {
        if (i < num_nodes) {
          store_row(out, i, load_row(m.x, list(searched(i))));
          return;
        }
        Point3 sum{};
        for (int c = 0; c < 4; ++c) sum = sum + load_row(m.x, corners(i - num_nodes, c));
        store_row(out, i, 0.25 * sum);
      });
  ExecSpace().fence();
}

/// Before the first bisection points stay with their FE owners.
RcbPoints ContactDecomposition::send_points_to_previous_owners() {
  if (report_.rebalances == 0) return {points_.positions, points_.ids, {}};
  const auto x = to_host(points_.positions);
  const auto ids = to_host(points_.ids);
  const SendOrder order = order_by_destination(owners_);
  std::vector<SentPoint> records;
  for (const int i : order.items) records.push_back({ids(i), {x(i, 0), x(i, 1), x(i, 2)}});
  const std::vector<SentPoint> received = data_.exchange(exchange_.plan(order.to), records);
  const Rows3<double> positions("contact::received_positions", received.size());
  std::vector<std::int64_t> received_ids;
  const auto host = Kokkos::create_mirror_view(positions);
  for (std::size_t i = 0; i < received.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) host(i, k) = received[i].x[k];
    received_ids.push_back(received[i].id);
  }
  copy_values(positions, host);
  return {positions, to_view("contact::received_ids", received_ids), {}};
}

void ContactDecomposition::take_report(const RcbReport& done) {
  ++report_.rebalances;
  points_at_rebalance_ = static_cast<std::int64_t>(points_.ids.extent(0));
  report_.imbalance = done.imbalance;
  report_.worst_imbalance = std::max(report_.worst_imbalance, done.imbalance);
  if (report_.rebalances > 1) {
    warm_rounds_ += done.rounds_per_cut;
    report_.rounds_per_cut = warm_rounds_ / static_cast<double>(report_.rebalances - 1);
  }
}

/// With the cuts every FE owner knows who owns its points. Returns whether a node of any rank has another owner now.
bool ContactDecomposition::find_new_owners() {
  const Array<int> owners("contact::owners", points_.ids.extent(0));
  find_owners(ExecSpace(), parts_->bisection().tree(), points_.positions, points_.ids, owners);
  ExecSpace().fence();
  const auto host = to_host(owners);
  const std::vector<int> before = node_owners();
  owners_.assign(host.data(), host.data() + host.extent(0));
  if (just_rebalanced_ && report_.rebalances == 1) assign_parts_once(owners_);
  for (int& owner : owners_) owner = parts_->find_rank(owner);
  int has_changed = !knows_owners_ || before != node_owners() ? 1 : 0;
  all_reduce(exchange_.ranks(), Reduce::largest, has_changed);
  knows_owners_ = true;
  return has_changed != 0;
}

/// Assigns parts, after the first bisection, to the ranks that have most of their points. parts: [points].
void ContactDecomposition::assign_parts_once(const std::vector<int>& parts) {
  const Communicator& ranks = exchange_.ranks();
  std::vector<int> rank_of_part = assign_parts(gather_items(ranks, find_overlaps(ranks.rank(), parts)), ranks.size());
  if (rank_of_part == parts_->rank_of_part()) return;
  const auto assigned = std::make_shared<AssignedParts>(ranks, std::move(rank_of_part));
  assigned->bisection().restore(parts_->bisection().cuts());
  parts_ = assigned;
}

std::vector<int> ContactDecomposition::node_owners() const {
  if (owners_.empty()) return std::vector<int>(searched_nodes_.size(), -1);
  return {owners_.begin(), owners_.begin() + static_cast<std::ptrdiff_t>(searched_nodes_.size())};
}

/// Sends the owners of nodes their numbers. Straight from the FE owners: the bisection moved no more than positions and
/// ids, to find the cuts.
void ContactDecomposition::send_nodes_to_owners() {
  const SendOrder order = order_by_destination(node_owners());
  node_plan_ = exchange_.plan(order.to);
  std::vector<NodeRecord> records;
  records.reserve(order.items.size());
  for (const int i : order.items) {
    const int n = searched_nodes_[at(i)];
    const int faces = share_.nodes.first_face[at(n) + 1] - share_.nodes.first_face[at(n)];
    records.push_back({share_.nodes.numbers[at(n)], share_.nodes.classes[at(n)], faces});
  }
  nodes_ = data_.exchange(node_plan_, records);
  sent_nodes_ = to_view("contact::sent_nodes", order.items);
  const std::vector<int> place = sort_by_number(nodes_);
  received_nodes_ = to_view("contact::received_nodes", place);
  if (share_.has_beams) {
    std::vector<double> radii;
    for (const int i : order.items) radii.push_back(share_.nodes.radii[at(searched_nodes_[at(i)])]);
    const std::vector<double> received = data_.exchange(node_plan_, radii);
    radii_.resize(received.size());
    for (std::size_t n = 0; n < received.size(); ++n) radii_[at(place[n])] = received[n];
  }
  places_ = Rows3<double>("contact::owned_places", nodes_.size());
}

/// Between rebalances the nodes may cross cuts: what boxes reach follows them.
void ContactDecomposition::send_places_to_owners() {
  send_rows<PlaceItem>(data_, node_plan_, points_.positions, sent_nodes_, places_, received_nodes_);
  if (!just_rebalanced_) parts_->bisection().refit(ExecSpace(), places_);
}

/// Whether all ranks that the boxes of this search reach know the faces.
bool ContactDecomposition::are_reached_parts_known(const SurfaceMotion& motion, double margin) {
  bound_faces(ExecSpace(), share_.bounded_faces(), motion, margin, boxes_);
  const ReachCount count = count_reached_parts(exchange_.ranks(), parts_->bisection().tree(), boxes_,
                                               static_cast<int>(share_.searched_faces.size()), margin, known_);
  reaching_faces_ = count.copies;
  return !count.any_unlisted;
}

/// Sends faces to the ranks of the parts that were listed for them.
void ContactDecomposition::send_faces() {
  const auto box = to_host(known_.box), part = to_host(known_.part);
  std::vector<int> to;
  to.reserve(part.extent(0));
  for (std::size_t i = 0; i < part.extent(0); ++i) to.push_back(parts_->find_rank(part(i)));
  const SendOrder order = order_by_destination(to);
  face_plan_ = exchange_.plan(order.to);
  std::vector<int> sent;
  std::vector<FaceTopology> records;
  sent.reserve(order.items.size());
  records.reserve(order.items.size());
  for (const int i : order.items) {
    sent.push_back(box(i));
    records.push_back(share_.faces[at(share_.searched_faces[at(sent.back())])]);
  }
  faces_ = data_.exchange(face_plan_, records);
  sent_faces_ = to_view("contact::sent_faces", sent);
  received_faces_ = to_view("contact::received_faces", sort_by_number(faces_));
  received_boxes_ = Boxes("contact::received_boxes", faces_.size());
}

void ContactDecomposition::send_boxes() {
  send_rows<BoxItem>(data_, face_plan_, boxes_, sent_faces_, received_boxes_, received_faces_);
}

std::int64_t ContactDecomposition::count_reaching_here() const {
  if (faces_.empty()) return 0;
  const std::vector<int>& ranks = parts_->rank_of_part();
  const int rank = exchange_.ranks().rank();
  const int own = static_cast<int>(std::find(ranks.begin(), ranks.end(), rank) - ranks.begin());
  return count_boxes_that_reach(parts_->bisection().tree(), received_boxes_, static_cast<int>(faces_.size()), own);
}

void ContactDecomposition::decide_rebalance(std::int64_t ghosts) {
  report_.ghost_faces = ghosts;
  // The search for overlap at the start has narrower boxes than those of the run: the second search counts.
  const bool is_second_of_all = report_.rebalances == 1 && searches_ == 2;
  if (just_rebalanced_ || is_second_of_all) ghosts_after_rebalance_ = ghosts;
  const auto grown = static_cast<double>(ghosts - exchange_.ranks().size());  // a face a rank is no growth
  switch (rebalance_) {
    case ContactDeck::Rebalance::always:
      is_due_ = true;
      break;
    case ContactDeck::Rebalance::never:
      is_due_ = false;
      break;
    case ContactDeck::Rebalance::automatic:
      is_due_ = grown > ghost_growth * static_cast<double>(ghosts_after_rebalance_);
      break;
  }
}

}  // namespace percuss
