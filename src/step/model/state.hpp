#pragma once
// What changes in the loop. All of it is needed to continue a run; the rest can be derived.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/exact_sum.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Sums that the audit needs, from the start of the run. Those that are exact hold the share of this rank and are added
/// up over ranks only when they are looked at.
struct Books {
  ExactSum eroded_work[work_kinds];  // that dead elements took along
  ExactSum eroded_kinetic;           // energy of nodes that vanished
  ExactSum eroded_mass;              // of dead elements
  std::int64_t eroded_elements = 0;  // of all ranks
  ExactSum external_work;      // pressure, driven conditions, gravity that varies; else gravity's is of the positions
  ExactSum impulse[3];         // external: pressure, conditions, walls and gravity [force x time]
  ExactSum moment_impulse[3];  // about Model::mass_center
  double contact_work = 0;     // of all ranks: normal impulses; positive where contact adds energy
  double friction_work = 0;    // of all ranks: tangential impulses; negative where they dissipate
  ExactSum damping_work;       // of damping in proportion to mass; negative: dissipated
  double spring_work = 0;      // of all ranks: what springs have stored, or lost as they broke
  double damper_work = 0;      // of all ranks: what their dampers have taken
  double turn_work = 0;        // of all ranks: what turn springs and their stops have stored
  double turn_loss = 0;        // of all ranks: what their dampers and their friction have taken
  double glue_work = 0;        // of all ranks: what glue has stored and dissipated
  double glue_dissipated = 0;  // of it, by damage and failure
  double glue_failed = 0;      // area of glue that has failed
  double weld_work = 0;        // of all ranks: what welds have given; nearly nothing while they hold
  double equal_work = 0;       // of all ranks: what constraints have given; nothing once their nodes move equally
  double added_mass = 0;       // of all ranks: by mass scaling during the run
  double added_energy = 0;     // kinetic energy that came with it, within external_work

  /// Energies that actions have stored, part of the internal energy, and taken, part of the viscous one.
  std::array<double, 3> stored_by_actions() const { return {spring_work, turn_work, glue_work}; }
  std::array<double, 4> taken_by_actions() const { return {damper_work, turn_loss, -weld_work, -equal_work}; }
};

/// The controlling step bound and what failed, after the elements of a step; of all ranks. Elements by their number in
/// the whole mesh.
struct StepBound {
  double step = 0;                   // bound of elements, contact and springs together, without the deck's scale
  std::int64_t element = 0;          // that has the smallest bound of all elements, the lowest of several
  std::int64_t element_id = 0;       // the user's id of that
  std::int64_t failed_element = -1;  // lowest element without positive volume or step, -1: none
  std::int64_t broken_chunk = -1;    // lowest chunk whose work is not finite, -1: none
  bool died = false;                 // whether an element lost the last of its force in the step
  std::int64_t spring = -1;          // that requests a shorter step than all else, by its place in the model, -1: none;
                                     // below that: a turn spring
};

struct State {
  // Not inline: every source would compile them, which takes longer than the rest of this header.
  State();
  State(const State&);
  State(State&&) noexcept;
  State& operator=(const State&);
  State& operator=(State&&) noexcept;
  ~State();

  double time = 0;     // n
  long step = 0;       // n
  double dt = 0;       // between n-1 and n; 0 before the first step
  double next_dt = 0;  // between n and n+1
  StepBound bound;     // at n
  Gravity gravity;     // at n

  Rows3<double> x;           // position, at n
  Rows3<double> v;           // velocity, at n-1/2 (at n = 0: at 0)
  Rows3<double> v_before;    // velocity one step earlier; scratch of the step
  Rows3<double> force;       // assembled force, at n
  Rows3<double> impulse;     // contact impulse of the last step
  DampedMasses damped;       // of the step that continues, once velocities are damped
  Array<Real> elements;      // element records, at n
  Rows3<double> slot_force;  // internal force (negative) and pressure by slot, at n; also those of other ranks
  ChunkResults results;      // by chunk, at n; work since the start
  ElementLives lives;        // of the chunks that can fail, at n

  // The model's, unless the deck scales masses during the run.
  Array<double> element_mass;  // at n
  Array<double> lumped_mass;   // what all elements give to the nodes, also to those that have vanished; at n

  // The model's, unless nodes may vanish or masses are scaled during the run.
  Array<double> mass;            // of the nodes, at n; 0: vanished
  Rows3<double> inverse_mass;    // 0 in held directions and of vanished nodes
  double total_mass = 0;         // of all ranks
  PressureFaces pressure_faces;  // faces of dead elements have no area
  PressureSums pressure_sums;    // [runs of these faces] of the forces at n, and of the step to n
  NodalLoads nodal_loads;        // without loads of nodes that have vanished

  // Sensors of the deck: which events have come, with their delays. What they have left of the held directions.
  std::vector<char> happened;
  HeldDirections held, held_spins;
  Array<int> owned_held, owned_held_spins;

  // Scenes with shells or beams that bend; empty otherwise.
  Rows3<double> w;                 // angular velocity of the nodes, at n-1/2 (at n = 0: at 0)
  Rows3<double> w_before;          // one step earlier; scratch of the step
  Array<double> inertia;           // rotary, of the nodes: as mass
  Rows3<double> inverse_inertia;   // 0 in held directions and of vanished nodes
  SpinTensors spin_tensors;        // what nodes of beams have besides, at n
  Rows3<double> moment;            // assembled moment, at n
  Rows3<double> slot_moment;       // internal moment (negative) by slot, at n; also those of other ranks
  std::vector<RigidState> bodies;  // rigid ones
  std::vector<JointState> joints;  // between them
  std::vector<SpringState> springs;
  std::vector<TurnSpringState> turn_springs;
  std::vector<double> glue_damage;  // [GlueModel::points] at n; 1: failed, or gone with an element
  std::vector<Point3> glue_arms;    // [GlueModel::points] GluePoint::arm, turned with its node, at n
  std::vector<WeldState> welds;
  std::vector<ConstraintState> constraints;
  // Impulses of the last step on their nodes, of constraints too; empty without any; scratch of the step.
  Rows3<double> weld_impulse, weld_moment;
  Rows3<double> tie_moment;                     // likewise of ties that carry rotations, on this rank's own nodes
  Rows3<double> damping_force, damping_moment;  // by slot, of damping in proportion to stiffness; empty without
  Books books;

  /// Fields that an evaluation of the elements reads and writes.
  ChunkFields chunk_fields() const { return {elements, slot_force, results, slot_moment}; }
  SpinInertia spin_inertia() const { return {inertia, inverse_inertia, spin_tensors}; }
  /// Factor on impulses after the damping of a step: 1/m, or 1/(m (1 + h)) of damped nodes.
  const Rows3<double>& answering_inverse_mass() const {
    return damped.growth.extent(0) > 0 ? damped.inverse_mass : inverse_mass;
  }
  const Rows3<double>& answering_inverse_inertia() const {
    return damped.inverse_inertia.extent(0) > 0 ? damped.inverse_inertia : inverse_inertia;
  }
  /// Whose inertia turns in a step from n on.
  TurningNodes turning_nodes(double step_dt) const { return {w_before, w, moment, step == 0 ? 0 : dt, step_dt}; }
  /// Elements that can fail, of the model.
  FailingElements failing_elements(const FailingChunks& failing) const { return {failing, elements, lives}; }
};

/// The state at time 0: elements at rest in their first shape, held directions at their prescribed velocity.
State make_initial_state(const Model& model);

/// Gravity of the model at a time.
Gravity find_gravity(const Model& model, double time);

/// Gravity whose work is its product with the displacements: none if it varies, whose work is booked step by step.
Gravity find_constant_gravity(const Model& model);

/// Gives the state masses of the nodes of its own, if they were the model's.
void own_masses(const Model& model, State& state);

/// 64 bits of all positions, velocities and element records, by number in the whole mesh: independent of ranks, threads
/// and order. Collective; the same on all ranks.
std::uint64_t hash_state(const Model& model, const State& state);

}  // namespace percuss
