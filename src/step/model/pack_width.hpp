#pragma once
// Lanes of a pack of elements.

#include <cstddef>

#include "kernels/core/precision.hpp"
#include "kernels/core/simd.hpp"

namespace percuss {

/// Elements of a pack, as lanes count and as containers do.
inline constexpr int pack_width = pack_size<Real>;
inline constexpr std::size_t pack_lanes = pack_size<Real>;

}  // namespace percuss
