#pragma once
// Numbers of the lanes of a pack as code of users has them: arrays [component][lane].

#include <cstring>
#include <limits>

#include "kernels/core/tensor.hpp"

namespace percuss {

/// Lanes of a pack; 1 of a number.
template <class T>
inline constexpr int lane_count = static_cast<int>(sizeof(T) / sizeof(double));

template <class T>
void write_lanes(const T& value, double* to) {
  std::memcpy(to, static_cast<const void*>(&value), sizeof value);
}
template <class T>
T read_lanes(const double* from) {
  T value;
  std::memcpy(static_cast<void*>(&value), from, sizeof value);
  return value;
}
template <class T>
void write_lanes(const Symmetric3<T>& a, double* to) {
  const T component[6] = {a.xx, a.yy, a.zz, a.xy, a.yz, a.zx};
  for (int k = 0; k < 6; ++k) write_lanes(component[k], to + k * lane_count<T>);
}
template <class T>
Symmetric3<T> read_tensor_lanes(const double* from) {
  T a[6];
  for (int k = 0; k < 6; ++k) a[k] = read_lanes<T>(from + k * lane_count<T>);
  return {a[0], a[1], a[2], a[3], a[4], a[5]};
}

/// Called after code of a user has set the state variable that deletes points to `remains`: a deleted point stays so,
/// and has no stress.
template <class T>
void end_deleted(const T& before, T& remains, Symmetric3<T>& stress) {
  const auto is_left = (before > T(0)) & (remains > T(0));
  remains = select(is_left, remains, T(0));
  for (T* const component : {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.yz, &stress.zx})
    *component = select(is_left, *component, T(0));
}

/// Called after code of a user has set the numbers of a history: one that is not finite makes the stress so, which ends
/// the run in this step.
template <class T>
void require_finite(const T* history, int count, Symmetric3<T>& stress) {
  T none(0);
  for (int i = 0; i < count; ++i) none = none + T(0) * history[i];
  stress.xx = select(none == T(0), stress.xx, T(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace percuss
