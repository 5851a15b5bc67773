#pragma once
// Mass that the deck adds to nodes, without elements.

#include <string>
#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Adds the masses of Deck::added_masses to those of the nodes, and to Model::extra_mass; a line for each to
/// Model::mass_notes. A share of a node follows from its own mass and sums that are exact: copies have the same bits.
/// mass: [nodes], of the elements, in and out. Collective. Throws InputError: unknown sets.
void add_deck_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& mass, Model& model);

}  // namespace percuss
