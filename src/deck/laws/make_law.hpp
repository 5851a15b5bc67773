#pragma once
// A law, or an equation of state, with the constants that a deck gives.

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "kernels/material/material_key.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/laws/law_code.hpp"
#include "src/deck/laws/material_properties.hpp"
#include "src/deck/laws/user_code.hpp"

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

/// The curves of a key as kernels hold them.
inline RateCurves make_curves(const LawDeck& law, const std::string& key) {
  RateCurves made;
  for (int k = 0; law.tables.count(name_curve(key, k)) == 1; ++k) {
    const auto& rows = law.tables.at(name_curve(key, k));
    if (made.rates == RateCurves::most_rates ||
        static_cast<std::size_t>(made.first[made.rates]) + rows.size() > RateCurves::most_rows)
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

/// A constant of a law with code of a user, if it is one of the kinds that only such laws have.
template <class C>
void set_user_constant(const LawDeck& law, const MaterialKey<C>& key, C& constants) {
  if (key.code != nullptr) {
    constants.*key.code = load_user_code(law.texts.at(key.name), key.name);
    (constants.*key.code).density = law.numbers.at("density");
    if (law.lists.count("step_starts") == 1) set_step_starts(law.lists.at("step_starts"), constants.*key.code);
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

}  // namespace percuss
