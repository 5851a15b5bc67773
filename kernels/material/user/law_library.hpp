#pragma once
// What a shared library with a law gives to the program. export_law.hpp makes it of a law's header, `percuss build-law`
// compiles it, library_law.hpp calls it.

#include <cstddef>

#include "kernels/core/simd.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/material_table.hpp"
#include "kernels/material/point_step.hpp"

namespace percuss {

/// What the program and a library must have in common to exchange a point.
struct LawLayout {
  int version;                                  // of this header: raise it with any change of what is exchanged
  std::size_t scalar_point, pack_point, table;  // sizes
  int lanes;

  friend bool operator==(const LawLayout&, const LawLayout&) = default;
};
inline constexpr LawLayout law_layout{1, sizeof(PointStep<double>), sizeof(PointStep<Pack<double>>),
                                      sizeof(MaterialTable), pack_size<double>};

enum class LawKeyKind { number, integer, word, vector, table };

/// A constant of the law, as decks give it.
struct LawKey {
  const char* name;
  LawKeyKind kind;
  KeyRange range;
  bool is_required;
  int most;              // of an integer
  const char* words[2];  // of a word: one of these
};

/// The value of a LawKey.
struct LawValue {
  bool is_given = false;
  double number = 0;  // of a word: 0 or 1
  double vector[3] = {};
  MaterialTable table;
};

/// A law. Its entry in the library is `percuss_law`.
struct LawLibrary {
  LawLayout layout;  // the first member of every version
  const char* name;
  const LawKey* keys;
  int key_count;
  const HistoryScalar* scalars;  // that the history begins with
  int scalar_count;
  int history_count;
  bool changes_at_rest, stores_energy;
  std::size_t size, alignment;  // of the law
  /// Makes the law of its values [key_count] at `place`; returns what is wrong between them, or null.
  const char* (*make)(const LawValue* values, void* place);
  void (*start)(const void* law, double* history);
  LameConstants (*moduli)(const void* law);
  void (*advance)(const void* law, PointStep<double>& step);
  void (*advance_pack)(const void* law, PointStep<Pack<double>>& step);
};

}  // namespace percuss
