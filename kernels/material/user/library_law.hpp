#pragma once
// A law of a library that `percuss build-law` has compiled. It runs on the host alone.

#include <array>
#include <limits>
#include <type_traits>

#include "kernels/material/lane_copies.hpp"
#include "kernels/material/user/law_library.hpp"
#include "kernels/material/user/user_call.hpp"

namespace percuss {

/// The library with the constants of a material.
struct LibraryLaw {
  static constexpr const char* name = "library";
  using Constants = LibraryLaw;

  MadeLaw made;

  static constexpr auto keys() {
    using L = LibraryLaw;
    return std::array{need("law", &L::made,
                           "The shared library that `percuss build-law` has made; --allow-library must name it too."),
                      may_have_constants<L>("constants", "The constants of the law by their names.")};
  }

  static constexpr int history_count = most_law_history;  // at most
  int count_history() const { return made.entry->history_count; }
  // A call: where a list of laws holds another, GCC 12 inlines this with an empty law and warns.
  [[gnu::noinline]] void start(double* history) const {
    call_library(made.file, [&] { made.entry->start(made.law, history); });
  }
  static int first_state() { return 0; }
  int count_states() const { return count_history(); }
  /// Place of a scalar in the history of the law; -1: it has none.
  int find_scalar(HistoryScalar scalar) const {
    for (int i = 0; i < made.entry->scalar_count; ++i)
      if (made.entry->scalars[i] == scalar) return i;
    return -1;
  }
  LameConstants moduli() const {
    LameConstants moduli;
    call_library(made.file, [&] { moduli = made.entry->moduli(made.law); });
    return moduli;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
#ifndef PERCUSS_ON_DEVICE
    // The number past the history is another's: the law must leave it.
    constexpr double mark = -7.0539e212;
    T& end = step.history[made.entry->history_count];
    const T kept = end;
    end = T(mark);
    call_library(made.file, [&] {
      if constexpr (std::is_same_v<T, double>)
        made.entry->advance(made.law, step);
      else
        made.entry->advance_pack(made.law, step);
    });
    const bool has_written = any(end != T(mark));
    end = kept;
    require_finite(step.history, made.entry->history_count, step.stress);
    if (!has_written) return;
    __atomic_store_n(made.has_written_outside, 1, __ATOMIC_RELAXED);
    step.stress.xx = T(std::numeric_limits<double>::quiet_NaN());  // ends the run
#else
    (void)step;
#endif
  }
};

}  // namespace percuss
