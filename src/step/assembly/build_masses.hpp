#pragma once
// Masses and rotary inertias of nodes, summed over elements as forces are.

#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/step/model/model.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {

/// Fills the masses, inertias and the mass point of the model, scaled as the deck asks. Returns the mass of each node,
/// with what the deck adds [mass]. Collective.
std::vector<double> build_masses(const Deck& deck, const ChunkedMesh& chunked, Model& model);

/// Fills Model::spin_tensors, once masses, rigid bodies and welds are there. Nodes that a tie or a weld turns have the
/// same inertia about every axis. Collective.
void build_spin_tensors(const Deck& deck, const ChunkedMesh& chunked, Model& model);

/// Masses of rigid bodies by their nodes. mass: [nodes] of build_masses(), outlives the answer. Collective.
RigidMasses find_rigid_masses(const Deck& deck, const ChunkedMesh& chunked, const std::vector<double>& mass,
                              const Model& model);

}  // namespace percuss
