#pragma once
// One 64-bit number from another, as if at random: for hashes and for random numbers that follow from a key.

#include <Kokkos_Macros.hpp>
#include <cstdint>

namespace percuss {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014). Different numbers give different ones.
KOKKOS_INLINE_FUNCTION std::uint64_t mix_bits(std::uint64_t h) {
  h += 0x9e3779b97f4a7c15ull;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return h ^ (h >> 31);
}

}  // namespace percuss
