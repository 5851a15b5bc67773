#pragma once
// What ranks whose rows touch the same nodes exchange (the paper's section 4.3.2).
//
// The nodes that rows touch beyond their own rank have a place on each rank with such rows. All ranks that have a place
// of a node, its owner among them, swap the shares of their rows in it: one message to each neighbour and iteration,
// after which everybody adds up the same numbers in the same order.

#include <array>
#include <cstdint>
#include <vector>

#include "comm/exact_reduction.hpp"
#include "comm/exchange/counted_exchange.hpp"
#include "comm/exchange/data_exchange.hpp"
#include "comm/exchange/exchange_buffers.hpp"
#include "comm/exchange/persistent_exchange.hpp"
#include "comm/exchange/unstructured_exchange.hpp"
#include "comm/merge_reduction.hpp"
#include "comm/team.hpp"
#include "kernels/contact/enforcement/coupled_rows.hpp"
#include "kernels/contact/enforcement/enforcement.hpp"
#include "kernels/contact/enforcement/force_sums.hpp"
#include "kernels/contact/enforcement/rigid_rows.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/enforcement/shared_entries.hpp"
#include "src/contact/surface/contact_ranks.hpp"

namespace percuss {

/// Knowledge of the ranks about each other's rows, before these are made.
struct RowMeeting {
  bool any_rows = false;  // on any rank
  bool is_same = false;   // all ranks found what they did in the last step
};

/// Sums of the rows of a step, of all ranks.
struct RowOutcome {
  EnforcementSums sums;
  std::int64_t iterations = 0, failures = 0;  // failures: ranks whose iteration did not converge
  double complementarity = 0;

  void merge(const RowOutcome& other);
};

/// The Others of kernels/contact/enforcement/row_solution.hpp. Calls are collective over the ranks that take part, if
/// nothing else is said.
class RowExchange {
 public:
  explicit RowExchange(const ContactRanks& ranks);

  /// Lists the foreign nodes of the touches. Not collective.
  void find_foreign_nodes(const Array<const RowTouch>& touches, int num_touches, RowSystem& system);

  /// Tells all ranks who has rows and who touches whose nodes: the fold of the paper's Figure 2, read by everybody. In:
  /// num_rows and foreign nodes of the system. everybody: all ranks take part as soon as any has rows. Collective over
  /// all ranks.
  RowMeeting meet(const RowSystem& system, bool is_same, bool everybody);

  /// Sends the owners of foreign nodes the rows that touch these; receives the same for the own nodes. Fills
  /// remote_node of the system.
  void announce_foreign_nodes(RowSystem& system);

  /// Whether this rank works on the rows with others: it has some, or nodes that rows of others touch, or had so lately
  /// (comm/team.hpp).
  bool takes_part(const RowSystem&) const { return takes_part_; }
  /// Whether rows touch nodes of a rank.
  bool is_touched(int rank) const { return has_part_[static_cast<std::size_t>(rank)] != 0; }

  void receive_nodes(const RowInputs& inputs, const RowSources& sources, RowSystem& system);
  void swap_shares(const WorkSpace& space, RowSystem& system) {
    if (!has_many_ranks_) return;
    begin_swap(space, system);
    end_swap(system);
  }
  void swap_shares(const WorkSpace& space, RowSystem& system, PassSums& sums) {
    if (!has_many_ranks_) return;
    begin_swap(space, system);
    if (team_.size() > 1) reduce_pass_(team_.ranks(), sums);  // while the shares are under way
    end_swap(system);
  }
  /// Pushes of the sent entries to those who want them. remote: out, [num_remote].
  void send_pushes(const Array<const NormalPush>& sent, const RowSystem& system, Array<NormalPush>& remote);
  /// Collective over all ranks, as are the other two.
  void sum_bodies(std::vector<ExactSum>& sums) {
    if (has_many_ranks_) sum_over_ranks(ranks_.ranks, sums);
  }
  void reduce(RowOutcome& outcome);
  /// Gathers the rows of all ranks on the first one, which solves them in the order of their keys.
  CoupledReport solve_together(const std::vector<CoupledRow>& rows, double dt, std::vector<RowImpulse>& impulses);

  /// Gathers the rows between rigid bodies likewise, if there are any.
  RigidReport solve_rigid(const RigidRowList& list, const RigidQuery& query, std::vector<RigidImpulse>& impulses);

  Traffic traffic() const;

 private:
  template <class Report, class Row, class Impulse, class Solve>
  Report solve_on_first_rank(const std::vector<Row>& rows, std::vector<Impulse>& impulses, const Solve& solve);
  void begin_swap(const WorkSpace& space, const RowSystem& system) {
    get_sent_shares(space, system, sent_values_);
    space.fence();
    copy_values(send_buffer_, sent_values_);
    swap_.begin();
  }
  void end_swap(RowSystem& system);
  std::vector<SharedEntry> list_entries_on_own_nodes(const RowSources& sources, const RowSystem& system) const;
  void take_answers(const std::vector<AnswerWord>& words, int first_place, HostRowNodes& nodes,
                    std::vector<SharedEntry>& entries) const;
  void prepare_swap(RowSystem& system);

  const ContactRanks ranks_;
  const bool has_many_ranks_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  CountedExchange notices_;
  PersistentExchange swap_;
  Team team_;
  MergeReduction<PassSums> reduce_pass_;
  MergeReduction<RowOutcome> reduce_outcome_;
  bool takes_part_ = false;
  std::vector<char> has_part_;  // [ranks]
  int num_senders_ = 0;         // ranks that touch nodes of this one
  ForeignNodes foreign_;
  std::vector<RowNotice> received_;  // of rows that touch own nodes, by rank, then as sent
  ExchangePlan notice_plan_;
  SwapLists lists_;
  Rows3<double> sent_values_ = Rows3<double>("contact::sent_values", 0);
  HostMirror<Rows3<double>> send_buffer_, receive_buffer_;
};

}  // namespace percuss
