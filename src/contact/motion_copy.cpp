#include "src/contact/motion_copy.hpp"

#include "kernels/contact/small_space.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/number_map.hpp"

namespace percuss {
namespace {

/// Place and velocity of a node.
struct MotionItem {
  double x[3], v[3];
};

}  // namespace

void MotionCopy::ask(const ContactRanks& ranks, UnstructuredExchange& exchange, DataExchange& data,
                     const std::vector<std::int64_t>& numbers) {
  std::vector<int> owners;
  owners.reserve(numbers.size());
  for (const std::int64_t number : numbers) owners.push_back(ranks.numbering.find_node_owner(number));
  nodes_ = subscribe(exchange, data, owners, numbers,
                     [&](std::int64_t number) { return find_number(ranks.mesh.node_numbers, number); });
  order_ = to_view("contact::motion_order", nodes_.order);
  published_ = to_view("contact::published_nodes", nodes_.published);
  reserve(x_, static_cast<int>(numbers.size()));
  reserve(v_, static_cast<int>(numbers.size()));
}

SurfaceMotion MotionCopy::receive(DataExchange& data, const SurfaceMotion& motion) {
  const Array<const int> published = published_, order = order_;
  const auto sent = published.extent(0), received = order.extent(0);
  const Array<MotionItem> send(Kokkos::view_alloc("contact::sent_motion", Kokkos::WithoutInitializing), sent);
  const Array<MotionItem> receive(Kokkos::view_alloc("contact::received_motion", Kokkos::WithoutInitializing),
                                  received);
  const SurfaceMotion m = motion;
  Kokkos::parallel_for(
      "contact::pack_motion", Range(ExecSpace(), 0, static_cast<int>(sent)), KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < 3; ++k) {
          send(i).x[k] = m.x(published(i), k);
          send(i).v[k] = m.v(published(i), k);
        }
      });
  ExecSpace().fence();
  const auto send_buffer = to_host(send);
  const auto receive_buffer = Kokkos::create_mirror_view(receive);
  data.begin<MotionItem>(reverse(nodes_.request), {send_buffer.data(), sent}, {receive_buffer.data(), received});
  data.end();
  Kokkos::deep_copy(receive, receive_buffer);
  const Rows3<double> x = x_, v = v_;
  Kokkos::parallel_for(
      "contact::unpack_motion", Range(ExecSpace(), 0, static_cast<int>(received)), KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < 3; ++k) {
          x(order(i), k) = receive(i).x[k];
          v(order(i), k) = receive(i).v[k];
        }
      });
  ExecSpace().fence();
  return {x_, v_, motion.dt};
}

}  // namespace percuss
