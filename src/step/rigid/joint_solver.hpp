#pragma once
// The impulses of joints in a step: those with which its bodies still share their points and axes at n+1.
//
// They act at the places of n, which makes the scheme of the bodies one with constraints (SHAKE): second order,
// symplectic, with all momenta conserved. Every rank finds them, from the same bits.

#include <vector>

#include "src/step/joints/joint_rows.hpp"
#include "src/step/joints/least_norm.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

class JointSolver {
 public:
  explicit JointSolver(const Model& model);

  bool any() const { return !model_.rigid.joints.empty(); }

  /// Looks at the bodies at n; before solve(). growths: [bodies] as find_response() takes them.
  void begin_step(const State& state, const std::vector<double>& growths);

  /// Moves the bodies of joints. next: momenta of all bodies without joints, before; with them, and places at n+1,
  /// after. Returns the joint that bodies cannot keep, -1: they keep all.
  int solve(const State& state, double dt, std::vector<RigidState>& next);

  /// Velocities, and spins with their momenta, that keep the joints at n. Returns the joint from which the bodies would
  /// part most, by more than a share of their speed; -1: none.
  int settle(const State& state, std::vector<RigidState>& bodies);

  /// Bodies on joints, each once.
  const std::vector<int>& bodies() const { return bodies_; }

  /// Impulses of the last solution: on each body about its centre, and of each joint on its first body about its point.
  const std::vector<Wrench>& on_bodies() const { return on_bodies_; }
  const std::vector<Wrench>& of_joints() const { return of_joints_; }
  const JointFrame& frame(std::size_t joint) const { return frames_[joint]; }

 private:
  /// Joints that hang together, with their rows.
  struct Chain {
    std::vector<int> joints, bodies;
    std::vector<JointRow> rows;
    LeastNormSolver solver;
    std::vector<double> multipliers;
  };

  int solve_chain(const State& state, double dt, Chain& chain, std::vector<RigidState>& next);
  void push(const Chain& chain, const std::vector<RigidState>& free, std::vector<RigidState>& next) const;
  int find_parting(const Chain& chain, const std::vector<RigidState>& bodies, const std::vector<double>& rates) const;
  void measure(const State& state, double dt, const Chain& chain, const std::vector<RigidState>& next);
  void take_impulses(const Chain& chain);
  bool keeps(const State& state, int joint, const double* gap) const;

  const Model& model_;
  std::vector<Chain> chains_;
  std::vector<int> bodies_;
  std::vector<JointFrame> frames_;
  std::vector<BodyResponse> responses_;
  std::vector<Wrench> on_bodies_, of_joints_;
  std::vector<double> gaps_;  // of a chain: what is left
};

/// Forces of joints at n on each body, as the step from n will find them without contact; empty without joints. forces:
/// what else acts on bodies, without gravity.
std::vector<Wrench> find_joint_forces(JointSolver& joints, const Model& model, const State& state,
                                      const std::vector<Wrench>& forces);

}  // namespace percuss
