#pragma once
// The parts of the model that tetrahedra, wedges and pyramids need. Internal to build_model.

#include "comm/halo/halo_plan.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Throws InputError with the deck's place, the same on all ranks, where the deck requests what tetrahedra, wedges and
/// pyramids do not have.
void check_small_solids(const Deck& deck, const Mesh& mesh);

/// The records of nodes, over which the mixed form averages: one for each material of such elements around a node.
/// Collective; model.halo and the slots of its chunks are there already.
void build_tet_nodes(const Deck& deck, const ChunkedMesh& chunked, const SlotLists& nodes_to_slots, Model& model);

}  // namespace percuss
