#pragma once
// Whether double precision resolves the elements where the scene lies: places are absolute, and far from the origin
// their spacing is that of the largest coordinate.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Spacing of doubles over the shortest edge of an element, from which on it is reported.
inline constexpr double noted_spacing = 1e-6;

/// A warning where coordinates resolve the edges of some element worse than noted_spacing. Throws InputError, the same
/// on all ranks, where they resolve them worse than contact decides, or, without contact, than strains of a thousandth.
/// Collective.
std::vector<Warning> check_coordinate_precision(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
