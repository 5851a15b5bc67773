#pragma once
// The nodes that springs, welds, glue or constraints name, as a rank sees them.

#include <vector>

#include "comm/halo/halo_plan.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Finds those of `connected.nodes` that this rank owns and holds.
void find_connected_nodes(const ChunkedMesh& chunked, ConnectedNodes& connected);

/// Finds these nodes, and adds a slot for the force on each node that this rank owns, after all that there are: the
/// orders of slots of one node differ. Collective.
void add_force_slots(const ChunkedMesh& chunked, const Communicator& ranks, ForcedNodes& forced, LocalSlots& slots);

/// Forces into these slots. by_node: [forced.nodes]; own: scratch, [owned nodes]; all: the slots of this rank.
void fill_force_slots(const ForcedNodes& forced, const std::vector<Vector3<double>>& by_node, const Rows3<double>& own,
                      const Rows3<double>& all);

/// [connected.nodes] rigid body of each, from its owner; -1: none. Call when the bodies of the model are built.
/// Collective.
std::vector<int> share_bodies(const Model& model, const ConnectedNodes& connected);

/// [connected.nodes] 1: of a rigid body. As share_bodies().
std::vector<int> mark_rigid_nodes(const Model& model, const ConnectedNodes& connected);

}  // namespace percuss
