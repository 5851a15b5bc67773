#pragma once
// Any material of the list, called through its number: one compiled element serves them all.
//
// The element's body is long, and each material that is compiled into it needs its own copy, which saves some
// nanoseconds an element. The work of a called material (powers, logarithms, tables) takes longer than the call. Only
// call_material.hpp and the code that makes a material include the lists.

#include "kernels/material/elastic.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/point_step.hpp"
#include "kernels/material/type_list.hpp"

namespace percuss {

/// A material that is called, with or without an equation of state. Its history: lambda + 2 mu, which bulk viscosity
/// takes in the next step, then that of the law, then that of the equation of state, then the element's own mass where
/// its mass is scaled.
struct CalledMaterial {
  static constexpr int history_count = most_law_history + 8;  // room for the longest; a record has count_history()
  static constexpr bool can_yield = true;
  static constexpr int law_place = 1;

  AnyOf<6144> law;          // one of Materials
  AnyOf<1088> state;        // one of EquationsOfState, or none
  LameConstants reference;  // moduli at the start, for hourglass control
  double density = 0;       // at the start
  int law_history = 0;      // scalars
  int state_history = 0;
  bool changes_at_rest = false;  // whether the state changes with time alone
  bool stores_energy = false;    // whether the stress follows from an energy of the strain
  bool is_scaled = false;        // whether mass is added to elements: then volumes follow from their own mass
  int place = -1;                // in the history: of the point in space, which its element sets; -1: not needed

  PERCUSS_FORCE_INLINE LameConstants moduli() const { return reference; }
  KOKKOS_INLINE_FUNCTION int count_history() const {
    return law_place + law_history + state_history + (is_scaled ? 1 : 0);
  }
  /// Where the history of the equation of state begins; -1: there is none.
  int find_state_place() const { return state_history > 0 ? law_place + law_history : -1; }
  /// Place of the element's own mass, if it is_scaled.
  KOKKOS_INLINE_FUNCTION int find_mass_place() const { return law_place + law_history + state_history; }

  /// Advances a point from n to n+1. step.history: [count_history()].
  template <class T>
  void update(PointStep<T>& step) const;
};

}  // namespace percuss
