#pragma once
// The nodes that welds or constraints name, as a rank sees them.

#include <vector>

#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Which of `connected.nodes` this rank owns and holds.
void find_connected_nodes(const ChunkedMesh& chunked, ConnectedNodes& connected);

/// [connected.nodes] 1: of a rigid body; the same on all ranks. Call when the bodies of the model are built.
/// Collective.
std::vector<int> mark_rigid_nodes(const Model& model, const ConnectedNodes& connected);

}  // namespace percuss
