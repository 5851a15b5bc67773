#pragma once
// Comparisons of three numbers by their bits: what is skipped because nothing has changed may not even differ in the
// sign of a zero.

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

}  // namespace percuss
