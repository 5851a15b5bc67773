#pragma once
// Indices of host containers.

#include <cstddef>
#include <cstdint>

namespace percuss {

/// A number of a node, an element or the like, never negative, as containers count.
inline std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

}  // namespace percuss
