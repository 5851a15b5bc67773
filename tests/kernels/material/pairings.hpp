#pragma once
// Every law with the equations of state that it may have, for tests that go through all of them.

#include <type_traits>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test {

template <class Law>
Law make_sample_law() {
  if constexpr (std::is_same_v<Law, typename Law::Constants>) {
    return sample<Law>();
  } else {
    return Law::make(sample<Law>());
  }
}

template <class Law>
inline constexpr bool needs_state = requires {
  requires Law::needs_equation_of_state;
};

/// A law with an equation of state, or none: void.
template <class L, class S>
struct Pairing {
  using Law = L;
  using State = S;
};

/// Every law by itself, or with a gas if it must have an equation of state.
template <class Law>
using OwnPairing = Pairing<Law, std::conditional_t<needs_state<Law>, IdealGasState, void>>;

template <class... Law, class... State>
TypeList<OwnPairing<Law>..., Pairing<Fluid, State>..., Pairing<JohnsonCook, State>...> list_pairings(
    TypeList<Law...>, TypeList<State...>);

/// Every law, and every equation of state without strength and with that of a material that it heats.
using Pairings = decltype(list_pairings(Materials(), EquationsOfState()));

}  // namespace percuss::test
