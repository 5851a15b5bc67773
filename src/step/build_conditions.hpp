#pragma once
// The parts of the model that the deck's loads, conditions and initial velocities decide. Internal to build_model.
//
// Each fills its own fields of the model and leaves the others alone. A slot is where one element corner or one corner
// of a pressure face leaves its force for the node it stands for.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"
#include "src/step/model.hpp"

namespace percuss {

/// Finds the faces under pressure and gives them four slots each, after those of the chunks, which must be there.
/// Returns the mesh node that each slot stands for: chunk slots, then pressure slots. Throws InputError: unknown sets.
std::vector<int> build_pressure_faces(const Deck& deck, const Mesh& mesh, Model& model);

/// Finds the held directions and their motions, and the inverse mass, which is 0 in them. mass: [node], kg.
/// Throws InputError where two conditions of the deck move the same node in the same direction.
void build_held_directions(const Deck& deck, const Mesh& mesh, const std::vector<double>& mass, Model& model);

/// Sets the velocity at time 0; of several that name a node the last one in the deck holds. Where the deck gives no
/// center of rotation it is the center of mass of the selected nodes. mass: [node], kg.
void build_initial_velocities(const Deck& deck, const Mesh& mesh, const std::vector<double>& mass, Model& model);

}  // namespace percuss
