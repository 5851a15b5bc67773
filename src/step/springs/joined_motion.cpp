#include "src/step/springs/joined_motion.hpp"

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

HistoryColumn equal_work_column() {
  return {"equal_work", dimensions::energy,
          "work of constraints on their nodes, also of embedded ones, taken from the viscous energy"};
}

void book_joined_work(const GatheredRows<NodeRow>& rows, const std::vector<JoinedMotion>& outcomes, State& state) {
  double work = 0, of_contact = 0;
  for (std::size_t n = 0; 3 * n < outcomes.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const JoinedMotion& now = outcomes[3 * n + k];
      work += 0.5 * now.impulse * (rows.value(n, NodeRow::velocity_before, k) + now.velocity);
      of_contact += 0.5 * rows.value(n, NodeRow::contact, k) * (now.velocity - rows.value(n, NodeRow::velocity, k));
    }
  }
  state.books.equal_work += work;
  state.books.contact_work += of_contact;
}

void give_joined_motion(const ConnectedNodes& connected, const std::vector<JoinedMotion>& outcomes,
                        const State& state) {
  const std::size_t count = connected.local_node.extent(0);
  Kokkos::View<double**, Kokkos::LayoutRight, MemSpace> rows("percuss::joined_velocities", count, 6);
  const auto host = Kokkos::create_mirror_view(rows);
  const auto places = to_host(connected.local_place);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const JoinedMotion& of_node = outcomes[3 * at(places(i)) + k];
      host(i, k) = of_node.velocity;
      host(i, 3 + k) = of_node.impulse;
    }
  }
  copy_values(rows, host);
  const auto v = state.v, impulse = state.weld_impulse;
  const auto nodes = connected.local_node;
  parallel_for(
      "percuss::set_joined_nodes", RangeOf(ExecSpace(), 0, static_cast<int>(count)), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) {
          v(nodes(i), k) = rows(i, k);
          impulse(nodes(i), k) = rows(i, 3 + k);
        }
      });
}

}  // namespace percuss
