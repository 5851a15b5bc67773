#pragma once
// Nodes and rigid bodies of a model that are damped, from the deck.

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {

/// Where several entries of the deck name a node, the last one holds. Rigid bodies are there. Collective. Throws
/// InputError, the same on all ranks: unknown sets, and entries that damp a part of a rigid body.
void build_damping(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid, Model& model);

}  // namespace percuss
