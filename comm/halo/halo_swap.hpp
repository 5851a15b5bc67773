#pragma once
// The swap of swap-and-add (section 3 of the paper): slots of shared nodes to all who hold a copy.
//
// begin() once the chunks that send are computed, end() before nodes are summed; the other chunks go between. The add
// is the ordinary assembly of nodes over their slot lists (kernels/node/motion.hpp).

#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/halo/halo_plan.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

class HaloSwap {
 public:
  /// Collective over `ranks`, which are those of the plan. Throws MpiError.
  HaloSwap(const Communicator& ranks, const HaloPlan& plan);

  /// Packs the slots that others need and starts the messages. slot_values: [plan.slot_count()][3], the local part
  /// filled; its remote part must be left alone until end(). Throws MpiError.
  void begin(const ExecSpace& space, const Rows3<double>& slot_values);

  /// Returns when the remote part of slot_values is filled. Throws MpiError.
  void end();

  const Traffic& traffic() const { return data_.traffic(); }

 private:
  ExchangePlan exchange_;
  int first_remote_slot_;
  Array<int> send_slots_;
  Rows3<double> send_values_, remote_values_;               // remote_values_: the remote part of slot_values
  HostMirror<Rows3<double>> send_buffer_, receive_buffer_;  // copies of both on the host
  DataExchange data_;
};

}  // namespace percuss
