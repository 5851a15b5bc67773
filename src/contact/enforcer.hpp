#pragma once
// Enforcement (1.9) in the FE decomposition, on all ranks together (the paper's section 4.3.2).
//
// A row belongs to the rank that owns its contact node; corners of its face may be owned elsewhere. In each iteration
// the rows' forces on such foreign nodes go to their owners, who add up all forces on a node in one global order, and
// the accelerations that they cause come back. The reduction that tells whether the iteration has converged is under
// way with them.

#include "comm/data_exchange.hpp"
#include "comm/merge_reduction.hpp"
#include "comm/node_copies.hpp"
#include "kernels/contact/enforcement.hpp"
#include "src/contact/contact_finder.hpp"
#include "src/contact/contact_stage.hpp"

namespace percuss {

class Enforcer {
 public:
  /// Collective.
  Enforcer(const ContactRanks& ranks, const WallPairs& walls);

  /// Corrects motion.v and fills motion.impulse for the touches of this rank's contact nodes, on every copy of a node;
  /// writes the history for the next step; fills in what the report says of enforcement. Collective.
  void enforce(const ContactMotion& motion, const Array<const RowTouch>& touches, int num_touches,
               const ContactHistory& history, ContactReport& report);

  /// A step in which nothing touches on any rank: no impulses, nothing to remember.
  void rest(const ContactMotion& motion, const ContactHistory& history);

  const Traffic& traffic() const { return data_.traffic(); }

 private:
  struct ForeignNotice;
  struct ForeignData;

  void clear_last_impulse(const ContactMotion& motion);
  void announce_foreign_nodes(const Array<const RowTouch>& touches, int num_touches);
  template <class Space>
  void build(const Space& space, const RowInputs& inputs, const Array<const RowTouch>& touches, int num_touches,
             const ContactHistory& history);
  void receive_foreign_data();
  template <class Space>
  void solve(const Space& space, double dt, const PredictedGaps& gaps, ContactReport& report);
  template <class Space>
  void move_nodes(const Space& space, PassSums& sums);
  void send_to_owners(const Rows3<double>& values);
  void send_to_rows(const Rows3<double>& by_place);
  void update_copies(const ContactMotion& motion);
  template <class T>
  void reduce(T& value);

  const ContactRanks ranks_;
  const WallPairs walls_;
  Array<const std::int64_t> node_numbers_;  // [mesh nodes]
  const bool has_many_ranks_;
  UnstructuredExchange exchange_;
  DataExchange data_;
  const SharedNodes copied_;
  NodeCopies velocity_copies_, impulse_copies_;
  MergeReduction<PredictedGaps> reduce_gaps_;
  MergeReduction<PassSums> reduce_pass_;
  MergeReduction<EnforcementSums> reduce_outcome_;

  RowSystem system_;
  RowSumMemory sums_;
  // Foreign nodes: item k of the messages is foreign node foreign_order_[k] of the rows.
  ExchangePlan plan_;
  std::vector<int> foreign_order_, remote_nodes_;
  Rows3<double> foreign_values_ = Rows3<double>("contact::foreign_values", 0);
  std::vector<std::array<double, 3>> send_, receive_;
  bool was_pushed_ = false;               // impulses of the last step stand in motion.impulse
  const double* last_impulse_ = nullptr;  // where they were written
  double last_dt_ = 0;
  bool remembers_ = true;  // the history may hold something
};

}  // namespace percuss
