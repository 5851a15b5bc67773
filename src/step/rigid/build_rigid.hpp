#pragma once
// The rigid bodies of a model. Internal to build_model; all collective over the mesh's ranks.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// The body of each node of this rank. A node that a rigid and a deformable part share belongs to the body.
struct RigidMap {
  std::vector<int> body;        // [nodes] -1: none; empty without rigid bodies
  std::vector<char> is_shared;  // [nodes] 1: an element that deforms has it too
  std::vector<char> is_in_set;  // [nodes] 1: a set of the deck names it
  std::vector<char> counts;     // [nodes] 0: its mass is none of its body's
  bool holds(int node) const { return !body.empty() && body[static_cast<std::size_t>(node)] >= 0; }
};

/// Finds them; chunks and halo are there. Throws InputError, the same on all ranks, for a node of two bodies.
RigidMap find_rigid_nodes(const Deck& deck, const ChunkedMesh& chunked, const Model& model);

/// Lumped masses [nodes]: of everything; of what deforms and what the deck adds at nodes, with its rotary inertia,
/// which is empty without rotations.
struct RigidMasses {
  const std::vector<double>& all;
  std::vector<double> of_others, inertia_of_others;
};

/// Mass, centre, inertia and nodes of the bodies, and what acts on them; total mass and mass centre of the model. The
/// elements of rigid parts count by exact integrals. Throws InputError for a body without inertia.
void build_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map, const RigidMasses& masses,
                        Model& model);

/// The joints of the deck, once the bodies are there.
void build_joints(const Deck& deck, Model& model);

/// A direction that a condition of the deck holds.
struct HeldByCondition {
  std::size_t condition = 0;  // place in the deck
  int direction = 0;          // x, y, z, then rotations
  int motion = 0;             // row of Model::motions
};

/// Holds the bodies by conditions and `rigid.fixed`. A condition must name all nodes of a body, or be a symmetry.
/// Throws InputError, the same on all ranks, where it does not, or where two move a body in one direction.
void hold_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map,
                       const std::vector<HeldByCondition>& held, Model& model);

/// Velocities of bodies at time 0 from those of their nodes, which are then those of the bodies. mass: [nodes]. Throws
/// InputError, the same on all ranks, where the nodes of a body do not move as one.
void start_rigid_bodies(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& map,
                        const std::vector<double>& mass, Model& model);

}  // namespace percuss
