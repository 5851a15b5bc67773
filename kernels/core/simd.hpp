#pragma once
// SIMD packs behind one alias, and the few scalar functions that physics is written with.
//
// The physics is templated on its scalar T: a double, a float, or a Pack of them, one element a lane. On a GPU a
// Pack is the plain scalar. std::experimental::simd is the implementation on hosts.

#include <Kokkos_Core.hpp>

#include <cmath>

#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP) || defined(KOKKOS_ENABLE_SYCL)
#define PERCUSS_ON_DEVICE 1
#endif
// PERCUSS_SCALAR_PACKS (preset `scalar`) gives hosts the packs of a GPU, so that a compiler without one tries them.
#if !defined(PERCUSS_ON_DEVICE) && !defined(PERCUSS_SCALAR_PACKS)
#define PERCUSS_HAS_SIMD 1
#include <experimental/simd>
#if defined(__clang__) && defined(__AVX512F__)
// Compiled by Clang for AVX-512, where(mask, a) = b of libstdc++ 12 assigns every lane or none, as a note in its
// _S_blend_avx512 says; select() goes around it.
#define PERCUSS_WHERE_IS_ALL_OR_NOTHING 1
#endif
#endif

// A function of packs that must not become a call: packs are passed through memory, and what a register allocator does
// not see it cannot keep. Left to itself, GCC 12 makes calls of most of an element's step, at half of its speed.
// Without optimisation a call costs nothing beside the rest; under a sanitizer one body of it all compiles for minutes.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PERCUSS_FORCE_INLINE KOKKOS_FORCEINLINE_FUNCTION
#define PERCUSS_FLATTEN [[gnu::flatten]]
#else
#define PERCUSS_FORCE_INLINE KOKKOS_INLINE_FUNCTION
#define PERCUSS_FLATTEN
#endif
// PERCUSS_FLATTEN: a function into which everything that it calls is inlined, packs or not.
// A function whose packs go through memory anyhow, and which has all registers to itself as a call. On a device a call
// would send what the caller holds in registers through memory.
#ifdef PERCUSS_ON_DEVICE
#define PERCUSS_NO_INLINE KOKKOS_FUNCTION
#else
#define PERCUSS_NO_INLINE [[gnu::noinline]] KOKKOS_FUNCTION
#endif

namespace percuss {

#ifdef PERCUSS_HAS_SIMD
/// As many scalars as one vector register holds.
template <class Scalar>
using Pack = std::experimental::native_simd<Scalar>;

template <class Scalar>
inline constexpr int pack_size = static_cast<int>(Pack<Scalar>::size());

/// Element-wise choice: mask ? yes : no.
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE std::experimental::simd<Scalar, Abi> select(const std::experimental::simd_mask<Scalar, Abi>& mask,
                                                                 const std::experimental::simd<Scalar, Abi>& yes,
                                                                 std::experimental::simd<Scalar, Abi> no) {
#ifdef PERCUSS_WHERE_IS_ALL_OR_NOTHING
  return std::experimental::simd<Scalar, Abi>([&](auto lane) { return mask[lane] ? yes[lane] : no[lane]; });
#else
  std::experimental::where(mask, no) = yes;
  return no;
#endif
}
#ifdef PERCUSS_WHERE_IS_ALL_OR_NOTHING
PERCUSS_FORCE_INLINE Pack<double> select(const Pack<double>::mask_type& mask, const Pack<double>& yes,
                                         const Pack<double>& no) {
  return Pack<double>(_mm512_mask_blend_pd(static_cast<__mmask8>(mask.__to_bitset().to_ulong()),
                                           static_cast<__m512d>(no), static_cast<__m512d>(yes)));
}
PERCUSS_FORCE_INLINE Pack<float> select(const Pack<float>::mask_type& mask, const Pack<float>& yes,
                                        const Pack<float>& no) {
  return Pack<float>(_mm512_mask_blend_ps(static_cast<__mmask16>(mask.__to_bitset().to_ulong()),
                                          static_cast<__m512>(no), static_cast<__m512>(yes)));
}
#endif
// GCC 12 takes the undefined vectors that its own functions of 512 bits start from for a mistake (GCC bug 105593).
#ifndef __clang__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE std::experimental::simd<Scalar, Abi> square_root(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::sqrt(a);
}
/// Towards zero.
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE std::experimental::simd<Scalar, Abi> truncate(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::trunc(a);
}
/// Sum of the lanes, in some order, and the largest of them, none of which may be NaN.
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE Scalar sum_lanes(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::reduce(a);
}
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE Scalar find_largest_lane(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::hmax(a);
}
#ifndef __clang__
#pragma GCC diagnostic pop
#endif
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE std::experimental::simd<Scalar, Abi> larger(const std::experimental::simd<Scalar, Abi>& a,
                                                                 const std::experimental::simd<Scalar, Abi>& b) {
  return select(a < b, b, a);
}
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE std::experimental::simd<Scalar, Abi> smaller(const std::experimental::simd<Scalar, Abi>& a,
                                                                  const std::experimental::simd<Scalar, Abi>& b) {
  return select(b < a, b, a);
}
/// Lane by lane by the functions of the scalar, so that a lane has the bits of the scalar.
template <class Scalar, class Abi>
KOKKOS_INLINE_FUNCTION std::experimental::simd<Scalar, Abi> exponential(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::simd<Scalar, Abi>([&](auto lane) { return std::exp(Scalar(a[lane])); });
}
template <class Scalar, class Abi>
KOKKOS_INLINE_FUNCTION std::experimental::simd<Scalar, Abi> logarithm(const std::experimental::simd<Scalar, Abi>& a) {
  return std::experimental::simd<Scalar, Abi>([&](auto lane) { return std::log(Scalar(a[lane])); });
}
template <class Scalar, class Abi>
KOKKOS_INLINE_FUNCTION std::experimental::simd<Scalar, Abi> power(const std::experimental::simd<Scalar, Abi>& a,
                                                                  Scalar exponent) {
  return std::experimental::simd<Scalar, Abi>([&](auto lane) { return std::pow(Scalar(a[lane]), exponent); });
}
template <class Scalar, class Abi>
PERCUSS_FORCE_INLINE bool any(const std::experimental::simd_mask<Scalar, Abi>& mask) {
  return std::experimental::any_of(mask);
}
/// Loads a pack from, or stores it to, memory that is aligned to the pack.
template <class Scalar>
PERCUSS_FORCE_INLINE Pack<Scalar> load_pack(const Scalar* from) {
  return Pack<Scalar>(from, std::experimental::vector_aligned);
}
template <class Scalar>
PERCUSS_FORCE_INLINE void store_pack(Scalar* to, const Pack<Scalar>& value) {
  value.copy_to(to, std::experimental::vector_aligned);
}
#else
template <class Scalar>
using Pack = Scalar;
template <class Scalar>
inline constexpr int pack_size = 1;
template <class Scalar>
PERCUSS_FORCE_INLINE Scalar load_pack(const Scalar* from) {
  return *from;
}
template <class Scalar>
PERCUSS_FORCE_INLINE void store_pack(Scalar* to, const Scalar& value) {
  *to = value;
}
#endif

PERCUSS_FORCE_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
PERCUSS_FORCE_INLINE float select(bool mask, float yes, float no) { return mask ? yes : no; }
PERCUSS_FORCE_INLINE double square_root(double a) { return sqrt(a); }
PERCUSS_FORCE_INLINE float square_root(float a) { return sqrtf(a); }
KOKKOS_INLINE_FUNCTION double exponential(double a) { return exp(a); }
KOKKOS_INLINE_FUNCTION double logarithm(double a) { return log(a); }
KOKKOS_INLINE_FUNCTION double power(double a, double exponent) { return pow(a, exponent); }
PERCUSS_FORCE_INLINE double larger(double a, double b) { return a < b ? b : a; }
PERCUSS_FORCE_INLINE float larger(float a, float b) { return a < b ? b : a; }
PERCUSS_FORCE_INLINE double smaller(double a, double b) { return b < a ? b : a; }
PERCUSS_FORCE_INLINE float smaller(float a, float b) { return b < a ? b : a; }
PERCUSS_FORCE_INLINE double truncate(double a) { return trunc(a); }
PERCUSS_FORCE_INLINE float truncate(float a) { return truncf(a); }
PERCUSS_FORCE_INLINE double sum_lanes(double a) { return a; }
PERCUSS_FORCE_INLINE float sum_lanes(float a) { return a; }
PERCUSS_FORCE_INLINE double find_largest_lane(double a) { return a; }
PERCUSS_FORCE_INLINE float find_largest_lane(float a) { return a; }
PERCUSS_FORCE_INLINE bool any(bool mask) { return mask; }

/// 1 / a of three numbers by one division; their product must neither overflow nor underflow.
template <class T>
PERCUSS_FORCE_INLINE void find_reciprocals(const T (&a)[3], T (&reciprocals)[3]) {
  const T pair = a[0] * a[1], all = T(1) / (pair * a[2]), of_pair = all * a[2];
  reciprocals[0] = of_pair * a[1];
  reciprocals[1] = of_pair * a[0];
  reciprocals[2] = all * pair;
}

}  // namespace percuss
