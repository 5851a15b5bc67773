#pragma once
// Fluids of `start.hydrostatic`: compressed at time 0 by the weight of what stands above them.

#include <optional>

#include "kernels/material/pressure/pressed_fluid.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// State of an element at time 0 by the depth of its centroid: with the forces of weight at centroids the pressures of
/// elements then balance their weight on any mesh, but for what the density changes within an element. Nothing: the
/// element is of no such fluid.
std::optional<PressedFluid> find_hydrostatic_state(const Deck& deck, const Mesh& mesh, std::size_t element);

/// Throws InputError, the same on all ranks, if a part rises above its surface, or cannot carry the weight above.
/// Collective.
void check_surfaces(const Deck& deck, const Mesh& mesh);

}  // namespace percuss
