#include "src/step/springs/gathered_rows.hpp"

#include <bit>
#include <cstdint>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

void share_rows(const Communicator& ranks, const OwnRows& own, const Array<const int>& places,
                std::vector<double>& rows) {
  const auto host = to_host(own);
  const auto where = to_host(places);
  const std::size_t count = own.extent(1);
  std::vector<std::uint64_t> bits(rows.size(), 0);
  for (std::size_t i = 0; i < where.extent(0); ++i)
    for (std::size_t k = 0; k < count; ++k) bits[at(where(i)) * count + k] = std::bit_cast<std::uint64_t>(host(i, k));
  all_reduce(ranks, Reduce::sum, bits);
  for (std::size_t i = 0; i < bits.size(); ++i) rows[i] = std::bit_cast<double>(bits[i]);
}

void NodeRow::fill(const Model& model, const State& state, const Array<const int>& node, const OwnRows& own) {
  const auto x = state.x, v = state.v, v_before = state.v_before, contact = state.impulse;
  const auto inverse_mass = state.answering_inverse_mass(), w = state.w, w_before = state.w_before,
             inverse_inertia = state.answering_inverse_inertia();
  const auto mass = state.mass, inertia = state.inertia;
  const DampedMasses damped = state.damped;
  const OwnRows out = own;
  const Array<const int> nodes = node;
  const bool turns = model.has_rotations;
  parallel_for(
      "percuss::gather_joined_nodes", RangeOf(ExecSpace(), 0, static_cast<int>(node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes(i);
        for (std::size_t k = 0; k < 3; ++k) {
          out(i, NodeRow::place + k) = x(n, k);
          out(i, NodeRow::velocity + k) = v(n, k);
          out(i, NodeRow::velocity_before + k) = v_before(n, k);
          out(i, NodeRow::contact + k) = contact(n, k);
          out(i, NodeRow::inverse_mass + k) = inverse_mass(n, k);
          out(i, NodeRow::spin + k) = turns ? w(n, k) : 0;
          out(i, NodeRow::spin_before + k) = turns ? w_before(n, k) : 0;
          out(i, NodeRow::inverse_inertia + k) = turns ? inverse_inertia(n, k) : 0;
        }
        out(i, NodeRow::inertia) = turns ? inertia(n) : 0;
        out(i, NodeRow::mass) = mass(n);
        out(i, NodeRow::growth) = damped.find_growth(n);
      });
}

template <bool with_velocity, bool with_spin>
void ForcedRow<with_velocity, with_spin>::fill(const Model& model, const State& state, const Array<const int>& node,
                                               const OwnRows& own) {
  using Row = ForcedRow<with_velocity, with_spin>;
  const auto x = state.x, v = state.v, inverse_mass = state.inverse_mass;
  const auto w = state.w, inverse_inertia = state.inverse_inertia;
  const auto mass = state.mass, inertia = state.inertia;
  const OwnRows out = own;
  const Array<const int> nodes = node;
  const bool turns = model.has_rotations;
  const bool may_free = model.switches.switches_conditions;  // what is held now may move in the next step
  const Array<const int> body_of_node = model.rigid.body_of_node;
  parallel_for(
      "percuss::gather_forced_nodes", RangeOf(ExecSpace(), 0, static_cast<int>(node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes(i);
        double mobility = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          out(i, Row::place + k) = x(n, k);
          if (with_velocity) out(i, Row::velocity + k) = v(n, k);
          mobility = inverse_mass(n, k) > mobility ? inverse_mass(n, k) : mobility;
        }
        if (may_free && mass(n) > 0 && !RigidModel::holds(body_of_node, n)) mobility = 1 / mass(n);
        out(i, Row::mobility) = mass(n) > 0 ? mobility : Row::gone;
        if (!with_spin) return;
        double turning = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          out(i, Row::spin + k) = turns ? w(n, k) : 0;
          if (turns && inverse_inertia(n, k) > turning) turning = inverse_inertia(n, k);
        }
        if (turns && may_free && inertia(n) > 0) turning = 1 / inertia(n);
        out(i, Row::turning) = turning;
      });
}

template struct ForcedRow<true, false>;
template struct ForcedRow<false, true>;

}  // namespace percuss
