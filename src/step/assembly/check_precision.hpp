#pragma once
// What a percuss with elements in single precision cannot compute. Internal to build_model.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Throws InputError, the same on all ranks, for parts of shells and for units in which a float overflows: elements
/// square volumes, and products of mass or stiffness with them. masses: [elements]. Collective.
void check_single_precision(const Deck& deck, const ChunkedMesh& chunked, const std::vector<double>& masses);

}  // namespace percuss
