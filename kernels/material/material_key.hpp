#pragma once
// How a material names the constants that a deck gives it: a table of keys, from which the deck's reader, its messages
// and the check of its documentation follow. Plain data; kernels do not look at it.

#include <array>
#include <cstddef>

#include "kernels/material/rate_curves.hpp"

namespace percuss {

/// The range of numbers that a constant takes.
enum class KeyRange { any, positive, not_negative, not_positive, above_one, share, poissons_ratio };

/// Numbers that a deck gives to a law without a name each.
struct MaterialNumbers {
  static constexpr int most = 200;
  int count = 0;
  double value[most] = {};
};

/// A word, in capitals, filled up with blanks.
struct MaterialText {
  static constexpr int most = 80;
  char text[most] = {};
};

/// The entry of the user's code, as Fortran compilers see `subroutine vumat`. Arrays are [component][point]; components
/// of a symmetric tensor are xx, yy, zz, xy, yz, zx (shear strains as in the tensor), then yx, zy, xz of others.
extern "C" {
using VumatFunction = void (*)(const int* points, const int* direct, const int* shear, const int* states,
                               const int* fields, const int* constants, const int* anneal, const double* step_time,
                               const double* total_time, const double* dt, const char* name, const double* places,
                               const double* length, const double* constant, const double* density,
                               const double* strain, const double* spin, const double* temperature_old,
                               const double* stretch_old, const double* gradient_old, const double* field_old,
                               const double* stress_old, const double* state_old, const double* energy_old,
                               const double* dissipated_old, const double* temperature_new, const double* stretch_new,
                               const double* gradient_new, const double* field_new, double* stress_new,
                               double* state_new, double* energy_new, double* dissipated_new, std::size_t name_length);
}

/// The entry of `subroutine vuhard`: yield stress and its slopes by the temperature, and by the plastic strain and its
/// rate (a second row).
extern "C" {
using VuhardFunction = void (*)(const int* points, const int* elements, const int* point, const int* layer,
                                const int* section_point, const int* anneal, const double* step_time,
                                const double* total_time, const double* dt, const char* name, const int* states,
                                const int* fields, const int* constants, const double* constant,
                                const double* temperature_old, const double* temperature_new, const double* field_old,
                                const double* field_new, const double* state_old, const double* strain,
                                const double* rate, double* yield, double* by_temperature, double* by_strain,
                                double* state_new, std::size_t name_length);
}

/// The entry of `subroutine vusdfld`: fields and state variables at the start of a step. axes:
/// [axis][component][point].
extern "C" {
using VusdfldFunction = void (*)(const int* points, const int* states, const int* fields, const int* constants,
                                 const int* direct, const int* shear, const int* elements, const int* point,
                                 const int* layer, const int* section_point, const double* step_time,
                                 const double* total_time, const double* dt, const char* name, const double* places,
                                 const double* axes, const double* turn, const double* length, const double* constant,
                                 double* state_old, double* state_new, double* field, std::size_t name_length);
}

/// State variables that code of a user may keep at a point.
inline constexpr int most_user_states = 1000;
/// Numbers that any law may keep at a point: elements have room for so many, in which a device calls no code.
#ifdef PERCUSS_ON_DEVICE
inline constexpr int most_law_history = 72;
#else
inline constexpr int most_law_history = most_user_states + 56;
#endif

/// Code of a user, as src/deck/laws/user_code.hpp loads it: one of the two laws, and the fields beside it if there are
/// any.
struct UserCode {
  VumatFunction vumat = nullptr;
  double density = 0;                  // of the material at the start
  int* has_written_outside = nullptr;  // set to 1 by whoever finds that the code has
  const char* file = "";               // of the library, as the deck names it
  VuhardFunction vuhard = nullptr;
  VusdfldFunction vusdfld = nullptr;
  const double* step_starts = nullptr;  // times at which steps of the analysis begin, from the second on
  int step_count = 0;

  /// Time since the begin of the step of the analysis in which this time lies, or which ends there.
  double find_step_time(double time) const {
    double start = 0;
    for (int i = 0; i < step_count && step_starts[i] < time; ++i) start = step_starts[i];
    return time - start;
  }
};

/// A library with a law, and that law with the constants of a material (law_library.hpp); src/deck/laws/law_code.hpp
/// makes them.
struct LawLibrary;
struct MadeLaw {
  const LawLibrary* entry = nullptr;
  const void* law = nullptr;
  int* has_written_outside = nullptr;  // set to 1 by whoever finds that the law has
  const char* file = "";               // of the library, as the deck names it
};

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
  int C::*integer = nullptr;        // zero or positive
  int most = 0;                     // of an integer
  MaterialNumbers C::*list = nullptr;
  MaterialText C::*word = nullptr;
  UserCode C::*code = nullptr;
  MadeLaw C::*law = nullptr;   // its library
  bool is_of_library = false;  // constants by name, which the library knows
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
/// A key of one of the kinds below, without its member.
template <class C>
constexpr MaterialKey<C> name_key(const char* name, bool required, const char* meaning) {
  return {name, nullptr, nullptr, nullptr, KeyRange::any, required, "-", meaning};
}
/// One of two words; the member is true by the second, and false at first.
template <class C>
constexpr MaterialKey<C> may(const char* name, bool C::*choice, const char* first, const char* second,
                             const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, false, meaning);
  key.choice = choice;
  key.words[0] = first;
  key.words[1] = second;
  return key;
}
/// An integer from 0 to `most`.
template <class C>
constexpr MaterialKey<C> may(const char* name, int C::*integer, int most, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, false, meaning);
  key.integer = integer;
  key.most = most;
  return key;
}
/// Numbers without a name each.
template <class C>
constexpr MaterialKey<C> may(const char* name, MaterialNumbers C::*list, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, false, meaning);
  key.list = list;
  return key;
}
/// A word.
template <class C>
constexpr MaterialKey<C> may(const char* name, MaterialText C::*word, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, false, meaning);
  key.word = word;
  return key;
}
/// The file of a user's code.
template <class C>
constexpr MaterialKey<C> need(const char* name, UserCode C::*code, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, true, meaning);
  key.code = code;
  return key;
}
/// The file of a library with a law.
template <class C>
constexpr MaterialKey<C> need(const char* name, MadeLaw C::*law, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, true, meaning);
  key.law = law;
  return key;
}
/// Constants by the names that such a library gives them.
template <class C>
constexpr MaterialKey<C> may_have_constants(const char* name, const char* meaning) {
  MaterialKey<C> key = name_key<C>(name, false, meaning);
  key.is_of_library = true;
  return key;
}
/// Three numbers.
template <class C>
constexpr MaterialKey<C> need(const char* name, double (C::*vector)[3], KeyRange range, const char* unit,
                              const char* meaning) {
  return {name, nullptr, nullptr, vector, range, true, unit, meaning};
}

template <class C>
constexpr MaterialKey<C> may(const char* name, double (C::*vector)[3], KeyRange range, const char* unit,
                             const char* meaning) {
  return {name, nullptr, nullptr, vector, range, false, unit, meaning};
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
