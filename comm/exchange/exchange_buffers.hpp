#pragma once
// Between views where kernels run and the host buffers that messages are sent from and received into.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// One row of a Rows3<double>, as an item of an exchange.
using RowItem = std::array<double, 3>;

/// The rows of a host view as items.
inline std::span<RowItem> as_items(const HostMirror<Rows3<double>>& rows) {
  return {reinterpret_cast<RowItem*>(rows.data()), rows.extent(0)};
}

/// A view with the values of a host vector.
template <class T>
Array<T> copy_to_view(const std::string& label, const std::vector<T>& values) {
  Array<T> view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), values.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) host(i) = values[i];
  copy_values(view, host);
  return view;
}

inline Rows3<double> make_rows(const std::string& label, std::size_t count) {
  return Rows3<double>(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), count);
}

/// packed(i) = values(rows(i)), complete on return. rows: [n], packed: [n][3].
inline void pack_rows(const ExecSpace& space, const Array<const int>& rows, const Rows3<const double>& values,
                      const Rows3<double>& packed) {
  parallel_for(
      "percuss::pack_rows", RangeOf(space, 0, static_cast<int>(rows.extent(0))), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 3; ++k) packed(i, k) = values(rows(i), k);
      });
  space.fence();
}

}  // namespace percuss
