#pragma once
// Energy and momentum of a rigid body, at consistent times (src/step/audit/audit.hpp).

#include <vector>

#include "src/step/rigid/joint_solver.hpp"
#include "src/step/rigid/rigid_forces.hpp"

namespace percuss {

/// Sums of one body.
struct RigidSums {
  double kinetic = 0;     // M V(n-1/2) . V*(n+1/2) / 2 + L(n-1/2) . I(n)^-1 L*(n+1/2) / 2, * without contact
  double half_steps = 0;  // with time 0 between two half steps: AuditSum::half_steps
  double fallen = 0;      // work of gravity since time 0
  Vector3<double> momentum{}, angular{};  // the latter about Model::mass_center
  double momentum_size = 0, angular_size = 0;
};

/// Forces on a body at n, without gravity.
struct BodyForces {
  Wrench force{}, joint{};  // the latter of joints
};

/// Finds what acts on all bodies. Holds the memory of the sums.
class BodyForceFinder {
 public:
  explicit BodyForceFinder(const Model& model) : model_(model), joints_(model) {}

  /// Forces by body, the same on all ranks. Collective.
  std::vector<BodyForces> operator()(const State& state);

 private:
  const Model& model_;
  RigidForces find_forces_;
  JointSolver joints_;
};

/// index: which body of the model.
RigidSums sum_rigid_body(const Model& model, const State& state, std::size_t index, const BodyForces& on);

/// Kinetic energy and momentum of a chunk of its elements. on: of its body.
RigidSums sum_rigid_chunk(const Model& model, const State& state, const RigidChunk& chunk, const BodyForces& on);

}  // namespace percuss
