#pragma once
// The parts of the model that the deck's loads, conditions and initial velocities decide. Internal to build_model.
//
// Each fills its own fields of the model and leaves the others alone; all are collective over the mesh's ranks. A slot
// is where one chunk, one pressure face or one load leaves its force for a node.

#include <vector>

#include "comm/halo/halo_plan.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"
#include "src/step/rigid/build_rigid.hpp"

namespace percuss {

/// Finds the faces under pressure and gives them four slots each, after those of the chunks, which must be there.
/// Returns the slots that this rank fills: chunk slots, then pressure slots. In the sum of a node those of pressure
/// come after those of all chunks, by load and then by face of the whole mesh. Throws InputError: unknown sets, both
/// sides of shells.
LocalSlots build_pressure_faces(const Deck& deck, const ChunkedMesh& chunked, Model& model);

/// Finds the nodes under load that this rank owns and gives them a slot each, after those of pressure, at the end of
/// `slots` and, by load, of the sum of a node. Throws InputError: unknown sets.
void build_nodal_loads(const Deck& deck, const ChunkedMesh& chunked, LocalSlots& slots, Model& model);

/// Connects sensors with the loads and conditions that they switch.
void build_switches(const Deck& deck, Model& model);

/// Finds the held directions and their motions, and the inverse mass, which is 0 in them and of rigid nodes; what is
/// held of rigid bodies. mass: [node]. Throws InputError, the same on all ranks, where two conditions of the deck move
/// the same node in the same direction.
void build_held_directions(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid,
                           const std::vector<double>& mass, Model& model);

/// Mass and centre of mass of some nodes.
struct MassPoint {
  double mass = 0;
  Vec3 center{};
};

/// Mass and centre of the given nodes of all ranks: each rank gives the ones that it has, copies of others' included.
/// mass: [node].
MassPoint find_mass_point(const ChunkedMesh& chunked, const std::vector<int>& nodes, const std::vector<double>& mass);

/// Sets the velocity at time 0; of several that name a node the last one in the deck holds. A radial velocity leaves
/// a node at its centre (within 1e-9 of the mesh's diagonal) at rest. Where the deck gives no
/// center of rotation it is the center of mass of the selected nodes. Velocities of files come after. mass: [node].
void build_initial_velocities(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid,
                              const std::vector<double>& mass, Model& model);

}  // namespace percuss
