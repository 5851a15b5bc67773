#pragma once
// From the constants that a deck gives to the materials of the kernels.

#include <stdexcept>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// A table as kernels hold it.
inline MaterialTable make_table(const std::vector<std::array<double, 2>>& rows) {
  MaterialTable table;
  for (const auto& row : rows) {
    if (table.rows == MaterialTable::most_rows) throw std::logic_error("a table of a material is too long");
    table.x[table.rows] = row[0];
    table.y[table.rows] = row[1];
    ++table.rows;
  }
  return table;
}

/// Whether the table of keys of M has one with this kind of member.
template <class M, class Member>
constexpr bool has_key(Member MaterialKey<typename M::Constants>::*member) {
  for (const auto& key : M::keys()) {
    if (key.*member != nullptr) return true;
  }
  return false;
}

/// The constants of M.
template <class M>
typename M::Constants find_constants(const LawDeck& law) {
  using Key = MaterialKey<typename M::Constants>;
  typename M::Constants constants{};
  for (const Key& key : M::keys()) {
    if (law.numbers.count(key.name) == 1) constants.*key.number = law.numbers.at(key.name);
    if constexpr (has_key<M>(&Key::table)) {
      if (law.tables.count(key.name) == 1) constants.*key.table = make_table(law.tables.at(key.name));
    }
    if constexpr (has_key<M>(&Key::vector)) {
      if (law.vectors.count(key.name) == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) (constants.*key.vector)[k] = law.vectors.at(key.name)[k];
    }
  }
  return constants;
}

template <class M>
M make_law(const LawDeck& law) {
  const typename M::Constants constants = find_constants<M>(law);
  if constexpr (std::is_same_v<M, typename M::Constants>) {
    return constants;
  } else {
    return M::make(constants);
  }
}

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

/// Calls f with the law of a material, one of Materials.
template <class F>
void visit_law(const MaterialDeck& material, const F& f) {
  visit_law_of(Materials(), material.law, f);
}

/// Whether the history of a material has a scalar of this name.
bool has_scalar(const MaterialDeck& material, HistoryScalar name);

/// Whether the stress at the end of a step is that at its beginning and an increment: it may begin with any.
bool grows_in_increments(const MaterialDeck& material);

/// Elastic moduli at the start [stress].
LameConstants find_moduli(const MaterialDeck& material);

}  // namespace percuss
