#pragma once
// Data of foreign nodes that rows exchange with other ranks (the paper's section 4.3.2).

#include <array>
#include <vector>

#include "comm/exact_reduction.hpp"
#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"
#include "comm/merge_reduction.hpp"
#include "kernels/contact/enforcement/coupled_rows.hpp"
#include "kernels/contact/enforcement/enforcement.hpp"
#include "kernels/contact/enforcement/force_sums.hpp"
#include "src/contact/surface/contact_ranks.hpp"

namespace percuss {

/// The Others of kernels/contact/enforcement/row_solution.hpp. All calls are collective.
class RowExchange {
 public:
  /// Size of what rows read of a foreign node, when they are made.
  static constexpr int foreign_bytes = 128;

  explicit RowExchange(const ContactRanks& ranks);

  /// Sends the owners of foreign nodes the rows that touch these; receives the same for the own nodes. Fills
  /// num_foreign, num_remote, remote_node and remote_key of the system.
  void announce_foreign_nodes(const Array<const RowTouch>& touches, int num_touches, RowSystem& system);

  void receive_nodes(RowSystem& system);
  template <class Space>
  void send_coefficients(const Space& space, RowSystem& system) {
    if (!has_many_ranks_) return;
    get_foreign_shares(space, system, foreign_values_);
    space.fence();
    begin_sending();
    end_sending(system);
  }
  void receive_coefficients(RowSystem& system) { send_to_rows(system, system.abs_sum); }
  template <class Space>
  void send_impulses(const Space& space, RowSystem& system, PassSums& sums) {
    if (!has_many_ranks_) return;
    get_foreign_shares(space, system, foreign_values_);
    space.fence();
    begin_sending();
    reduce_pass_(ranks_.ranks, sums);  // while the impulses are under way
    end_sending(system);
  }
  void receive_corrections(RowSystem& system) { send_to_rows(system, system.correction); }
  /// Pushes on foreign nodes to the owners. remote: out, [num_remote].
  void send_pushes(const Array<const NormalPush>& foreign, const RowSystem& system, Array<NormalPush>& remote);
  void receive_bodies(RowSystem& system) { send_to_rows(system, system.bodies.marks); }
  void sum_bodies(std::vector<ExactSum>& sums) {
    if (has_many_ranks_) sum_over_ranks(ranks_.ranks, sums);
  }
  void reduce(EnforcementSums& sums);
  /// Gathers the rows of all ranks on the first one, which solves them in the order of their keys.
  CoupledReport solve_together(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses);

  const Traffic& traffic() const { return data_.traffic(); }

 private:
  struct ForeignNotice;
  struct ForeignData;

  /// One value of each foreign node, in foreign_values_, to its owner: RowSystem::remote.
  void begin_sending();
  void end_sending(RowSystem& system);
  void send_to_rows(const RowSystem& system, const Rows3<double>& by_place);

  const ContactRanks ranks_;
  const bool has_many_ranks_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  MergeReduction<PassSums> reduce_pass_;
  MergeReduction<EnforcementSums> reduce_outcome_;
  // Item k of the messages is foreign node order_[k] of the rows, and remote entry k of the owner.
  ExchangePlan plan_;
  std::vector<int> order_;
  Rows3<double> foreign_values_ = Rows3<double>("contact::foreign_values", 0);
  std::vector<std::array<double, 3>> send_, receive_;
};

}  // namespace percuss
