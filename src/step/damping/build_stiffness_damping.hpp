#pragma once
// Elements of a model that are damped in proportion to their stiffness, from the deck.

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Call when the chunks of the model are built. Throws InputError with the deck's place, the same on all ranks:
/// elements or materials that cannot be damped so, and the global estimate of the step.
void build_stiffness_damping(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
