#pragma once
// How one rigid body moves over a step, from the momenta that it has between n and n+1.

#include <vector>

#include "src/step/model/state.hpp"

namespace percuss {

/// Held velocities of a body in a step.
struct RigidGoal {
  double velocity[3] = {0, 0, 0};  // where held
  HeldSpin spin;
};

/// dt = 0: at time 0.
RigidGoal find_rigid_goal(const Model& model, const State& state, std::size_t index, double dt);

/// Where the velocities of next take a body, and the momentum that its turn has. Held directions move as they must.
void move_body(const Model& model, const State& state, std::size_t index, double dt, RigidState& next);

/// Momenta of the bodies at n+1/2 under forces at n and gravity; places are those at n.
std::vector<RigidState> predict_momenta(const Model& model, const State& state, const std::vector<Wrench>& forces,
                                        double dt_mean);

/// How a body answers impulses at n. growth: 1 + h of a damped one (DampedMasses), else 1.
BodyResponse find_response(const RigidBody& body, const RigidState& state, double growth);

/// Gives a body an impulse and its moment about the centre; of those that it is held in, move_body() decides.
void give_wrench(const RigidBody& body, const Wrench& wrench, double growth, RigidState& next);

}  // namespace percuss
