#pragma once
// The chunks of fluids whose weight acts at the centroids of their elements, from the deck to the model.

#include "comm/halo/halo_plan.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Lists the hexahedra, wedges and pyramids of fluids and gives their chunks slots of their own, after those of all
/// else. Collective.
void build_fluids(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model);

}  // namespace percuss
