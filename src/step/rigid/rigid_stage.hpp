#pragma once
// The rigid bodies of a step: predicted without contact, corrected by its impulses, placed at n+1.
//
// Every rank moves all bodies, from sums that are the same on each, and its own nodes of them. kernels/rigid has the
// scheme.

#include <utility>
#include <vector>

#include "kernels/contact/rows/row_bodies.hpp"
#include "src/step/model/action.hpp"
#include "src/step/rigid/body_columns.hpp"
#include "src/step/rigid/joint_solver.hpp"
#include "src/step/rigid/rigid_forces.hpp"

namespace percuss {

class RigidStage : public Action {
 public:
  /// damping: [entries of the deck] coefficients of the step; empty: there are none. end: of the run. The model and
  /// damping outlive this.
  RigidStage(const Model& model, const std::vector<double>& damping, double end);

  /// Held motions at time 0 begin at their prescribed velocity; a displacement begins at rest. Bodies that would part
  /// at a joint begin with the velocities after its impulse, which is reported.
  void start(State& state) override;

  /// Velocities of bodies and their nodes at n+1/2 without contact, where nothing is damped. With damping only those of
  /// the first step, without damping, which are mirrored. Throws RunError, the same on all ranks, where a joint is torn
  /// apart, as the next does.
  void predict(State& state, const StepTimes& times) override;
  /// Changes velocities in scenes with damping.
  void change_velocities(State& state, const StepTimes& times) override;
  double bound_component(const State& state, double predicted) const override;

  /// The bodies as contact sees them in this step.
  BodyInputs inputs() const { return inputs_; }

  /// Gives nodes the velocities with contact, and the rotations of the nodes of shells.
  void follow_contact(State& state, const StepTimes& times, const ContactReport* contact) override;

  /// Books what holds bodies (src/step/audit/books.hpp).
  void book_motion(State& state, const StepTimes& times) override;
  void book_forces(State& state, double dt, double time, bool takes_gravity) override;

  void move(State& state, const StepTimes& times) override;

  /// [bodies] impulse of what holds each in the step, once its motion is booked, and the moment about its centre.
  /// Joints are not among what holds them. The same on all ranks.
  const std::vector<Wrench>& reactions() const { return reactions_; }

  /// Step bound of a scene in which nothing deforms: no node goes far beyond its element's edge, no body turns much.
  double largest_step(const State& state) const override;

  void set_switches(State& state) override;
  void archive(CheckpointArchive& archive, State& state) override;
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;
  std::vector<Warning> take_warnings() override { return std::exchange(warnings_, {}); }

 private:
  Wrench find_given(std::size_t index) const;
  /// Impulse of what holds a body in the step, and its moment about the centre.
  Wrench find_reaction(const State& state, std::size_t index, double dt_mean) const;
  /// contact: what each body got from it; empty: nothing.
  void correct(State& state, const std::vector<Wrench>& contact, double dt);
  void set_spins(const State& state) const;
  void leave_out_held_motion(const State& state);
  void damp(const State& state, std::size_t index, double dt_mean);
  std::vector<RigidState> find_bodies_before(const State& state) const;
  Wrench find_damping_impulse(const State& state, std::size_t index) const;
  void book_damping(State& state, std::size_t index, double (&j)[3]) const;
  void book_loads(State& state, std::size_t index, double dt, double dt_mean) const;
  void book_grounded_joints(State& state) const;
  void book_joined_contact(State& state, const std::vector<RigidState>& predicted) const;
  void move_bodies(State& state, double dt);
  void place_bodies(State& state, double dt);
  void warn_of_start(const Joint& joint, double before, double after);
  void upload(const State& state, double dt);

  const Model& model_;
  const std::vector<double>& damping_coefficients_;
  double end_;
  RigidForces find_forces_;
  JointSolver joints_;
  bool is_moved_ = false;        // whether a prescribed motion does work on a body
  std::vector<Wrench> forces_;   // at n, without gravity
  std::vector<Wrench> contact_;  // impulses of this step; empty: none
  std::vector<Wrench> reactions_;
  std::vector<double> damping_;     // [bodies] h of this step (kernels/node/damping.hpp)
  std::vector<double> growths_;     // [bodies] 1 + h
  std::vector<RigidState> free_;    // momenta without joints
  std::vector<RigidState> before_;  // velocities at n-1/2, for damping
  std::vector<RigidState> next_;    // places at n+1, velocities at n+1/2
  Array<BodyStep> steps_;
  Array<BodyResponse> responses_;
  BodyInputs inputs_;
  BodyColumns columns_;
  std::vector<Warning> warnings_;
};

}  // namespace percuss
