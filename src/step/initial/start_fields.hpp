#pragma once
// States of elements and velocities of nodes at time 0 that a deck takes from files.

#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/state.hpp"
#include "src/warning.hpp"

namespace percuss {

/// Sets the velocities of the nodes that files name, after those of `initial`. velocity: [nodes of this rank].
/// is_rigid: [nodes] whether each is of a rigid body. Collective. Throws InputError, SystemError, the same on all
/// ranks: a wrong file, an id that is not there, a node of a rigid body.
void set_start_velocities(const Deck& deck, const ChunkedMesh& chunked, const std::vector<char>& is_rigid,
                          std::vector<Vec3>& velocity);

/// Sets the stresses, plastic strains and temperatures of the elements that files name, and the pressures of fluids at
/// rest, in a state at time 0. Books what they have stored as internal energy. Collective. Throws likewise: an id that
/// is not there, a rigid part, a beam; a stress of a material whose stress does not grow in increments, a history that
/// the material does not have; a temperature at which its law may not start. Returns warnings of what files have and a
/// start does not use.
std::vector<Warning> set_start_states(const Deck& deck, const ChunkedMesh& chunked, const Model& model, State& state);

}  // namespace percuss
