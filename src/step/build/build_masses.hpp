#pragma once
// Masses and rotary inertias of nodes, summed over elements as forces are.

#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Fills the masses, inertias and the mass point of the model, scaled as the deck asks. Returns the mass of each node,
/// with what the deck adds [mass]. Collective.
std::vector<double> build_masses(const Deck& deck, const ChunkedMesh& chunked, Model& model);

/// Lumped masses of what deforms, and of what the deck adds at nodes; only where a rigid body's mass is given.
/// Collective.
std::vector<double> find_masses_of_others(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

}  // namespace percuss
