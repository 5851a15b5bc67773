#pragma once
// Preconditions and postconditions as code. With PERCUSS_CONTRACTS (preset `debug`) one that does not hold ends the
// program with its text and place; other builds do not evaluate it.

#include <Kokkos_Core.hpp>

#ifdef PERCUSS_CONTRACTS
#define PERCUSS_TEXT_OF(text) #text
#define PERCUSS_LINE_TEXT(line) PERCUSS_TEXT_OF(line)
#define PERCUSS_HOLD(kind, condition) \
  ((condition) ? void() : Kokkos::abort(kind " at " __FILE__ ":" PERCUSS_LINE_TEXT(__LINE__) ": " #condition))
#else
#define PERCUSS_HOLD(kind, condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
/// What a caller must bring.
#define PERCUSS_EXPECT(condition) PERCUSS_HOLD("precondition", condition)
/// What a function promises.
#define PERCUSS_ENSURE(condition) PERCUSS_HOLD("postcondition", condition)

namespace percuss {

/// Whether the values of a list ascend strictly. For contracts: by one thread.
template <class List>
KOKKOS_INLINE_FUNCTION bool is_ascending(const List& list, int first, int last) {
  for (int i = first + 1; i < last; ++i)
    if (!(list(i - 1) < list(i))) return false;
  return true;
}

}  // namespace percuss
