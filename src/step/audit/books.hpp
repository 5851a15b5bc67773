#pragma once
// Books of what the surroundings do to the scene: the work and the impulses of conditions, walls, pressure and gravity.
//
// Every impulse P of a step does the work P . (v(n-1/2) + v(n+1/2)) / 2, and every force f(n) the half step's work
// dt v(n+1/2) . f(n) / 2 on either side of it: with the kinetic energy of audit.hpp this closes the balance of the
// explicit midpoint rule exactly.

#include <array>
#include <optional>

#include "kernels/contact/rows/wall_sums.hpp"
#include "src/mesh/ordering.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/owned_sums.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Sums over nodes that get mass.
struct AddedMassSum {
  enum : int {
    work,
    kinetic,
    mass,
    first_moment,
    impulse = first_moment + 3,
    moment = impulse + 3,
    count = moment + 3
  };
};

class Bookkeeper {
 public:
  Bookkeeper(const Deck& deck, const Model& model);

  /// Notes the momentum at time 0, and where a relaxation has left the mass centre. Collective.
  void start(const State& state);

  /// Ledger data that is not in State::books.
  void archive(CheckpointArchive& archive);

  /// Books the impulses of a step and the first half of the work of conditions and of loads on nodes. Call with v at
  /// n+1/2, x and forces at n. walls: this rank's share, moments about Model::mass_center. Collective.
  void book_impulses(State& state, double dt, double dt_mean, const WallSums& walls);

  /// Books the second half of that work, and the work of pressure. Call with v at n+1/2 and the slots' forces at n+1.
  /// is_switch: what holds changes between steps. Then constant gravity on held directions counts too, and of pressure
  /// the second half only.
  void book_new_forces(State& state, double dt, bool is_switch = false);

  /// Nodes of this rank vanish with what they have: momentum, energy, work of gravity. Call with the state that still
  /// has them; sets its total mass. Collective.
  void book_vanished(const ChunkedMesh& chunked, const std::vector<int>& nodes, State& state);

  /// Nodes of this rank get mass, which comes with their velocity: its momentum and energy are those of an external
  /// impulse. lumped: [nodes] mass and rotary inertia that elements give from now on, in the first two columns. Call
  /// with the state that has the old ones; sets its total mass. Collective.
  void book_added(const Rows3<double>& lumped, State& state);

  /// Force of all walls on the scene in the last step: their impulses over dt. Collective.
  Vec3 find_wall_force() const;

  // Kernels of its own: nvcc takes none in a private function.
  void note_center(const State& state);

 private:
  void book_gravity(State& state, double dt, double dt_mean);
  void book_gravity_work(State& state, double dt) const;
  void book_vanished_spins(const ChunkedMesh& chunked, const std::vector<int>& nodes, State& state) const;

  static constexpr int runs_of_a_block = 128;

  const Deck& deck_;
  const Model& model_;
  ExactSums<7> held_sums_{"percuss::held_sums"};  // work, impulse, moment of impulse
  ExactSums<1> held_force_sum_{"percuss::held_force_sum"};
  // Sums of pressure: impulse and its moment; work. Runs of faces are few.
  ExactSums<6> pressure_sums_{"percuss::pressure_impulses", runs_of_a_block};
  ExactSums<1> pressure_work_{"percuss::pressure_work", runs_of_a_block};
  ExactSums<7> nodal_sums_{"percuss::nodal_sums"};  // work, impulse, moment of impulse of loads on nodes
  ExactSums<1> power_sum_{"percuss::power_sum"};
  std::optional<OwnedNodeSums<AddedMassSum::count>> added_sums_;  // only with mass scaling during the run
  std::array<ExactSum, 3> wall_impulse_{};                        // of the last step; this rank's share
  double wall_dt_ = 0;                                            // of that step; 0: the walls did nothing
  Vec3 start_momentum_{};                                         // at time 0
  Vec3 momentum_now_{};                                           // at n+1/2, from the booked impulses; with gravity
  Vec3 center_shift_{};  // of the mass centre since time 0, from the booked impulses
};

}  // namespace percuss
