#pragma once
// Books of what the surroundings do to the scene: the work and the impulses of conditions, walls, pressure and gravity.
//
// Every impulse P of a step does the work P . (v(n-1/2) + v(n+1/2)) / 2, and every force f(n) the half step's work
// dt v(n+1/2) . f(n) / 2 on either side of it: with the kinetic energy of audit.hpp this closes the balance of the
// explicit midpoint rule exactly.

#include "kernels/core/ordered_sum.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

class Bookkeeper {
 public:
  Bookkeeper(const Deck& deck, const Model& model);

  /// Notes the momentum at time 0.
  void start(const State& state);

  /// Books the impulses of a step and the first half of the work of pressure and conditions. Call with v at n+1/2, x
  /// and forces at n.
  void book_impulses(State& state, double dt, double dt_mean, bool has_contact);

  /// Books the second half of that work. Call with v at n+1/2 and the slots' forces at n+1.
  void book_new_forces(State& state, double dt);

  /// Force of all walls on the scene in the last step: their impulses over dt.
  const Vec3& wall_force() const { return wall_force_; }

 private:
  const Deck& deck_;
  const Model& model_;
  OrderedSum<7> held_sum_;  // work, impulse, moment of impulse
  OrderedSum<1> held_force_sum_;
  OrderedSum<6> wall_sum_;      // impulse, moment of impulse
  OrderedSum<7> pressure_sum_;  // power, force, moment
  Vec3 wall_force_{};
  Vec3 momentum_{};      // at time 0
  Vec3 center_shift_{};  // of the mass centre since time 0, from the booked impulses
};

}  // namespace percuss
