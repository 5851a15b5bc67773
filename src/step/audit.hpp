#pragma once
// The audit of a state: energies and momentum at consistent times.
//
// With velocities at n-1/2 and forces at n, the energy that central differences conserve has the kinetic part
// sum m v(n-1/2) . v*(n+1/2) / 2, v* the velocity predicted without contact; held directions have m v(n-1/2)^2 / 2,
// since the forces on them move nothing. Work terms are those of books.hpp; internal, hourglass and viscous energy come
// from the elements' own stresses and rates, so that the balance is a check and not an identity.

#include "kernels/core/ordered_sum.hpp"
#include "src/output/summary.hpp"
#include "src/step/model.hpp"
#include "src/step/state.hpp"

namespace percuss {

struct AuditResult {
  EnergySummary energy;
  MomentumSummary momentum;
};

class Audit {
 public:
  explicit Audit(const Model& model);

  /// Energies and momentum of the state. The first call sets what later ones are compared with.
  AuditResult operator()(const State& state);

 private:
  const Model& model_;
  OrderedSum<10> sum_;
  bool started_ = false;
  double initial_energy_ = 0;
  double largest_energy_ = 0;  // largest of the initial and any later kinetic plus stored energy
  Vec3 initial_momentum_{}, initial_moment_{};
  double momentum_scale_ = 0, moment_scale_ = 0;  // largest sums of magnitudes so far
};

}  // namespace percuss
