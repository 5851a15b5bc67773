#pragma once
// The rigid bodies of a step: predicted without contact, corrected by its impulses, placed at n+1.
//
// Every rank moves all bodies, from sums that are the same on each, and its own nodes of them. kernels/rigid has the
// scheme.

#include <vector>

#include "kernels/contact/rows/row_bodies.hpp"
#include "src/step/rigid/joint_solver.hpp"
#include "src/step/rigid/rigid_forces.hpp"

namespace percuss {

class RigidStage {
 public:
  explicit RigidStage(const Model& model);

  bool any() const { return model_.rigid.any(); }

  /// Held motions at time 0 begin at their prescribed velocity; a displacement begins at rest. Throws InputError, the
  /// same on all ranks, where bodies part at a joint.
  void start(State& state);

  /// Velocities of bodies and their nodes at n+1/2 without contact. damping: coefficients by entry of the deck; empty:
  /// there are none. Collective. Throws RunError, the same on all ranks, where a joint is torn apart.
  void predict(State& state, double dt, double dt_mean, const std::vector<double>& damping);

  /// The bodies as contact sees them in this step.
  BodyInputs inputs() const { return inputs_; }

  /// The same velocities with contact: what each body got from it; empty: nothing.
  void correct(State& state, const std::vector<Wrench>& contact, double dt);

  /// Rotations of the nodes of shells.
  void set_spins(const State& state) const;

  /// Impulses and the first half of the work of what holds bodies (src/step/audit/books.hpp). Before place().
  void book(State& state, double dt, double dt_mean) const;

  /// Bodies and nodes at n+1.
  void place(State& state);

  /// The second half of that work. Call with the slots' forces at n+1; time: of n+1. takes_gravity: constant gravity on
  /// held directions counts too, which matters where what is held changes. Collective.
  void book_rest(State& state, double dt, double time, bool takes_gravity = false);

  /// Which conditions of bodies hold after the events so far.
  void set_switches(State& state) const;

  /// A step for a scene in which nothing deforms: no node goes far beyond its element's edge, no body turns much.
  double find_step(const State& state, double end) const;

 private:
  void damp(const State& state, std::size_t index, const std::vector<double>& damping, double dt_mean);
  void book_damping(State& state, std::size_t index, double (&j)[3]) const;
  void book_loads(State& state, std::size_t index, double dt, double dt_mean) const;
  void book_grounded_joints(State& state) const;
  void book_joined_contact(State& state, const std::vector<RigidState>& predicted) const;
  void move(State& state, double dt);
  void upload(const State& state, double dt);

  const Model& model_;
  RigidForces find_forces_;
  JointSolver joints_;
  bool is_moved_ = false;         // whether a prescribed motion does work on a body
  std::vector<Wrench> forces_;    // at n, without gravity
  std::vector<Wrench> contact_;   // impulses of this step; empty: none
  std::vector<Wrench> damping_;   // likewise
  std::vector<RigidState> free_;  // momenta without joints
  std::vector<RigidState> next_;  // places at n+1, velocities at n+1/2
  Array<BodyStep> steps_;
  Array<BodyResponse> responses_;
  BodyInputs inputs_;
};

}  // namespace percuss
