#include "src/contact/enforcer.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Iteration ends when no impulse changes by more than would close this share of the largest predicted penetration ...
constexpr double relative_tolerance = 1e-3;
/// ... or this share of the smallest h.
constexpr double absolute_tolerance = 1e-10;
constexpr int max_iterations = 1000;

/// Shared nodes with their owners as the mesh numbers them.
SharedNodes find_copies(UnstructuredExchange& exchange, const ContactRanks& ranks) {
  SharedNodes shared = find_shared_nodes(exchange, ranks.mesh.node_numbers);
  for (std::size_t n = 0; n < shared.owners.size(); ++n) {
    shared.owners[n] = ranks.numbering.find_node_owner(ranks.mesh.node_numbers[n]);
  }
  return shared;
}

}  // namespace

/// A foreign node as its owner is told of it.
struct Enforcer::ForeignNotice {
  std::int64_t node = 0;  // number
  std::int64_t key = 0;   // of the row
};

/// What a row needs of a foreign node.
struct Enforcer::ForeignData {
  std::array<double, 3> x, v, v_before, inverse_mass;
};

Enforcer::Enforcer(const ContactRanks& ranks, const WallPairs& walls)
    : ranks_(ranks),
      walls_(walls),
      node_numbers_(to_view("contact::mesh_node_numbers", ranks.mesh.node_numbers)),
      has_many_ranks_(ranks.ranks.size() > 1),
      exchange_(ranks.ranks),
      data_(ranks.ranks),
      copied_(find_copies(exchange_, ranks)),
      velocity_copies_(ranks.ranks, copied_),
      impulse_copies_(ranks.ranks, copied_) {}

template <class T>
void Enforcer::reduce(T& value) {
  if (!has_many_ranks_) return;
  if constexpr (std::is_same_v<T, PredictedGaps>) reduce_gaps_(ranks_.ranks, value);
  if constexpr (std::is_same_v<T, EnforcementSums>) {
    value.normal_work.normalize();
    value.friction_work.normalize();
    reduce_outcome_(ranks_.ranks, value);
  }
}

void Enforcer::clear_last_impulse(const ContactMotion& motion) {
  // Only the nodes of the last step's rows can be set, if it is the same memory; copies of them are not listed.
  if (last_impulse_ != motion.impulse.data() || (was_pushed_ && has_many_ranks_)) {
    Kokkos::deep_copy(ExecSpace(), motion.impulse, 0.0);
  } else if (was_pushed_) {
    run_where_it_pays(system_.num_nodes / 10,
                      [&](const auto& space) { clear_impulses(space, system_, motion.impulse); });
  }
  last_impulse_ = motion.impulse.data();
  was_pushed_ = false;
}

/// Tells the owners of foreign nodes which rows touch these; learns the same of the own nodes.
void Enforcer::announce_foreign_nodes(const Array<const RowTouch>& touches, int num_touches) {
  system_.num_foreign = 0;
  system_.num_remote = 0;
  if (!has_many_ranks_) return;
  const auto list = to_host(touches);
  std::vector<ForeignNotice> notices;
  std::vector<int> owners;
  for (int r = 0; r < num_touches; ++r) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (list(r).node[i + 1] >= 0) continue;
      notices.push_back({list(r).corner_number[i], list(r).key});
      owners.push_back(ranks_.numbering.find_node_owner(notices.back().node));
    }
  }
  SendOrder order = order_by_destination(owners);
  plan_ = exchange_.plan(order.to);
  foreign_order_ = std::move(order.items);
  std::vector<ForeignNotice> ordered;
  for (const int k : foreign_order_) ordered.push_back(notices[at(k)]);
  const std::vector<ForeignNotice> received = data_.exchange(plan_, ordered);
  std::vector<std::int64_t> keys;
  remote_nodes_.clear();
  for (const ForeignNotice& notice : received) {
    const std::vector<std::int64_t>& numbers = ranks_.mesh.node_numbers;
    remote_nodes_.push_back(
        static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), notice.node) - numbers.begin()));
    keys.push_back(notice.key);
  }
  system_.num_foreign = static_cast<int>(notices.size());
  system_.num_remote = static_cast<int>(received.size());
  system_.remote_node = to_view("contact::remote_node", remote_nodes_);
  system_.remote_key = to_view("contact::remote_key", keys);
  reserve(system_.remote, system_.num_remote);
  reserve(foreign_values_, system_.num_foreign);
}

/// Places, velocities and masses of the foreign nodes, after those of the own ones.
void Enforcer::receive_foreign_data() {
  if (!has_many_ranks_) return;
  const Rows3<double>* const rows[4] = {&system_.at.x, &system_.at.v, &system_.at.v_before, &system_.at.inverse_mass};
  std::array<double, 3> ForeignData::*const members[4] = {&ForeignData::x, &ForeignData::v, &ForeignData::v_before,
                                                          &ForeignData::inverse_mass};
  const auto place = to_host(system_.remote_place);
  std::vector<ForeignData> send(remote_nodes_.size());
  std::vector<Rows3<double>::HostMirror> hosts;
  for (const Rows3<double>* view : rows) hosts.push_back(to_host(*view));
  for (std::size_t k = 0; k < send.size(); ++k) {
    const auto a = at(place(k));
    for (std::size_t i = 0; i < 4; ++i) send[k].*members[i] = {hosts[i](a, 0), hosts[i](a, 1), hosts[i](a, 2)};
  }
  const std::vector<ForeignData> received = data_.exchange(reverse(plan_), send);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < received.size(); ++k) {
      const auto a = at(system_.num_nodes + foreign_order_[k]);
      for (std::size_t d = 0; d < 3; ++d) hosts[i](a, d) = (received[k].*members[i])[d];
    }
    Kokkos::deep_copy(*rows[i], hosts[i]);
  }
}

/// One value of each foreign node to its owner: system_.remote.
void Enforcer::send_to_owners(const Rows3<double>& values) {
  const auto host = to_host(values);
  send_.resize(foreign_order_.size());
  receive_.resize(at(system_.num_remote));
  for (std::size_t k = 0; k < send_.size(); ++k) {
    const auto i = at(foreign_order_[k]);
    send_[k] = {host(i, 0), host(i, 1), host(i, 2)};
  }
  data_.begin<std::array<double, 3>>(plan_, send_, receive_);
  data_.end();
  const auto remote = Kokkos::create_mirror_view(system_.remote);
  for (std::size_t k = 0; k < receive_.size(); ++k) {
    for (std::size_t d = 0; d < 3; ++d) remote(k, d) = receive_[k][d];
  }
  Kokkos::deep_copy(system_.remote, remote);
}

/// Values of own nodes back to the rows that touch them as foreign nodes.
void Enforcer::send_to_rows(const Rows3<double>& by_place) {
  const auto host = to_host(by_place);
  const auto place = to_host(system_.remote_place);
  receive_.resize(foreign_order_.size());
  send_.resize(at(system_.num_remote));
  for (std::size_t k = 0; k < send_.size(); ++k) {
    const auto a = at(place(k));
    send_[k] = {host(a, 0), host(a, 1), host(a, 2)};
  }
  data_.begin<std::array<double, 3>>(reverse(plan_), send_, receive_);
  data_.end();
  for (std::size_t k = 0; k < receive_.size(); ++k) {
    const auto a = at(system_.num_nodes + foreign_order_[k]);
    for (std::size_t d = 0; d < 3; ++d) host(a, d) = receive_[k][d];
  }
  Kokkos::deep_copy(by_place, host);
}

template <class Space>
void Enforcer::build(const Space& space, const RowInputs& inputs, const Array<const RowTouch>& touches, int num_touches,
                     const ContactHistory& history) {
  start_rows(space, inputs, touches, num_touches, walls_, system_);
  space.fence();
  receive_foreign_data();
  make_rows(space, inputs, touches, num_touches, walls_, history, system_);
  if (has_many_ranks_) {
    find_foreign_coefficients(space, system_, foreign_values_);
    space.fence();
    send_to_owners(foreign_values_);
  }
  sum_coefficients(space, system_);
  if (has_many_ranks_) {
    space.fence();
    send_to_rows(system_.abs_sum);
  }
  sum_stiffness(space, system_);
}

/// The motion that the impulses cause, on both sides of every contact. sums: of the pass that found the impulses,
/// reduced over the ranks meanwhile.
template <class Space>
void Enforcer::move_nodes(const Space& space, PassSums& sums) {
  if (has_many_ranks_) {
    sums.backwards.normalize();
    reduce_pass_.begin(ranks_.ranks, sums);
    find_foreign_impulses(space, system_, foreign_values_);
    space.fence();
    send_to_owners(foreign_values_);
    reduce_pass_.end();
  }
  find_corrections(space, system_);
  if (has_many_ranks_) {
    space.fence();
    send_to_rows(system_.correction);
  }
}

template <class Space>
void Enforcer::solve(const Space& space, double dt, const PredictedGaps& gaps, ContactReport& report) {
  const double tolerance = std::max(relative_tolerance * gaps.deepest, absolute_tolerance * gaps.smallest_size);
  double beta = 0, t = 1;
  report.converged = false;
  PassSums sums;
  move_nodes(space, sums);
  extrapolate_corrections(space, beta, system_);
  while (!report.converged && report.iterations < max_iterations) {
    sums = correct_rows(space, beta, dt, system_, sums_);
    move_nodes(space, sums);
    ++report.iterations;
    report.converged = sums.change <= tolerance;
    const double next_t = 0.5 * (1 + std::sqrt(1 + 4 * t * t));
    const bool restart = sums.backwards.round() > 0 || report.converged;
    beta = restart ? 0 : (t - 1) / next_t;
    t = restart ? 1 : next_t;
    extrapolate_corrections(space, beta, system_);
  }
}

/// Copies of nodes on other ranks get what their owners found.
void Enforcer::update_copies(const ContactMotion& motion) {
  if (!has_many_ranks_) return;
  velocity_copies_.begin(ExecSpace(), motion.v);
  impulse_copies_.begin(ExecSpace(), motion.impulse);
  velocity_copies_.end(ExecSpace(), motion.v);
  impulse_copies_.end(ExecSpace(), motion.impulse);
}

void Enforcer::rest(const ContactMotion& motion, const ContactHistory& history) {
  clear_last_impulse(motion);
  last_dt_ = motion.dt;
  if (remembers_) Kokkos::deep_copy(history.face, std::int64_t{-1});
  remembers_ = false;
}

void Enforcer::enforce(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
                       const ContactHistory& history, ContactReport& report) {
  clear_last_impulse(motion);
  const RowInputs inputs{{motion.x, motion.v, motion.dt},
                         motion.v_before,
                         motion.inverse_mass,
                         node_numbers_,
                         last_dt_ > 0 ? motion.dt / last_dt_ : 1};
  last_dt_ = motion.dt;
  const int wall_pairs = static_cast<int>(walls_.node.extent(0));
  announce_foreign_nodes(touches, num_touches);
  // A row's solution costs some dozen passes; a wall's pair that is out of reach costs one look.
  run_where_it_pays(num_touches + wall_pairs / 8, [&](const auto& space) {
    build(space, inputs, touches, num_touches, history);
    PredictedGaps gaps = find_predicted_gaps(space, system_, sums_);
    reduce(gaps);
    if (gaps.rows > 0) {
      solve(space, motion.dt, gaps, report);
      apply_impulses(space, system_, motion.v, motion.impulse);
      EnforcementSums done = sum_outcome(space, motion.dt, system_, sums_);
      reduce(done);
      report.interactions = static_cast<int>(done.pushes);
      report.normal_work = done.normal_work.round();
      report.friction_work = done.friction_work.round();
      report.residual = done.residual;
      report.deepest = done.deepest;
      report.deepest_node = done.deepest_key < 0 ? -1 : find_key_node(done.deepest_key);
      space.fence();
      update_copies(motion);
      was_pushed_ = true;
    }
    write_history(space, motion.dt, system_, history);
    remembers_ = true;
    space.fence();
  });
}

}  // namespace percuss
