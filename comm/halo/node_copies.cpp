#include "comm/halo/node_copies.hpp"

#include <cstddef>

#include "comm/exchange/exchange_buffers.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

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

namespace {

std::vector<PeerRun> repeat_items(std::vector<PeerRun> runs, int times) {
  for (PeerRun& run : runs) {
    run.first *= times;
    run.count *= times;
  }
  return runs;
}

}  // namespace

NodeCopies::NodeCopies(const Communicator& ranks, const SharedNodes& shared, int fields)
    : rank_(ranks.rank()), fields_(fields), data_(ranks) {
  const CopyPlan plan = plan_copies(shared, rank_);
  all_ = {repeat_items(plan.exchange.to, fields), repeat_items(plan.exchange.from, fields)};
  exchange_ = all_;
  const auto values = static_cast<std::size_t>(fields);
  send_nodes_ = copy_to_view("percuss::copy_send_nodes", plan.send_nodes);
  receive_nodes_ = copy_to_view("percuss::copy_receive_nodes", plan.receive_nodes);
  send_values_ = make_rows("percuss::copy_send", values * plan.send_nodes.size());
  receive_values_ = make_rows("percuss::copy_receive", values * plan.receive_nodes.size());
  send_buffer_ = Kokkos::create_mirror_view(send_values_);
  receive_buffer_ = Kokkos::create_mirror_view(receive_values_);
}

void NodeCopies::choose_sources(const std::function<bool(int)>& is_source) {
  exchange_ = {};
  if (is_source(rank_)) exchange_.to = all_.to;
  for (const PeerRun& run : all_.from)
    if (is_source(run.rank)) exchange_.from.push_back(run);
}

void NodeCopies::begin(const ExecSpace& space, const std::vector<Rows3<const double>>& values) {
  const Array<const int> nodes = send_nodes_;
  const Rows3<double> packed = send_values_;
  const int fields = fields_, count = exchange_.to.empty() ? 0 : static_cast<int>(nodes.extent(0));
  for (int f = 0; f < fields; ++f) {
    const Rows3<const double> from = values[static_cast<std::size_t>(f)];
    parallel_for(
        "percuss::pack_copies", RangeOf(space, 0, count), KOKKOS_LAMBDA(const int i) {
          for (int k = 0; k < 3; ++k) packed(fields * i + f, k) = from(nodes(i), k);
        });
  }
  space.fence();
  copy_values(send_buffer_, send_values_);
  data_.begin<RowItem>(exchange_, as_items(send_buffer_), as_items(receive_buffer_));
}

void NodeCopies::end(const ExecSpace& space, const std::vector<Rows3<double>>& values) {
  data_.end();
  copy_values(receive_values_, receive_buffer_);
  const Array<const int> nodes = receive_nodes_;
  const Rows3<const double> received = receive_values_;
  const int fields = fields_;
  for (const PeerRun& run : exchange_.from) {
    const int first = static_cast<int>(run.first) / fields, end = first + static_cast<int>(run.count) / fields;
    for (int f = 0; f < fields; ++f) {
      const Rows3<double> to = values[static_cast<std::size_t>(f)];
      parallel_for(
          "percuss::unpack_copies", RangeOf(space, first, end), KOKKOS_LAMBDA(const int i) {
            for (int k = 0; k < 3; ++k) to(nodes(i), k) = received(fields * i + f, k);
          });
    }
  }
}

}  // namespace percuss
