#include "comm/halo/node_copies.hpp"

#include <cstddef>

#include "comm/exchange/exchange_buffers.hpp"

namespace percuss {

CopyPlan plan_copies(const SharedNodes& shared, int rank) {
  CopyPlan plan;
  for (std::size_t r = 0; r < shared.ranks.size(); ++r) {
    const int neighbour = shared.ranks[r];
    const std::size_t sent = plan.send_nodes.size(), received = plan.receive_nodes.size();
    for (int i = shared.first[r]; i < shared.first[r + 1]; ++i) {
      const int node = shared.nodes[static_cast<std::size_t>(i)];
      const int owner = shared.owners[static_cast<std::size_t>(node)];
      if (owner == rank) plan.send_nodes.push_back(node);
      if (owner == neighbour) plan.receive_nodes.push_back(node);
    }
    const auto add_run = [&](std::vector<PeerRun>& runs, std::size_t first, std::size_t end) {
      if (end > first) {
        runs.push_back({neighbour, static_cast<std::int64_t>(first), static_cast<std::int64_t>(end - first)});
      }
    };
    add_run(plan.exchange.to, sent, plan.send_nodes.size());
    add_run(plan.exchange.from, received, plan.receive_nodes.size());
  }
  return plan;
}

NodeCopies::NodeCopies(const Communicator& ranks, const SharedNodes& shared) : data_(ranks) {
  const CopyPlan plan = plan_copies(shared, ranks.rank());
  exchange_ = plan.exchange;
  send_nodes_ = copy_to_view("percuss::copy_send_nodes", plan.send_nodes);
  receive_nodes_ = copy_to_view("percuss::copy_receive_nodes", plan.receive_nodes);
  send_values_ = make_rows("percuss::copy_send", plan.send_nodes.size());
  receive_values_ = make_rows("percuss::copy_receive", plan.receive_nodes.size());
  send_buffer_ = Kokkos::create_mirror_view(send_values_);
  receive_buffer_ = Kokkos::create_mirror_view(receive_values_);
}

void NodeCopies::begin(const ExecSpace& space, const Rows3<const double>& values) {
  pack_rows(space, send_nodes_, values, send_values_);
  Kokkos::deep_copy(send_buffer_, send_values_);
  data_.begin<RowItem>(exchange_, as_items(send_buffer_), as_items(receive_buffer_));
}

void NodeCopies::end(const ExecSpace& space, const Rows3<double>& values) {
  data_.end();
  Kokkos::deep_copy(receive_values_, receive_buffer_);
  const auto nodes = receive_nodes_;
  const auto received = receive_values_;
  Kokkos::parallel_for(
      "percuss::unpack_copies", Range(space, 0, static_cast<int>(nodes.extent(0))), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) values(nodes(i), k) = received(i, k);
      });
}

}  // namespace percuss
