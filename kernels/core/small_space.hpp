#pragma once
// Where a contact kernel runs: little work runs in the calling thread, because waking threads would cost more. On a
// device all work runs there, because the calling thread does not see its memory.
//
// Every contact kernel gives the same bits in either space.

#include <string>
#include <type_traits>

#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"

#if defined(KOKKOS_ENABLE_SERIAL) && !defined(PERCUSS_BACKEND_SERIAL) && !defined(PERCUSS_ON_DEVICE) && \
    !defined(PERCUSS_MEMORY_APART)
#define PERCUSS_SMALL_SPACE 1
#endif

/// Repeats what a macro has for a space, as the explicit instantiations of a source, for each space that there is.
#if defined(PERCUSS_SMALL_SPACE)
#define PERCUSS_IN_EACH_SPACE(MACRO) MACRO(ExecSpace) MACRO(SmallSpace)
#else
#define PERCUSS_IN_EACH_SPACE(MACRO) MACRO(ExecSpace)
#endif

namespace percuss {

#if defined(PERCUSS_SMALL_SPACE)
using SmallSpace = Kokkos::Serial;
#else
using SmallSpace = ExecSpace;
#endif
static_assert(Kokkos::SpaceAccessibility<SmallSpace, MemSpace>::accessible, "both spaces work on the same views");

template <class Space>
using RangeOf = Kokkos::RangePolicy<Space, Kokkos::IndexType<int>>;

/// Calls work(space) with the space that suits `items` items of about the cost of a contact pair.
template <class Work>
void run_where_it_pays(int items, Work&& work) {
  constexpr int worth_threads = 1000;  // items: a hundred microseconds or more, against some to wake the threads
  if (items < worth_threads)
    work(SmallSpace());
  else
    work(ExecSpace());
}

/// Calls loop(i) for each i below `count`, in the space that suits `items` items, and waits for it.
template <class Loop>
void loop_where_it_pays(const char* name, int count, int items, const Loop& loop) {
  run_where_it_pays(items, [&](const auto& space) {
    Kokkos::parallel_for(name, RangeOf<std::decay_t<decltype(space)>>(space, 0, count), loop);
    space.fence();
  });
}

/// Makes room for n items, with some to spare; contents are lost when it grows.
template <class View>
void reserve(View& view, int n) {
  const auto wanted = static_cast<std::size_t>(n);
  if (view.extent(0) >= wanted) return;
  const std::string label = view.label();
  view = View();  // the old memory goes before the new comes
  view = View(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), wanted + wanted / 2);
}

/// Makes room for n items without losing the first `kept`.
template <class Space, class View>
void keep_and_reserve(const Space& space, View& view, int kept, int n) {
  if (view.extent(0) >= static_cast<std::size_t>(n)) return;
  const View old = view;
  view = View(old.label(), 0);
  reserve(view, n);
  const View fresh = view;
  Kokkos::parallel_for(
      "contact::keep", RangeOf<Space>(space, 0, kept), KOKKOS_LAMBDA(int i) { fresh(i) = old(i); });
}

}  // namespace percuss
