#pragma once
// Rows of numbers by node, each known to one rank, made known to all.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// own: [rows of this rank][count]; places: [rows of this rank] where they belong in `rows`, [all rows][count]. The
/// other ranks give zeros, and bits are added up, so that the numbers stay as they are. Collective.
template <class Rows, class Places>
void gather_rows(const Communicator& ranks, const Rows& own, const Places& places, std::size_t count,
                 std::vector<double>& rows) {
  const auto host = to_host(own);
  const auto where = to_host(places);
  std::vector<std::uint64_t> bits(rows.size(), 0);
  for (std::size_t i = 0; i < where.extent(0); ++i)
    for (std::size_t k = 0; k < count; ++k) bits[at(where(i)) * count + k] = std::bit_cast<std::uint64_t>(host(i, k));
  all_reduce(ranks, Reduce::sum, bits);
  for (std::size_t i = 0; i < bits.size(); ++i) rows[i] = std::bit_cast<double>(bits[i]);
}

/// What the owner of a node tells of it where nodes are joined; the place of each in a row of `count` numbers.
struct NodeRow {
  enum : std::size_t {
    place,
    velocity = place + 3,
    velocity_before = velocity + 3,
    contact = velocity_before + 3,
    inverse_mass = contact + 3,
    spin = inverse_mass + 3,
    spin_before = spin + 3,
    inverse_inertia = spin_before + 3,
    inertia = inverse_inertia + 3,
    mass,
    count
  };
};
using OwnRows = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

/// Which nodes are joined: those that this rank owns, as mesh nodes, and their places among those of all ranks.
struct JoinedNodes {
  Array<const int> owned_node, owned_place;
};

/// What the owner of a node tells where forces act on it; the place of each in a row of `count` numbers.
template <bool with_velocity, bool with_spin = false>
struct ForcedRow {
  enum : std::size_t {
    place,
    velocity = place + 3,
    spin = with_velocity ? velocity + 3 : velocity,
    mobility = with_spin ? spin + 3 : spin,
    turning,  // the largest inverse rotary inertia
    count = with_spin ? turning + 1 : turning
  };
  static constexpr double gone = -1;  // mobility of a node that has vanished
};

/// The rows of all nodes with forces, on every rank; with the largest inverse mass in a direction as mobility. own:
/// scratch, [owned nodes][count]; rows: out, [all nodes][count]. Collective.
template <bool with_velocity, bool with_spin = false>
void gather_forced_nodes(const Model& model, const State& state, const JoinedNodes& nodes, const OwnRows& own,
                         std::vector<double>& rows) {
  using Row = ForcedRow<with_velocity, with_spin>;
  const auto x = state.x, v = state.v, inverse_mass = state.inverse_mass;
  const auto w = state.w, inverse_inertia = state.inverse_inertia;
  const auto mass = state.mass, inertia = state.inertia;
  const auto node = nodes.owned_node;
  const OwnRows out = own;
  const bool turns = model.has_rotations;
  const bool may_free = model.switches.switches_conditions;  // what is held now may move in the next step
  const Array<const int> body_of_node = model.rigid.body_of_node;
  Kokkos::parallel_for(
      "percuss::gather_forced_nodes", Range(ExecSpace(), 0, static_cast<int>(node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = node(i);
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
  gather_rows(model.ranks, own, nodes.owned_place, Row::count, rows);
}

/// The rows of all joined nodes, on every rank. own: scratch, [owned nodes][NodeRow::count]; rows: out, [all
/// nodes][NodeRow::count]. Collective.
inline void gather_nodes(const Model& model, const State& state, const JoinedNodes& nodes, const OwnRows& own,
                         std::vector<double>& rows) {
  const auto x = state.x, v = state.v, v_before = state.v_before, contact = state.impulse;
  const auto inverse_mass = state.inverse_mass, w = state.w, w_before = state.w_before,
             inverse_inertia = state.inverse_inertia;
  const auto mass = state.mass, inertia = state.inertia;
  const auto node = nodes.owned_node;
  const OwnRows out = own;
  const bool turns = model.has_rotations;
  Kokkos::parallel_for(
      "percuss::gather_joined_nodes", Range(ExecSpace(), 0, static_cast<int>(node.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const int n = node(i);
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
      });
  gather_rows(model.ranks, own, nodes.owned_place, NodeRow::count, rows);
}

}  // namespace percuss
