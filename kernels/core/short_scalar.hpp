#pragma once
// Floats and packs of them beside doubles: how physics that is written once finds out which it works in.

#include <type_traits>

#include "kernels/core/tensor.hpp"

namespace percuss {

/// The scalar that a pack holds many of.
template <class T>
struct ScalarOf {
  using type = T;
};
#ifdef PERCUSS_HAS_SIMD
template <class Scalar, class Abi>
struct ScalarOf<std::experimental::simd<Scalar, Abi>> {
  using type = Scalar;
};
#endif

/// Whether T is a float or a pack of them: code that would lose digits in single precision tests this.
template <class T>
inline constexpr bool is_short = std::is_same_v<typename ScalarOf<T>::type, float>;

/// A number as a T: packs of floats take no double by themselves. By value, as a device has no address of a constant.
template <class T, class Number>
requires std::is_arithmetic_v<Number> PERCUSS_FORCE_INLINE T number(Number a) {
  return T(static_cast<typename ScalarOf<T>::type>(a));
}
template <class T>
PERCUSS_FORCE_INLINE T number(const T& a) requires(!std::is_arithmetic_v<T>) {
  return a;
}

/// A number that is small beside any number of a scene: a divisor that must not vanish. And a number beyond any of a
/// scene.
template <class T>
inline constexpr auto next_to_nothing = static_cast<typename ScalarOf<T>::type>(is_short<T> ? 1e-36 : 1e-300);
template <class T>
inline constexpr auto beyond_all = static_cast<typename ScalarOf<T>::type>(is_short<T> ? 1e30 : 1e300);

#ifdef PERCUSS_HAS_SIMD
/// As symmetric_part() of a matrix of anything that takes a double.
PERCUSS_FORCE_INLINE Symmetric3<Pack<float>> symmetric_part(const Matrix3<Pack<float>>& a) {
  const Pack<float> half(0.5F);
  return {a.row[0].x,
          a.row[1].y,
          a.row[2].z,
          half * (a.row[0].y + a.row[1].x),
          half * (a.row[1].z + a.row[2].y),
          half * (a.row[2].x + a.row[0].z)};
}
#endif

}  // namespace percuss
