#include "src/contact/enforcement/row_exchange.hpp"

#include <algorithm>

#include "comm/exchange/item_exchange.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/views.hpp"
#include "src/index.hpp"

namespace percuss {
/// A foreign node in the message to its owner.
struct RowExchange::ForeignNotice {
  std::int64_t node = 0;  // number
  std::int64_t key = 0;   // of the row
};

/// What a row needs of a foreign node.
struct RowExchange::ForeignData {
  std::array<double, 3> x, v, v_before, v_seen, inverse_mass;
  double spring = 0;
};

RowExchange::RowExchange(const ContactRanks& ranks)
    : ranks_(ranks), has_many_ranks_(ranks.ranks.size() > 1), exchange_(ranks.ranks), data_(ranks.ranks) {}

void RowExchange::announce_foreign_nodes(const Array<const RowTouch>& touches, int num_touches, RowSystem& system) {
  system.num_foreign = 0;
  system.num_remote = 0;
  if (!has_many_ranks_) return;
  const auto list = to_host(touches);
  std::vector<ForeignNotice> notices;
  std::vector<int> owners;
  for (int r = 0; r < num_touches; ++r) {
    for (int slot = 0; slot < list(r).count; ++slot) {
      if (list(r).node[slot] >= 0) continue;
      notices.push_back({list(r).node_number[slot], list(r).key});
      owners.push_back(ranks_.numbering.find_node_owner(notices.back().node));
    }
  }
  SendOrder order = order_by_destination(owners);
  plan_ = exchange_.plan(order.to);
  const std::vector<ForeignNotice> ordered = ItemExchange::arrange(order, notices);
  order_ = std::move(order.items);
  const std::vector<std::int64_t>& numbers = ranks_.mesh.node_numbers;
  std::vector<int> nodes;
  std::vector<std::int64_t> keys;
  for (const ForeignNotice& notice : data_.exchange(plan_, ordered)) {
    nodes.push_back(static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), notice.node) - numbers.begin()));
    keys.push_back(notice.key);
  }
  std::vector<std::int64_t> foreign;
  foreign.reserve(notices.size());
  for (const ForeignNotice& notice : notices) foreign.push_back(notice.node);
  system.foreign_number = to_view("contact::foreign_number", foreign);
  system.num_foreign = static_cast<int>(notices.size());
  system.num_remote = static_cast<int>(nodes.size());
  system.remote_node = to_view("contact::remote_node", nodes);
  system.remote_key = to_view("contact::remote_key", keys);
  reserve(system.remote, system.num_remote);
  reserve(foreign_values_, system.num_foreign);
}

/// Positions, velocities and masses of the foreign nodes, after those of the own ones.
void RowExchange::receive_nodes(RowSystem& system) {
  if (!has_many_ranks_) return;
  constexpr std::size_t count = 5;
  RowNodes& at_places = system.at;
  const Rows3<double>* const rows[count] = {&at_places.x, &at_places.v, &at_places.v_before, &at_places.v_seen,
                                            &at_places.inverse_mass};
  std::array<double, 3> ForeignData::*const members[count] = {&ForeignData::x, &ForeignData::v, &ForeignData::v_before,
                                                              &ForeignData::v_seen, &ForeignData::inverse_mass};
  const auto place = to_host(system.remote_place);
  const auto spring = to_host(system.at.spring);
  const bool has_springs = spring.extent(0) > 0;
  static_assert(sizeof(ForeignData) == foreign_bytes);
  std::vector<ForeignData> send(at(system.num_remote));
  std::vector<HostMirror<Rows3<double>>> hosts;
  for (const Rows3<double>* view : rows) hosts.push_back(to_host(*view));
  for (std::size_t k = 0; k < send.size(); ++k) {
    const auto a = at(place(k));
    for (std::size_t i = 0; i < count; ++i) send[k].*members[i] = {hosts[i](a, 0), hosts[i](a, 1), hosts[i](a, 2)};
    if (has_springs) send[k].spring = spring(a);
  }
  const std::vector<ForeignData> received = data_.exchange(reverse(plan_), send);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < received.size(); ++k) {
      const auto a = at(system.num_nodes + order_[k]);
      for (std::size_t d = 0; d < 3; ++d) hosts[i](a, d) = (received[k].*members[i])[d];
    }
    Kokkos::deep_copy(*rows[i], hosts[i]);
  }
  if (!has_springs) return;
  for (std::size_t k = 0; k < received.size(); ++k) spring(at(system.num_nodes + order_[k])) = received[k].spring;
  Kokkos::deep_copy(system.at.spring, spring);
}

void RowExchange::begin_sending() {
  const auto host = to_host(foreign_values_);
  send_.resize(order_.size());
  receive_.resize(static_cast<std::size_t>(plan_.receive_count()));
  for (std::size_t k = 0; k < send_.size(); ++k) {
    const auto i = at(order_[k]);
    send_[k] = {host(i, 0), host(i, 1), host(i, 2)};
  }
  data_.begin<std::array<double, 3>>(plan_, send_, receive_);
}

void RowExchange::end_sending(RowSystem& system) {
  data_.end();
  const auto remote = Kokkos::create_mirror_view(system.remote);
  for (std::size_t k = 0; k < receive_.size(); ++k) {
    for (std::size_t d = 0; d < 3; ++d) remote(k, d) = receive_[k][d];
  }
  Kokkos::deep_copy(system.remote, remote);
}

/// Values of own nodes back to the rows that touch them as foreign nodes.
void RowExchange::send_to_rows(const RowSystem& system, const Rows3<double>& by_place) {
  if (!has_many_ranks_) return;
  const auto host = to_host(by_place);
  const auto place = to_host(system.remote_place);
  receive_.resize(order_.size());
  send_.resize(at(system.num_remote));
  for (std::size_t k = 0; k < send_.size(); ++k) {
    const auto a = at(place(k));
    send_[k] = {host(a, 0), host(a, 1), host(a, 2)};
  }
  data_.begin<std::array<double, 3>>(reverse(plan_), send_, receive_);
  data_.end();
  for (std::size_t k = 0; k < receive_.size(); ++k) {
    const auto a = at(system.num_nodes + order_[k]);
    for (std::size_t d = 0; d < 3; ++d) host(a, d) = receive_[k][d];
  }
  Kokkos::deep_copy(by_place, host);
}

void RowExchange::send_pushes(const Array<const NormalPush>& foreign, const RowSystem& system,
                              Array<NormalPush>& remote) {
  if (!has_many_ranks_) return;
  const auto host = to_host(foreign);
  std::vector<NormalPush> ordered;
  ordered.reserve(order_.size());
  for (const int k : order_) ordered.push_back(host(at(k)));
  const std::vector<NormalPush> received = data_.exchange(plan_, ordered);
  reserve(remote, system.num_remote);
  const auto mirror = Kokkos::create_mirror_view(remote);
  for (std::size_t k = 0; k < received.size(); ++k) mirror(k) = received[k];
  Kokkos::deep_copy(remote, mirror);
}

CoupledReport RowExchange::solve_together(const std::vector<CoupledRow>& rows, double dt,
                                          std::vector<RowImpulse>& impulses) {
  if (!has_many_ranks_) return solve_in_key_order(rows, dt, impulses);
  const ExchangePlan plan = exchange_.plan(order_by_destination(std::vector<int>(rows.size(), 0)).to);
  const std::vector<CoupledRow> gathered = data_.exchange(plan, rows);
  std::vector<RowImpulse> found;
  CoupledReport report;
  if (ranks_.ranks.rank() == 0) report = solve_in_key_order(gathered, dt, found);
  impulses = data_.exchange(reverse(plan), found);
  wait_mpi([&] { return MPI_Bcast(&report, sizeof(report), MPI_BYTE, 0, ranks_.ranks.handle()); }, "MPI_Bcast");
  return report;
}

void RowExchange::reduce(EnforcementSums& sums) {
  if (!has_many_ranks_) return;
  sums.normal_work.normalize();
  sums.friction_work.normalize();
  sums.stored.normalize();
  reduce_outcome_(ranks_.ranks, sums);
}

}  // namespace percuss
