#pragma once
// From the constants that a deck gives to the materials of the kernels.

#include <algorithm>
#include <stdexcept>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/law_code.hpp"
#include "src/deck/user_code.hpp"

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

/// The name by which a LawDeck has curve k of a key, among its tables, and its rate, among its numbers.
inline std::string name_curve(const std::string& key, int k) { return key + "." + std::to_string(k); }

/// The curves of a key as kernels hold them.
inline RateCurves make_curves(const LawDeck& law, const std::string& key) {
  RateCurves made;
  for (int k = 0; law.tables.count(name_curve(key, k)) == 1; ++k) {
    const auto& rows = law.tables.at(name_curve(key, k));
    if (made.rates == RateCurves::most_rates || made.first[made.rates] + rows.size() > RateCurves::most_rows)
      throw std::logic_error("curves of a material are too long");
    made.add_curve(law.numbers.at(name_curve(key, k)), rows);
  }
  return made;
}

/// Numbers and a word as kernels hold them.
inline MaterialNumbers make_numbers(const std::vector<double>& values) {
  MaterialNumbers made;
  if (values.size() > MaterialNumbers::most) throw std::logic_error("a material has too many numbers");
  std::copy(values.begin(), values.end(), made.value);
  made.count = static_cast<int>(values.size());
  return made;
}
inline MaterialText make_word(const std::string& word) {
  MaterialText made;
  std::fill(std::begin(made.text), std::end(made.text), ' ');
  const std::size_t count = std::min(word.size(), std::size_t{MaterialText::most});
  std::transform(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(count), made.text,
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return made;
}

/// Whether the table of keys of M has one with this kind of member.
template <class M, class Member>
constexpr bool has_key(Member MaterialKey<typename M::Constants>::*member) {
  for (const auto& key : M::keys()) {
    if (key.*member != nullptr) return true;
  }
  return false;
}

/// The file of a material's compiled code; empty: it has none.
inline std::string find_code_file(const LawDeck& law) {
  for (const char* key : {"vumat", "law"})
    if (const auto file = law.texts.find(key); file != law.texts.end()) return file->second;
  return {};
}

/// A constant of a law with code of a user, if it is one of the kinds that only such laws have.
template <class C>
void set_user_constant(const LawDeck& law, const MaterialKey<C>& key, C& constants) {
  if (key.code != nullptr) {
    constants.*key.code = load_user_code(law.texts.at(key.name));
    (constants.*key.code).density = law.numbers.at("density");
  }
  if (key.list != nullptr && law.lists.count(key.name) == 1) constants.*key.list = make_numbers(law.lists.at(key.name));
  if (key.word != nullptr)
    constants.*key.word = make_word(law.texts.count(key.name) == 1 ? law.texts.at(key.name) : "");
  if (key.integer != nullptr && law.numbers.count(key.name) == 1)
    constants.*key.integer = static_cast<int>(law.numbers.at(key.name));
}

/// The constants of M.
template <class M>
typename M::Constants find_constants(const LawDeck& law) {
  using Key = MaterialKey<typename M::Constants>;
  typename M::Constants constants{};
  for (const Key& key : M::keys()) {
    if (key.number != nullptr && law.numbers.count(key.name) == 1) constants.*key.number = law.numbers.at(key.name);
    if constexpr (has_key<M>(&Key::table)) {
      if (law.tables.count(key.name) == 1) constants.*key.table = make_table(law.tables.at(key.name));
    }
    if constexpr (has_key<M>(&Key::curves)) {
      if (key.curves != nullptr) constants.*key.curves = make_curves(law, key.name);
    }
    if constexpr (has_key<M>(&Key::choice)) {
      if (key.choice != nullptr && law.numbers.count(key.name) == 1)
        constants.*key.choice = law.numbers.at(key.name) != 0;
    }
    if constexpr (has_key<M>(&Key::code)) set_user_constant(law, key, constants);
    if constexpr (has_key<M>(&Key::law)) {
      if (key.law != nullptr) constants.*key.law = make_law_of_library(law, law.texts.at(key.name));
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

/// How many state variables a law of a user keeps.
int count_state_variables(const MaterialDeck& material);

/// Elastic moduli at the start [stress].
LameConstants find_moduli(const MaterialDeck& material);

}  // namespace percuss
