#pragma once
// The mass of an element, by the volume that its kernel sees.

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Density times volume at the start, of fluids at rest over what they are compressed to, without what mass scaling
/// adds.
double find_element_mass(const Deck& deck, const Mesh& mesh, std::size_t element);

}  // namespace percuss
