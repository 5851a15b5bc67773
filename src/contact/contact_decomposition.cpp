#include "src/contact/contact_decomposition.hpp"

#include <algorithm>
#include <utility>

#include "kernels/contact/capture_boxes.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Growth of the copies of faces at which cuts are worth renewing.
constexpr double ghost_growth = 1.15;
/// Change of the number of points, where erosion redefines the surface, at which they are.
constexpr double point_growth = 1.1;

/// A point on its way to the rank that owned it before.
struct SentPoint {
  std::int64_t id = 0;
  double x[3] = {0, 0, 0};
};

/// The places of records in the order of their numbers. Sorted are numbers with places: a record is a line of memory
/// or more, moved once.
template <class Record, class GetNumber>
std::vector<int> find_number_order(const std::vector<Record>& records, const GetNumber& get_number) {
  std::vector<std::pair<std::int64_t, int>> numbers;
  numbers.reserve(records.size());
  for (const Record& record : records) numbers.emplace_back(get_number(record), static_cast<int>(numbers.size()));
  std::sort(numbers.begin(), numbers.end());
  std::vector<int> order;
  order.reserve(numbers.size());
  for (const auto& [number, place] : numbers) order.push_back(place);
  return order;
}

template <class Record>
std::vector<Record> take_in_order(const std::vector<Record>& records, const std::vector<int>& order) {
  std::vector<Record> result;
  result.reserve(order.size());
  for (const int i : order) result.push_back(records[at(i)]);
  return result;
}

}  // namespace

ContactDecomposition::ContactDecomposition(const Communicator& ranks, const SurfaceShare& share,
                                           ContactDeck::Rebalance rebalance)
    : share_(share),
      rebalance_(rebalance),
      exchange_(ranks),
      data_(ranks),
      rcb_(ranks),
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
  rcb_.restore(before.rcb_.cuts());
  std::int64_t counts[2] = {static_cast<std::int64_t>(points_.ids.extent(0)), points_at_rebalance_};
  wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_INT64_T, MPI_SUM, exchange_.ranks().handle()); },
           "MPI_Allreduce");
  const auto points = static_cast<double>(counts[0]), earlier = static_cast<double>(counts[1]);
  const bool has_changed = points > point_growth * earlier || earlier > point_growth * points;
  is_due_ = before.is_due_ || (has_changed && rebalance_ != ContactDeck::Rebalance::never);
}

void ContactDecomposition::update(const SurfaceMotion& motion, double margin) {
  ++searches_;
  locate_points(motion);
  if (!knows_owners_ && report_.rebalances > 0) find_new_owners();  // of another surface's cuts
  just_rebalanced_ = is_due_;
  if (is_due_) {
    rebalance_points(send_contact_data_to_previous_owners());
    find_new_owners();
  }
  send_nodes_to_owners();
  list_reached_ranks(motion, margin);
  send_overlapping_faces();
}

void ContactDecomposition::locate_points(const SurfaceMotion& motion) {
  const Array<const int> list = share_.node_list;
  const Array<int> searched = to_view("contact::searched_nodes", searched_nodes_);
  const Rows4<const int> corners = share_.corner_list;
  const Rows3<double> out = points_.positions;
  const SurfaceMotion m = motion;
  const int num_nodes = static_cast<int>(searched_nodes_.size());
  const int num_points = num_nodes + static_cast<int>(share_.searched_faces.size());
  Kokkos::parallel_for(
      "contact::locate_points", Range(ExecSpace(), 0, num_points), KOKKOS_LAMBDA(int i) {
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

// (5.1) Points go to the rank that owned them before, so that bisection finds nearly all where they belong. Before the
// first bisection they stay with their FE owners.
RcbPoints ContactDecomposition::send_contact_data_to_previous_owners() {
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
  Kokkos::deep_copy(positions, host);
  return {positions, to_view("contact::received_ids", received_ids), {}};
}

// (5.2) and (5.3): the bisection ends with the cuts known to all ranks.
void ContactDecomposition::rebalance_points(const RcbPoints& points) {
  const RcbReport done = rcb_.decompose(ExecSpace(), points);
  ++report_.rebalances;
  points_at_rebalance_ = static_cast<std::int64_t>(points_.ids.extent(0));
  report_.imbalance = done.imbalance;
  report_.worst_imbalance = std::max(report_.worst_imbalance, done.imbalance);
  if (report_.rebalances > 1) {
    warm_rounds_ += done.rounds_per_cut;
    report_.rounds_per_cut = warm_rounds_ / static_cast<double>(report_.rebalances - 1);
  }
}

/// With the cuts every FE owner knows who owns its points.
void ContactDecomposition::find_new_owners() {
  const Array<int> owners("contact::owners", points_.ids.extent(0));
  find_owners(ExecSpace(), rcb_.tree(), points_.positions, points_.ids, owners);
  ExecSpace().fence();
  const auto host = to_host(owners);
  owners_.assign(host.data(), host.data() + host.extent(0));
  knows_owners_ = true;
  node_order_ = order_by_destination(node_owners());
  node_plan_ = exchange_.plan(node_order_.to);
  received_order_.clear();
}

std::vector<int> ContactDecomposition::node_owners() const {
  if (owners_.empty()) return std::vector<int>(searched_nodes_.size(), -1);
  return {owners_.begin(), owners_.begin() + static_cast<std::ptrdiff_t>(searched_nodes_.size())};
}

/// The places of the nodes to their owners. Between rebalances the nodes may cross cuts: what boxes reach follows them.
void ContactDecomposition::send_nodes_to_owners() {
  const auto x = to_host(points_.positions);
  std::vector<NodeRecord> records;
  for (const int i : node_order_.items) {
    const int n = searched_nodes_[at(i)];
    records.push_back({share_.nodes.numbers[at(n)], {x(i, 0), x(i, 1), x(i, 2)}, share_.nodes.classes[at(n)]});
  }
  const std::vector<NodeRecord> received = data_.exchange(node_plan_, records);
  if (received_order_.size() != received.size())
    received_order_ = find_number_order(received, [](const NodeRecord& node) { return node.number; });
  nodes_ = take_in_order(received, received_order_);
  if (just_rebalanced_) return;
  const Rows3<double> positions("contact::owned_positions", nodes_.size());
  const auto host = Kokkos::create_mirror_view(positions);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) host(i, k) = nodes_[i].x[k];
  }
  Kokkos::deep_copy(positions, host);
  rcb_.refit(ExecSpace(), positions);
}

// (5.4) For all my faces: which ranks does the capture box reach?
void ContactDecomposition::list_reached_ranks(const SurfaceMotion& motion, double margin) {
  bound_faces(ExecSpace(), share_.bounded_faces(), motion, margin, boxes_);
  reached_ = percuss::list_reached_ranks(exchange_.ranks(), rcb_.tree(), boxes_,
                                         static_cast<int>(share_.searched_faces.size()), margin, reach_count_);
}

// (5.5) Faces to the ranks that need them.
void ContactDecomposition::send_overlapping_faces() {
  const SendOrder order = order_by_destination(reached_.rank);
  const auto boxes = to_host(boxes_);
  std::vector<FaceRecord> records;
  records.reserve(order.items.size());
  for (const int i : order.items) {
    const int f = reached_.box[at(i)];
    FaceRecord record{share_.faces[at(share_.searched_faces[at(f)])], {}};
    for (std::size_t k = 0; k < 6; ++k) record.box[k] = boxes(f, k);
    records.push_back(record);
  }
  const std::vector<FaceRecord> received = data_.exchange(exchange_.plan(order.to), records);
  faces_ =
      take_in_order(received, find_number_order(received, [](const FaceRecord& face) { return face.face.number; }));
}

void ContactDecomposition::note_ghost_faces(std::int64_t ghosts) {
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
