#pragma once
// A curve of a material: rows (x, y), straight between them, level before the first and after the last.

#include "kernels/core/contract.hpp"
#include "kernels/core/simd.hpp"

namespace percuss {

/// y(x). Rows ascend strictly in x; there is at least one.
struct MaterialTable {
  static constexpr int most_rows = 32;
  int rows = 0;
  double x[most_rows] = {};
  double y[most_rows] = {};

  template <class T>
  struct Value {
    T y;
    T slope;  // to the right of a corner
  };

  /// y and its slope at each lane's x.
  template <class T>
  KOKKOS_INLINE_FUNCTION Value<T> operator()(const T& at) const;
};

/// y and its slope at each lane's x, of rows as those of a MaterialTable.
template <class T>
KOKKOS_INLINE_FUNCTION MaterialTable::Value<T> interpolate_rows(const double* x, const double* y, int rows,
                                                                const T& at) {
  PERCUSS_EXPECT(rows > 0);
  MaterialTable::Value<T> value{T(y[0]), T(0)};
  for (int i = 0; i + 1 < rows; ++i) {
    const auto past = at >= T(x[i]);
    if (!any(past)) return value;
    const double slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    value.y = select(past, T(y[i]) + T(slope) * (at - T(x[i])), value.y);
    value.slope = select(past, T(slope), value.slope);
  }
  const auto past = at >= T(x[rows - 1]);
  value.y = select(past, T(y[rows - 1]), value.y);
  value.slope = select(past, T(0), value.slope);
  return value;
}

template <class T>
KOKKOS_INLINE_FUNCTION MaterialTable::Value<T> MaterialTable::operator()(const T& at) const {
  return interpolate_rows(x, y, rows, at);
}

}  // namespace percuss
