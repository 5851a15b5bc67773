#pragma once
// How a material names the constants that a deck gives it: a table of keys, from which the deck's reader, its messages
// and the check of its documentation follow. Plain data; kernels do not look at it.

#include <array>
#include <cstddef>

#include "kernels/material/rate_curves.hpp"

namespace percuss {

/// Which numbers a constant takes.
enum class KeyRange { any, positive, not_negative, not_positive, above_one, share, poissons_ratio };

/// One constant of C, the struct of constants of a material.
template <class C>
struct MaterialKey {
  const char* name = "";
  double C::*number = nullptr;  // exactly one of these, curves and choice
  MaterialTable C::*table = nullptr;
  double (C::*vector)[3] = nullptr;
  KeyRange range = KeyRange::any;
  bool required = true;  // otherwise the initial value of the member is the default
  const char* unit = "-";
  const char* meaning = "";
  RateCurves C::*curves = nullptr;
  bool C::*choice = nullptr;
  const char* words[2] = {"", ""};  // of a choice
};

template <class C>
constexpr MaterialKey<C> need(const char* name, double C::*number, KeyRange range, const char* unit,
                              const char* meaning) {
  return {name, number, nullptr, nullptr, range, true, unit, meaning};
}
template <class C>
constexpr MaterialKey<C> may(const char* name, double C::*number, KeyRange range, const char* unit,
                             const char* meaning) {
  return {name, number, nullptr, nullptr, range, false, unit, meaning};
}
/// A curve [[x, y], ...]; `range` is that of y.
template <class C>
constexpr MaterialKey<C> need(const char* name, MaterialTable C::*table, KeyRange range, const char* unit,
                              const char* meaning) {
  return {name, nullptr, table, nullptr, range, true, unit, meaning};
}
template <class C>
constexpr MaterialKey<C> may(const char* name, MaterialTable C::*table, KeyRange range, const char* unit,
                             const char* meaning) {
  return {name, nullptr, table, nullptr, range, false, unit, meaning};
}
/// Curves [[rate, [[x, y], ...]], ...]; `range` is that of y.
template <class C>
constexpr MaterialKey<C> need(const char* name, RateCurves C::*curves, KeyRange range, const char* unit,
                              const char* meaning) {
  MaterialKey<C> key{name, nullptr, nullptr, nullptr, range, true, unit, meaning};
  key.curves = curves;
  return key;
}
/// One of two words; the member is true by the second, and false at first.
template <class C>
constexpr MaterialKey<C> may(const char* name, bool C::*choice, const char* first, const char* second,
                             const char* meaning) {
  MaterialKey<C> key{name, nullptr, nullptr, nullptr, KeyRange::any, false, "-", meaning};
  key.choice = choice;
  key.words[0] = first;
  key.words[1] = second;
  return key;
}
/// Three numbers.
template <class C>
constexpr MaterialKey<C> need(const char* name, double (C::*vector)[3], KeyRange range, const char* unit,
                              const char* meaning) {
  return {name, nullptr, nullptr, vector, range, true, unit, meaning};
}

/// The keys of a material that is elastic and isotropic at first, and then `more`.
template <class C, class... More>
constexpr std::array<MaterialKey<C>, 2 + sizeof...(More)> with_elastic_keys(const More&... more) {
  return {need("youngs_modulus", &C::youngs_modulus, KeyRange::positive, "pressure", "Young's modulus."),
          need("poissons_ratio", &C::poissons_ratio, KeyRange::poissons_ratio, "-", "Poisson's ratio."), more...};
}

/// The keys of `first`, then those of `second`.
template <class Key, std::size_t N, std::size_t M>
constexpr std::array<Key, N + M> join_keys(const std::array<Key, N>& first, const std::array<Key, M>& second) {
  std::array<Key, N + M> all{};
  for (std::size_t i = 0; i < N; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < M; ++i) all[N + i] = second[i];
  return all;
}

}  // namespace percuss
