#pragma once
// What elements of different kinds cost in a step, for ranks of equal work.

#include "src/deck/deck.hpp"
#include "src/mesh/topology/elements.hpp"

namespace percuss {

/// Work of a hexahedron with one point, elastic or plastic.
inline constexpr int hexahedron_cost = 32;

/// Work of an element of a block and of its share of the nodes, on the scale of hexahedron_cost. Measured: the phases
/// internal_force, integrate and reduce of blocks of some 10 000 elements on one thread, 56 ns a hexahedron.
int find_element_cost(const Deck& deck, const ElementBlock& block);

}  // namespace percuss
