#pragma once
// Makes a LawLibrary of a law that is written as those of kernels/material/laws; for libraries that `percuss
// build-law` compiles.

#include <array>
#include <iterator>
#include <new>
#include <type_traits>

#include "kernels/material/advance_point.hpp"
#include "kernels/material/user/law_library.hpp"
#include "kernels/material/user/library_law.hpp"

namespace percuss {

template <class Law>
struct ExportedLaw {
  using Constants = typename Law::Constants;
  using Key = MaterialKey<Constants>;
  static constexpr auto keys = Law::keys();
  static_assert(std::is_trivially_copyable_v<Law>, "a law is copied byte by byte: arrays, no std::vector");
  static constexpr int most = 1024;
  static_assert(most <= LibraryLaw::history_count);
  static_assert(Law::history_count <= most, "a law keeps at most 1024 numbers a point");

  static constexpr LawKey describe(const Key& key) {
    LawKey row{key.name, LawKeyKind::number, key.range, key.required, key.most, {key.words[0], key.words[1]}};
    if (key.integer != nullptr) row.kind = LawKeyKind::integer;
    if (key.choice != nullptr) row.kind = LawKeyKind::word;
    if (key.vector != nullptr) row.kind = LawKeyKind::vector;
    if (key.table != nullptr) row.kind = LawKeyKind::table;
    return row;
  }
  static constexpr auto describe_keys() {
    std::array<LawKey, keys.size()> rows{};
    for (std::size_t i = 0; i < keys.size(); ++i) rows[i] = describe(keys[i]);
    return rows;
  }
  static constexpr bool has_only_plain_keys() {
    for (const Key& key : keys)
      if (key.curves != nullptr || key.list != nullptr || key.word != nullptr || key.code != nullptr) return false;
    return true;
  }
  static_assert(has_only_plain_keys(), "constants of a library are numbers, integers, choices, vectors and tables");
  static constexpr auto rows = describe_keys();

  /// Whether a row has this kind of member.
  template <class Member>
  static constexpr bool has(Member Key::*member) {
    for (const Key& key : keys)
      if (key.*member != nullptr) return true;
    return false;
  }
  static void set(const Key& key, const LawValue& value, Constants& constants) {
    if (!value.is_given) return;
    if (key.number != nullptr) constants.*key.number = value.number;
    if constexpr (has(&Key::integer)) {
      if (key.integer != nullptr) constants.*key.integer = static_cast<int>(value.number);
    }
    if constexpr (has(&Key::choice)) {
      if (key.choice != nullptr) constants.*key.choice = value.number != 0;
    }
    if constexpr (has(&Key::table)) {
      if (key.table != nullptr) constants.*key.table = value.table;
    }
    if constexpr (has(&Key::vector)) {
      for (int k = 0; key.vector != nullptr && k < 3; ++k) (constants.*key.vector)[k] = value.vector[k];
    }
  }
  static const char* make(const LawValue* values, void* place) {
    Constants constants{};
    for (std::size_t i = 0; i < keys.size(); ++i) set(keys[i], values[i], constants);
    if constexpr (requires { constants.find_fault(); }) {
      const char* const fault = constants.find_fault();
      if (fault != nullptr && *fault != '\0') return fault;
    }
    if constexpr (std::is_same_v<Law, Constants>)
      new (place) Law(constants);
    else
      new (place) Law(Law::make(constants));
    return nullptr;
  }
  static void start([[maybe_unused]] const void* law, double* history) {
    for (int i = 0; i < Law::history_count; ++i) history[i] = 0;
    if constexpr (requires(const Law& l) { l.start(history); }) static_cast<const Law*>(law)->start(history);
  }
  static LameConstants moduli(const void* law) { return static_cast<const Law*>(law)->moduli(); }
  template <class T>
  static void advance(const void* law, PointStep<T>& step) {
    advance_point(*static_cast<const Law*>(law), step);
  }

  static LawLibrary list() {
    LawLibrary all{};
    all.layout = law_layout;
    all.name = Law::name;
    all.keys = rows.data();
    all.key_count = static_cast<int>(rows.size());
    if constexpr (requires { Law::history_names; }) {
      all.scalars = std::data(Law::history_names);
      all.scalar_count = static_cast<int>(std::size(Law::history_names));
    }
    all.history_count = Law::history_count;
    all.changes_at_rest = requires { requires Law::changes_at_rest; };
    all.stores_energy = requires { requires Law::stores_energy; };
    all.size = sizeof(Law);
    all.alignment = alignof(Law);
    all.make = make;
    all.start = start;
    all.moduli = moduli;
    all.advance = advance<double>;
    all.advance_pack = advance<Pack<double>>;
    return all;
  }
};

}  // namespace percuss

/// The entry of the library of a law. All else in the library is hidden: two of them may have names in common.
#define PERCUSS_EXPORT_LAW(Law)                                                        \
  extern "C" [[gnu::visibility("default")]] const percuss::LawLibrary* percuss_law() { \
    static const percuss::LawLibrary law = percuss::ExportedLaw<Law>::list();          \
    return &law;                                                                       \
  }
