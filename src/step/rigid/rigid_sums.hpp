#pragma once
// Energy and momentum of a rigid body, at consistent times (src/step/audit/audit.hpp).

#include "src/step/model/state.hpp"

namespace percuss {

/// Of one body.
struct RigidSums {
  double kinetic = 0;     // M V(n-1/2) . V*(n+1/2) / 2 + L(n-1/2) . I(n)^-1 L*(n+1/2) / 2, * without contact
  double half_steps = 0;  // with time 0 between two half steps: AuditSum::half_steps
  double fallen = 0;      // work of gravity since time 0
  Vector3<double> momentum{}, angular{};  // the latter about Model::mass_center
  double momentum_size = 0, angular_size = 0;
};

/// index: which body of the model; force: on it at n, without gravity.
RigidSums sum_rigid_body(const Model& model, const State& state, std::size_t index, const Wrench& force);

}  // namespace percuss
