#pragma once
// Sums of small increments in single precision. Value and remainder together hold 48 bits; a single-precision value
// alone would lose in every step what is below half of its last digit (Kahan, Comm. ACM 8, 1965). Doubles have no
// remainder and no code for one.

#include "kernels/core/short_scalar.hpp"

namespace percuss {

/// value + rest += more. The remainder is at most half of the value's last digit unless `more` is larger than the
/// value.
template <class T>
PERCUSS_FORCE_INLINE void add_to(T& value, T& rest, const T& more) {
  const T wanted = more + rest;
  const T sum = value + wanted;
  rest = wanted - (sum - value);
  value = sum;
}
template <class T>
PERCUSS_FORCE_INLINE void add_to(Vector3<T>& value, Vector3<T>& rest, const Vector3<T>& more) {
  add_to(value.x, rest.x, more.x);
  add_to(value.y, rest.y, more.y);
  add_to(value.z, rest.z, more.z);
}
template <class T>
PERCUSS_FORCE_INLINE void add_to(Symmetric3<T>& value, Symmetric3<T>& rest, const Symmetric3<T>& more) {
  add_to(value.xx, rest.xx, more.xx);
  add_to(value.yy, rest.yy, more.yy);
  add_to(value.zz, rest.zz, more.zz);
  add_to(value.xy, rest.xy, more.xy);
  add_to(value.yz, rest.yz, more.yz);
  add_to(value.zx, rest.zx, more.zx);
}
/// Likewise in the lanes that are chosen; the others keep value and rest to the last bit.
template <class Lanes, class T>
PERCUSS_FORCE_INLINE void add_where(const Lanes& lanes, T& value, T& rest, const T& more) {
  T sum = value, left = rest;
  add_to(sum, left, more);
  value = select(lanes, sum, value);
  rest = select(lanes, left, rest);
}
template <class Lanes, class T>
PERCUSS_FORCE_INLINE void add_where(const Lanes& lanes, Symmetric3<T>& value, Symmetric3<T>& rest,
                                    const Symmetric3<T>& more) {
  add_where(lanes, value.xx, rest.xx, more.xx);
  add_where(lanes, value.yy, rest.yy, more.yy);
  add_where(lanes, value.zz, rest.zz, more.zz);
  add_where(lanes, value.xy, rest.xy, more.xy);
  add_where(lanes, value.yz, rest.yz, more.yz);
  add_where(lanes, value.zx, rest.zx, more.zx);
}
template <class T>
PERCUSS_FORCE_INLINE void add_to(Matrix3<T>& value, Matrix3<T>& rest, const Matrix3<T>& more) {
  for (int i = 0; i < 3; ++i) add_to(value.row[i], rest.row[i], more.row[i]);
}

}  // namespace percuss
