#pragma once
// Views made from host vectors.

#include <vector>

#include "kernels/core/views.hpp"

namespace percuss {

/// A copy of the values in the memory of the kernels.
template <class T>
Array<T> copy_to_array(const char* label, const std::vector<T>& values) {
  Array<T> array(Kokkos::view_alloc(std::string(label), Kokkos::WithoutInitializing), values.size());
  Kokkos::View<const T*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(values.data(), values.size());
  Kokkos::deep_copy(array, host);
  return array;
}

/// A copy of rows of four.
inline Rows4<int> copy_to_rows(const char* label, const std::vector<std::array<int, 4>>& values) {
  Rows4<int> rows(Kokkos::view_alloc(std::string(label), Kokkos::WithoutInitializing), values.size());
  const auto host = Kokkos::create_mirror_view(rows);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < 4; ++j) host(i, j) = values[i][j];
  Kokkos::deep_copy(rows, host);
  return rows;
}

}  // namespace percuss
