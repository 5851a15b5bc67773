#pragma once
// What a run never changes after set-up: connectivity in chunks, masses, materials, conditions and loads.
//
// Each rank has the model of its share of the mesh. Nodes that others use too are there as copies, which go through the
// same motions; the owner alone counts them in sums.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo/halo_plan.hpp"
#include "kernels/core/views.hpp"
#include "kernels/element/centroid_forces.hpp"
#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_lives.hpp"
#include "kernels/node/conditions.hpp"
#include "kernels/node/damped_nodes.hpp"
#include "kernels/node/motion.hpp"
#include "kernels/node/nodal_load.hpp"
#include "kernels/node/pressure.hpp"
#include "kernels/rigid/spin_inertia.hpp"
#include "kernels/shell/thickness_points.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/switches.hpp"
#include "src/mesh/mesh.hpp"
#include "src/mesh/ordering.hpp"
#include "src/step/model/boxed.hpp"
#include "src/step/model/glue_model.hpp"
#include "src/step/model/rigid_model.hpp"
#include "src/step/model/spring_model.hpp"
#include "src/step/model/turn_spring_model.hpp"

namespace percuss {

/// A prescribed motion: one curve for one direction of one condition.
struct Motion {
  Curve curve;
  bool is_displacement = false;
  TurnShare turn;  // of a turn, whose curve is its angular velocity
};

/// The nodes that this rank owns, by the chunk that they belong to: each chunk has a contiguous run of them.
struct NodeRuns {
  int count = 0;     // chunks
  Array<int> first;  // [count] first node of the run
  Array<int> end;    // [count] node past its last
};

/// History that does not start at zero: that of the called materials. A row an element: [element of the chunk][scalar].
struct StartHistory {
  Array<std::size_t> first;  // [chunks] where the rows of a chunk begin
  Array<int> count;          // [chunks] scalars of a row; 0: the history of the chunk starts at zero
  Array<double> values;
};

/// Mass that scaling gave to a part, over all ranks.
struct AddedMass {
  std::string part;
  std::int64_t scaled = 0, elements = 0;  // elements that got mass; all of the part
  double mass = 0, added = 0;             // of the part before; added to it
  double least_bound = 0;                 // smallest step bound before
};

struct ElementBlocks;  // src/step/model/element_blocks.hpp
struct TetNodes;       // kernels/tet/tet_nodes.hpp

struct Model {
  // Not inline: every source would compile them, which takes longer than the rest of this header.
  Model();
  Model(const Model&);
  Model(Model&&) noexcept;
  Model& operator=(const Model&);
  Model& operator=(Model&&) noexcept;
  ~Model();

  Communicator ranks{MPI_COMM_SELF};  // ranks that share the scene
  int node_count = 0;                 // of this rank, copies included
  int element_count = 0;              // of this rank

  ElementChunks chunks;
  Boxed<ElementBlocks> sending;  // chunks whose forces other ranks need, and wait for
  Boxed<ElementBlocks> others;   // the other chunks
  std::size_t state_size = 0;    // scalars of all element records
  StartHistory start_history;
  // [chunks] 1: of a rigid part; of a part that no block has, rigid or a skin. Both empty if there is none.
  Array<int> is_rigid_chunk, is_uncomputed_chunk;
  FailingChunks failing;   // chunks whose material can fail
  bool can_erode = false;  // whether there are any on any rank

  // Whether any rank has shells or beams that bend, whose nodes turn; without them what follows is empty.
  bool has_rotations = false;
  bool ties_rotations = false;
  Array<double> start_thickness;                             // [elements] of shells [length]
  Kokkos::View<ThicknessPoints*, MemSpace> thickness_rules;  // by ElementChunks::rule
  Array<double> gyration_square;  // [elements] rotary inertia over mass, of beams across [length^2]
  Array<double> inertia;          // [nodes] rotary, about any axis; 0 without such an element
  SpinTensors spin_tensors;       // what nodes of beams have besides; at time 0
  Rows3<double> inverse_inertia;  // 0 in held directions
  Rows3<double> start_spin;       // [nodes] angular velocity at time 0
  HeldDirections held_spins;      // directions 0, 1, 2: about x, y, z
  Array<int> owned_held_spins;    // as owned_held

  bool has_beams = false;         // whether any rank has some, trusses among them
  Rows3<double> start_beam_axes;  // [elements] y of the section of each at time 0

  bool has_small_solids = false;  // whether any rank has tetrahedra, wedges or pyramids
  bool mixes_solids = false;      // whether their rates and stresses are averaged over nodes
  Boxed<TetNodes> tet_nodes;      // of the mixed form, of wedges and pyramids too

  NodeSlots nodes_to_slots;
  HaloPlan halo;
  int slot_count = 0;  // chunk slots, four a pressure face, one a loaded node, one a node of springs, slots of
                       // the chunks of fluids once more, then those received from other ranks

  NodeRuns owned_nodes;
  Array<std::int64_t> node_numbers;    // [nodes] place in the whole mesh
  Array<std::int64_t> first_elements;  // [chunks] number of the first element of each in the whole mesh

  Rows3<double> start;                  // position at time 0
  Rows3<double> start_velocity;         // velocity at time 0
  Array<double> element_mass;           // at time 0
  Array<double> mass;                   // lumped: shares of each element's mass to its corners, and extra_mass
  Rows3<double> inverse_mass;           // 0 in held directions and of nodes of rigid bodies
  double total_mass = 0;                // of all ranks
  Vec3 mass_center{};                   // of all ranks, at time 0; moments are taken about it
  std::vector<AddedMass> added_masses;  // of the parts that the deck asks to scale; at the start
  Array<double> extra_mass;             // [nodes] what the deck adds without elements; empty: nothing
  std::vector<std::string> mass_notes;  // what is to be reported of it
  bool scales_in_run = false;           // whether the deck requests more during the run
  bool resists_folding = false;         // whether it requests that of hexahedra, on every rank

  std::array<Curve, 3> gravity;  // acceleration along x, y, z
  bool gravity_varies = false;
  double half_extent = 0;  // half the diagonal of the box of all nodes at time 0
  PressureFaces pressure_faces;
  std::vector<Curve> pressures;       // by load; of a blast, pulses by face
  std::vector<int> pressure_entries;  // by the same: entry of the deck
  NodalLoads nodal_loads;
  std::vector<std::array<Curve, 6>> nodal_values;  // by load: forces, moments
  std::vector<Curve> dampings;                     // by entry of the deck: coefficient [1 / time]
  DampedNodes damped_nodes;                        // by the same
  std::vector<int> damped_bodies;                  // [rigid bodies] entry of each, -1: none; empty without damping
  HeldDirections held;
  Array<int> owned_held;  // entries of `held` whose nodes this rank owns
  SwitchModel switches;
  std::vector<Motion> motions;  // by HeldDirections::motion; row 0 is "at rest"
  bool is_driven = false;       // whether held nodes may move: by a prescribed motion, or when a sensor has them held
  RigidModel rigid;
  SpringModel springs;
  std::vector<TurnSpring> turn_springs;
  WeldModel welds;
  GlueModel glue;
  ConstraintModel constraints;
  EmbeddedModel embedded;
  bool has_fluids = false;  // whether any rank has hexahedra, wedges or pyramids of fluids
  FluidChunks fluids;

  bool damps_stiffness = false;     // on any rank: one without chunks has the arrays of such damping, too
  Array<double> stiffness_damping;  // [chunks] beta [time], 0: none; empty without damps_stiffness
};

/// "spring 'strap_3'" of StepBound::spring; empty: it is none.
inline std::string name_limiting_spring(const Model& model, std::int64_t spring) {
  if (model.springs.has(spring)) return name_spring(model.springs, spring);
  const std::int64_t turn = find_turn_spring(spring);
  return turn < 0 ? "" : "turn spring '" + model.turn_springs[static_cast<std::size_t>(turn)].name + "'";
}

/// Builds the model of a chunked mesh. Collective over the mesh's ranks. Throws InputError with the deck's place, the
/// same on all ranks: unknown sets, contradicting conditions.
Model build_model(const Deck& deck, const ChunkedMesh& chunked);

}  // namespace percuss
