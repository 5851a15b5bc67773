#pragma once
// Lists of indexes built in parallel, the same for any number of threads: compaction and grouping by key.

#include <type_traits>

#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

/// One value of a view, on the host.
template <class T>
std::remove_const_t<T> read_value(const WorkSpace& space, const Array<T>& view, int i) {
  std::remove_const_t<T> value{};
  const auto source = Kokkos::subview(view, i);
  Kokkos::View<std::remove_const_t<T>, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> target(&value);
  space.fence();
  copy_values(target, source);
  return value;
}

/// Writes the i in [0, n) for which wanted(i), ascending; returns how many.
template <class Predicate>
int list_where(const WorkSpace& space, int n, const Predicate& wanted, const Array<int>& list) {
  int total = 0;
  if (space.concurrency() == 1) {  // a scan would ask everything twice
    parallel_reduce(
        "contact::list_where", RangeOf(space, 0, 1),
        KOKKOS_LAMBDA(int, int& place) {
          for (int i = 0; i < n; ++i)
            if (wanted(i)) list(place++) = i;
        },
        total);
    return total;
  }
  parallel_scan(
      "contact::list_where", RangeOf(space, 0, n),
      KOKKOS_LAMBDA(int i, int& place, bool final_pass) {
        if (!wanted(i)) return;
        if (final_pass) list(place) = i;
        ++place;
      },
      total);
  return total;
}

/// Sorts values[first, last) in place: insertion for short or nearly sorted runs, heap sort for long ones.
KOKKOS_INLINE_FUNCTION void sort_run(const Array<int>& values, int first, int last) {
  constexpr int longest_insertion = 48;
  if (last - first <= longest_insertion) {
    for (int i = first + 1; i < last; ++i) {
      const int value = values(i);
      int j = i;
      for (; j > first && values(j - 1) > value; --j) values(j) = values(j - 1);
      values(j) = value;
    }
    return;
  }
  const int n = last - first;
  const auto sift = [&](int root, int end) {
    const int value = values(first + root);
    for (int child = 2 * root + 1; child < end; child = 2 * root + 1) {
      if (child + 1 < end && values(first + child) < values(first + child + 1)) ++child;
      if (values(first + child) <= value) break;
      values(first + root) = values(first + child);
      root = child;
    }
    values(first + root) = value;
  };
  for (int root = n / 2 - 1; root >= 0; --root) sift(root, n);
  for (int end = n - 1; end > 0; --end) {
    const int largest = values(first);
    values(first) = values(first + end);
    values(first + end) = largest;
    sift(0, end);
  }
}

/// Values with their keys. Those with keys from num_keys on are left out of groups.
struct KeyedValues {
  int count = 0;
  Array<const int> key, value;  // [count]
  int num_keys = 0;
};

/// Values by key, ascending within each.
struct KeyGroups {
  Array<int> count;   // [num_keys] scratch
  Array<int> offset;  // [num_keys + 1] out
  Array<int> values;  // [KeyedValues::count] out
};

inline void group_by_key(const WorkSpace& space, const KeyedValues& of, const KeyGroups& groups) {
  const int n = of.count, num_keys = of.num_keys;
  const Array<const int> key = of.key, value = of.value;
  const Array<int> count = groups.count, offset = groups.offset, grouped = groups.values;
  const bool is_alone = space.concurrency() == 1;  // and needs no atomics
  parallel_for(
      "contact::group_clear", RangeOf(space, 0, num_keys), KOKKOS_LAMBDA(int k) { count(k) = 0; });
  parallel_for(
      "contact::group_count", RangeOf(space, 0, n), KOKKOS_LAMBDA(int i) {
        if (key(i) >= num_keys) return;
        if (is_alone)
          ++count(key(i));
        else
          Kokkos::atomic_add(&count(key(i)), 1);
      });
  int total = 0;
  parallel_scan(
      "contact::group_offset", RangeOf(space, 0, num_keys + 1),
      KOKKOS_LAMBDA(int k, int& place, bool final_pass) {
        if (final_pass) offset(k) = place;
        if (k < num_keys) place += count(k);
      },
      total);
  parallel_for(
      "contact::group_fill", RangeOf(space, 0, n), KOKKOS_LAMBDA(int i) {
        if (key(i) >= num_keys) return;
        const int left = is_alone ? count(key(i))-- : Kokkos::atomic_fetch_add(&count(key(i)), -1);
        grouped(offset(key(i) + 1) - left) = value(i);
      });
  parallel_for(
      "contact::group_sort", RangeOf(space, 0, num_keys),
      KOKKOS_LAMBDA(int k) { sort_run(grouped, offset(k), offset(k + 1)); });
}

}  // namespace percuss
