#pragma once
// The parts of the model that a scene needs whose elements can fail. Internal to build_model.

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds the chunks that can fail and their limits; the tables of chunks are there. Throws InputError with the deck's
/// place, the same on all ranks, for a criterion that the model of a material cannot meet.
void build_failing_chunks(const Deck& deck, const ChunkedMesh& chunked, Model& model);

}  // namespace percuss
