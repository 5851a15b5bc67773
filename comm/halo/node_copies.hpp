#pragma once
// Carbon copies from their owner: a value that one rank alone computed for a shared node, given to all who hold it.
//
// Sums of slots need no such thing, every copy computes them itself (comm/halo/halo_swap.hpp). It is for what only the
// owner of a node knows, such as the force of a contact that was found for it once.

#include <functional>
#include <vector>

#include "comm/exchange/data_exchange.hpp"
#include "comm/halo/shared_nodes.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// Shared nodes that are sent and received: an owner sends to every copy. Const after set-up.
struct CopyPlan {
  ExchangePlan exchange;           // items are nodes
  std::vector<int> send_nodes;     // [sent] local node of each item
  std::vector<int> receive_nodes;  // [received]
};

/// Follows from the shared nodes, without messages. rank: this one.
CopyPlan plan_copies(const SharedNodes& shared, int rank);

class NodeCopies {
 public:
  /// fields: values of a node that go in one message. Collective over `ranks`, whose shared nodes these are. Throws
  /// MpiError.
  NodeCopies(const Communicator& ranks, const SharedNodes& shared, int fields = 1);

  /// Leaves the copies of other owners' nodes unchanged from now on. is_source(rank): the same on all ranks. Not
  /// collective.
  void choose_sources(const std::function<bool(int rank)>& is_source);

  /// Packs the values of owned shared nodes and starts the messages. values: [fields] of [local nodes][3]. Throws
  /// MpiError.
  void begin(const ExecSpace& space, const std::vector<Rows3<const double>>& values);
  void begin(const ExecSpace& space, const Rows3<const double>& values) { begin(space, std::vector{values}); }

  /// The nodes of this rank that others own.
  const Array<int>& copies() const { return receive_nodes_; }

  /// Returns when every copy of a node has its owner's values. values: [fields] of [local nodes][3]. Throws MpiError.
  void end(const ExecSpace& space, const std::vector<Rows3<double>>& values);
  void end(const ExecSpace& space, const Rows3<double>& values) { end(space, std::vector{values}); }

  const Traffic& traffic() const { return data_.traffic(); }

 private:
  int rank_, fields_;
  ExchangePlan all_, exchange_;  // items are fields of nodes, those of a node one after the other; those of the sources
  Array<int> send_nodes_, receive_nodes_;
  Rows3<double> send_values_, receive_values_;
  HostMirror<Rows3<double>> send_buffer_, receive_buffer_;
  DataExchange data_;
};

}  // namespace percuss
