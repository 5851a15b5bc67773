#pragma once
// Where forces of the history come from, besides contact: conditions that hold nodes, and elements cut by a plane.

#include <array>

#include "src/mesh/ordering.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Six exact sums: an impulse and its moment [force x time, force x length x time].
using ImpulseSums = std::array<ExactSum, 6>;

/// Force of the conditions on the nodes of a selector, and to the rigid bodies of which it has all nodes.
class SupportForce {
 public:
  /// Collective. Throws InputError, on all ranks, if no condition holds one of these nodes or bodies.
  SupportForce(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model);

  /// Renews the sources after sensors have switched conditions.
  void renew(const State& state);

  /// Impulse on this rank's nodes in a step. Call with v at n+1/2, x and forces at n. reactions: of rigid bodies, empty
  /// without.
  ImpulseSums find_impulse(const State& state, double dt_mean, const std::vector<Wrench>& reactions);

 private:
  struct Held {
    HeldDirections moves, spins;
    Array<int> owned, owned_spins;
  };
  void list(const Held& held);
  void add_bodies(const State& state, const std::vector<Wrench>& reactions, ImpulseSums& sums) const;

  std::vector<char> marked_;            // [nodes] whether it is of the support
  Array<const int> held_, held_spins_;  // entries of State::held and held_spins
  std::vector<std::size_t> bodies_;     // rigid ones, on the first rank alone; none of those that are always free
  Vec3 about_;
  ExactSums<6> sums_{"percuss::support_sums"}, spin_sums_{"percuss::support_spin_sums"};
};

/// Force of the elements that a plane cuts at time 0 on their nodes behind it: the force that the material ahead of the
/// plane, where its normal points, exerts on that behind. Tension is positive along the normal.
///
/// Forces of an element on its nodes sum to zero, so those of all elements of a chunk on its nodes behind the plane are
/// those of the cut ones.
///
/// Or what some elements give to some nodes. They are whole parts, or sets whose elements share no chunk with others
/// (src/mesh/parts).
class SectionForce {
 public:
  /// Collective. Throws InputError, on all ranks, if the plane cuts no element, or the elements have none of the nodes.
  SectionForce(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model);

  /// Impulse of this rank's elements in a step. Call with x and forces at n.
  ImpulseSums find_impulse(const State& state, double dt_mean);

 private:
  struct Slots {
    std::vector<int> slots, nodes;
  };
  static Slots list_cut(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model);
  static Slots list_of_sets(const Deck& deck, const ForceDeck& force, const ChunkedMesh& chunked, const Model& model);

  Array<const int> slots_, nodes_;  // of cut chunks, behind the plane; of chunks of the elements, of the nodes
  Vec3 about_;
  ExactSums<6> sums_{"percuss::section_sums"};
};

}  // namespace percuss
