#pragma once
// The law of a material as the kernels have it: whoever includes this compiles all laws.
//
// make_law.hpp makes one law that is known; material_properties.hpp tells what any has without its type.

#include <stdexcept>
#include <string>
#include <type_traits>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "kernels/shell/fabric.hpp"
#include "kernels/shell/skin.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/laws/make_law.hpp"

namespace percuss {

/// Laws of solids, some of which shells have too, and laws that only membranes or shells have.
using AllLaws = JoinLists<Materials, TypeList<Fabric, Skin>>::type;

/// Whether solids have the law.
template <class Law>
inline constexpr bool is_of_solids = !std::is_same_v<Law, Fabric> && !std::is_same_v<Law, Skin>;

template <class... M, class F>
void visit_law_of(TypeList<M...>, const LawDeck& law, const F& f) {
  const bool found = ((law.model == M::name ? (f(make_law<M>(law)), true) : false) || ...);
  if (!found) throw std::logic_error("no law is called '" + law.model + "' (the deck reader lets it through)");
}

/// Whether an equation of state may take the place of a law's own pressure, and whether one must.
template <class Law>
inline constexpr bool takes_equation_of_state = requires {
  requires Law::takes_equation_of_state;
};
template <class Law>
inline constexpr bool needs_equation_of_state = requires {
  requires Law::needs_equation_of_state;
};

/// Calls f with the equation of state, one of EquationsOfState.
template <class F>
void visit_state(const LawDeck& state, const F& f) {
  visit_law_of(EquationsOfState(), state, f);
}

/// Calls f with the law of a material, one of AllLaws.
template <class F>
void visit_law(const MaterialDeck& material, const F& f) {
  visit_law_of(AllLaws(), material.law, f);
}

}  // namespace percuss
