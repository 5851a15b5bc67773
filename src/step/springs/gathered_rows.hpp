#pragma once
// Rows of numbers by node, each known to one rank, made known to all.

#include <cstddef>
#include <vector>

#include "src/index.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

using OwnRows = Kokkos::View<double**, Kokkos::LayoutRight, MemSpace>;

/// Data of a node from its owner, where nodes are joined; the place of each in a row of `count` numbers. Inverse masses
/// and inertias are those by which it answers impulses (State::answering_inverse_mass).
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
    growth,  // DampedMasses::growth
    count
  };

  /// node: of this rank; own: out, a row each.
  static void fill(const Model& model, const State& state, const Array<const int>& node, const OwnRows& own);
};

/// Data of a node from its owner, where forces act on it; the place of each in a row of `count` numbers.
template <bool with_velocity, bool with_spin = false>
struct ForcedRow {
  enum : std::size_t {
    place,
    velocity = place + 3,
    spin = with_velocity ? velocity + 3 : velocity,
    mobility = with_spin ? spin + 3 : spin,  // the largest inverse mass in a direction
    turning,                                 // the largest inverse rotary inertia
    count = with_spin ? turning + 1 : turning
  };
  static constexpr double gone = -1;  // mobility of a node that has vanished

  /// As that of NodeRow.
  static void fill(const Model& model, const State& state, const Array<const int>& node, const OwnRows& own);
};

/// own: [rows of this rank][count]; places: [rows of this rank] where they belong in `rows`, [all rows][count]. The
/// other ranks give zeros, and bits are added up, so that the numbers stay as they are. Collective.
void share_rows(const Communicator& ranks, const OwnRows& own, const Array<const int>& places,
                std::vector<double>& rows);

/// The rows of the nodes that connections name, on every rank.
template <class Row>
class GatheredRows {
 public:
  /// Both outlive this.
  GatheredRows(const Model& model, const ConnectedNodes& nodes)
      : model_(model),
        nodes_(nodes),
        rows_(nodes.nodes.size() * Row::count),
        own_("percuss::connected_rows", nodes.owned_node.extent(0), Row::count) {}

  /// Collective.
  void gather(const State& state) {
    Row::fill(model_, state, nodes_.owned_node, own_);
    share_rows(model_.ranks, own_, nodes_.owned_place, rows_);
  }

  std::size_t count() const { return nodes_.nodes.size(); }
  /// [nodes][Row::count] of the last gather().
  const std::vector<double>& rows() const { return rows_; }
  template <class Index>
  double value(Index node, std::size_t what, std::size_t k = 0) const {
    return rows_[static_cast<std::size_t>(node) * Row::count + what + k];
  }
  /// Three numbers of the row of a node.
  template <class Index>
  Vector3<double> vector(Index node, std::size_t what) const {
    return {value(node, what), value(node, what, 1), value(node, what, 2)};
  }

 private:
  const Model& model_;
  const ConnectedNodes& nodes_;
  std::vector<double> rows_;
  OwnRows own_;
};

}  // namespace percuss
