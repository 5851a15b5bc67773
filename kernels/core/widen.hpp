#pragma once
// From floats to doubles and back, for scalars and packs: a pack of floats has the lanes of two packs of doubles.

#include <cstring>

#include "kernels/core/simd.hpp"

namespace percuss {

#ifdef PERCUSS_HAS_SIMD
template <class T>
struct WideOf {
  using type = double;
  static constexpr int count = 1;
};
template <class Scalar, class Abi>
struct WideOf<std::experimental::simd<Scalar, Abi>> {
  using type = Pack<double>;
  static constexpr int count = std::experimental::simd<Scalar, Abi>::size() / pack_size<double>;
};
#else
template <class T>
struct WideOf {
  using type = double;
  static constexpr int count = 1;
};
#endif

/// The double, or the pack of them, that a T widens to, and how many of these have the lanes of a T.
template <class T>
using Wide = typename WideOf<T>::type;
template <class T>
inline constexpr int wide_count = WideOf<T>::count;

/// Part `Part` of the lanes, in double.
template <int Part>
PERCUSS_FORCE_INLINE double widen(float a) {
  static_assert(Part == 0);
  return static_cast<double>(a);
}
template <int Part>
PERCUSS_FORCE_INLINE double widen(double a) {
  return a;
}
PERCUSS_FORCE_INLINE void narrow(const double (&parts)[1], float& a) { a = static_cast<float>(parts[0]); }

#ifdef PERCUSS_HAS_SIMD
namespace detail {

template <class Scalar, int W>
struct RawLanes {
  typedef Scalar type __attribute__((vector_size(W * sizeof(Scalar)), may_alias));
};

template <int First, class Raw, int... I>
PERCUSS_FORCE_INLINE auto take_lanes_from(const Raw& a, std::integer_sequence<int, I...>) {
  return __builtin_shufflevector(a, a, (First + I)...);
}
template <class Raw, int... I>
PERCUSS_FORCE_INLINE auto join_lanes(const Raw& a, const Raw& b, std::integer_sequence<int, I...>) {
  return __builtin_shufflevector(a, b, I...);
}

/// Lane by lane. Of eight lanes GCC 12 would make two conversions of four, taken apart and put together.
template <class To, class From>
PERCUSS_FORCE_INLINE To convert(const From& a) {
#ifdef __AVX512F__
  if constexpr (sizeof(To) == 64) return reinterpret_cast<To>(_mm512_maskz_cvtps_pd(0xff, reinterpret_cast<__m256>(a)));
  if constexpr (sizeof(From) == 64)
    return reinterpret_cast<To>(_mm512_maskz_cvtpd_ps(0xff, reinterpret_cast<__m512d>(a)));
#endif
  return __builtin_convertvector(a, To);
}

}  // namespace detail

template <int Part>
PERCUSS_FORCE_INLINE Pack<double> widen(const Pack<float>& a) {
  constexpr int width = pack_size<double>;
  static_assert(Part < 2 && pack_size<float> == 2 * width);
  if constexpr (width == 1) {
    return Pack<double>(static_cast<double>(a[Part]));
  } else {
    using Short = typename detail::RawLanes<float, 2 * width>::type;
    using Long = typename detail::RawLanes<double, width>::type;
    const Short all = static_cast<Short>(a);
    const auto part = detail::take_lanes_from<Part * width>(all, std::make_integer_sequence<int, width>());
    return Pack<double>(detail::convert<Long>(part));
  }
}

template <int Part>
PERCUSS_FORCE_INLINE Pack<double> widen(const Pack<double>& a) {
  return a;
}

/// widen() of what lies in memory, of which that part alone is read.
template <int Part>
PERCUSS_FORCE_INLINE Pack<double> load_wide(const Pack<float>& from) {
  constexpr int width = pack_size<double>;
  if constexpr (width == 1) {
    return widen<Part>(from);
  } else {
    using Half = typename detail::RawLanes<float, width>::type;
    using Long = typename detail::RawLanes<double, width>::type;
    return Pack<double>(detail::convert<Long>(reinterpret_cast<const Half*>(&from)[Part]));
  }
}

PERCUSS_FORCE_INLINE void narrow(const Pack<double> (&parts)[2], Pack<float>& a) {
  constexpr int width = pack_size<double>;
  if constexpr (width == 1) {
    a = Pack<float>([&](auto lane) { return static_cast<float>(parts[lane][0]); });
  } else {
    using Half = typename detail::RawLanes<float, width>::type;
    using Long = typename detail::RawLanes<double, width>::type;
    const auto low = detail::convert<Half>(static_cast<Long>(parts[0])),
               high = detail::convert<Half>(static_cast<Long>(parts[1]));
    a = Pack<float>(detail::join_lanes(low, high, std::make_integer_sequence<int, 2 * width>()));
  }
}
#else
template <int Part>
PERCUSS_FORCE_INLINE double load_wide(float from) {
  return widen<Part>(from);
}
#endif

/// Calls f(std::integral_constant<int, part>()) for each part of a T.
template <class T, class F>
PERCUSS_FORCE_INLINE void visit_parts(const F& f) {
  [&]<int... Part>(std::integer_sequence<int, Part...>) { (f(std::integral_constant<int, Part>()), ...); }
  (std::make_integer_sequence<int, wide_count<T>>());
}

}  // namespace percuss
