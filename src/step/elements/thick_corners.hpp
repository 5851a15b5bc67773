#pragma once
// The order in which kernels see the corners of a thick shell, whose third direction is across its thickness.

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Nodes of an element as kernels see it; those of a thick shell are turned as its part says.
std::array<int, kernel_corner_count> find_kernel_nodes(const Deck& deck, const Mesh& mesh, std::size_t element);

/// Whether an element is a thick shell.
bool is_thick_shell(const Deck& deck, const ElementBlock& block);

/// Refuses a part of thick shells that has other solids. On all ranks alike: they know all blocks.
void refuse_other_solids(const Deck& deck, const Mesh& mesh);

}  // namespace percuss
