#pragma once
// Doubles by their bits. Comparisons of three numbers: what is skipped because nothing has changed may not even differ
// in the sign of a zero. Keys that are in the order of the numbers. Hashes and random numbers that follow from a key.

#include <bit>
#include <cstdint>
#include <cstring>

#include "kernels/core/simd.hpp"

namespace percuss {

/// Whether the bits of three numbers are those of +0. (The sign of a zero could reach the bits of the state.)
PERCUSS_FORCE_INLINE bool is_plain_zero(const double* row) {
  std::uint64_t bits[3];
  std::memcpy(bits, row, sizeof bits);
  return (bits[0] | bits[1] | bits[2]) == 0;
}

/// Whether three numbers have the bits of three others.
PERCUSS_FORCE_INLINE bool have_same_bits(const double* a, const double* b) {
  std::uint64_t of_a[3], of_b[3];
  std::memcpy(of_a, a, sizeof of_a);
  std::memcpy(of_b, b, sizeof of_b);
  return ((of_a[0] ^ of_b[0]) | (of_a[1] ^ of_b[1]) | (of_a[2] ^ of_b[2])) == 0;
}

/// Whether two numbers have the same bits.
KOKKOS_INLINE_FUNCTION bool has_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
KOKKOS_INLINE_FUNCTION bool has_same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Whether `count` numbers have the bits of so many others.
template <class Scalar>
KOKKOS_INLINE_FUNCTION bool have_same_bits(const Scalar* a, const Scalar* b, int count) {
#ifdef PERCUSS_HAS_SIMD
  return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof(Scalar)) == 0;
#else  // a device has no memcmp
  for (int i = 0; i < count; ++i)
    if (!has_same_bits(a[i], b[i])) return false;
  return true;
#endif
}

/// Order-preserving map from doubles to unsigned integers (-0 and +0 are the same).
KOKKOS_INLINE_FUNCTION std::uint64_t make_sort_key(double value) {
  const double normal = value + 0.0;  // -0 becomes +0
  const auto bits = std::bit_cast<std::uint64_t>(normal);
  const std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014). Different numbers give different ones.
KOKKOS_INLINE_FUNCTION std::uint64_t mix_bits(std::uint64_t h) {
  h += 0x9e3779b97f4a7c15ull;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return h ^ (h >> 31);
}

}  // namespace percuss
