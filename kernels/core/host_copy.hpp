#pragma once
// Between std::vector on the host and views where the kernels run.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kernels/core/views.hpp"

namespace percuss {

/// A view with the values of a host vector. Where the host reads the memory of kernels copies need no deep_copy(),
/// whose kernels each source would compile for each type.
template <class T>
Array<T> to_view(const std::string& label, const std::vector<T>& values) {
  const Array<T> view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), values.size());
  if constexpr (is_host_memory) {
    std::copy(values.begin(), values.end(), view.data());
  } else {
    const Kokkos::View<const T*, Kokkos::LayoutRight, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> host(values.data(),
                                                                                                       values.size());
    Kokkos::deep_copy(view, host);
  }
  return view;
}

/// Rows of N (Rows3, Rows4) from a host vector of arrays.
template <class T, std::size_t N>
auto to_rows(const std::string& label, const std::vector<std::array<T, N>>& values) {
  const Kokkos::View<T* [N], Kokkos::LayoutRight, MemSpace> view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing),
                                                                 values.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < N; ++k) host(i, k) = values[i][k];
  }
  if constexpr (!is_host_memory) Kokkos::deep_copy(view, host);
  return view;
}

/// The view's values on the host: the view itself where the host reads its memory.
template <class View>
auto to_host(const View& view) {
  if constexpr (is_host_memory)
    return view;
  else
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

}  // namespace percuss
