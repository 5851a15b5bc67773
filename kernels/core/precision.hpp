#pragma once
// The precision that percuss is configured for (PERCUSS_PRECISION): the scalar of the elements' work.
//
// In single precision element records, materials and hourglass control are in float. Positions, velocities, masses,
// what is summed over elements and nodes, and contact are in double in either (docs/theory.md, "Single precision").

#include <type_traits>

namespace percuss {

#ifdef PERCUSS_PRECISION_SINGLE
using Real = float;
#else
using Real = double;
#endif

inline constexpr bool is_single_precision = std::is_same_v<Real, float>;

/// As the deck of a run, its summary and its checkpoints name it.
inline constexpr const char* precision_name = is_single_precision ? "single" : "double";

}  // namespace percuss
