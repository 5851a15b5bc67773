#pragma once
// Sums over a scene by which a relaxation is steered: its kinetic energy, and a Rayleigh quotient of its motion.

#include "src/step/model/owned_sums.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

struct MotionTotals {
  double kinetic = 0;  // sum of m v(n+1/2)^2 / 2
  double power = 0;    // -v(n-1/2) . (f(n) - f(n-1)) of all nodes
  double inertia = 0;  // sum of m v(n-1/2)^2
  double stored = 0;   // by elements and springs
  // Parts of power and inertia that belong to translations.
  double moving_power = 0, moving_inertia = 0;
};

/// Kind of force of contact on the motion: an impulse that follows the gaps, as a spring does, or one that keeps them.
enum class ContactForce { spring, constraint };

/// Call keep() after one step and find() after the next. Over dt, the quotient of power and inertia is v . K v / v . M
/// v, the square of a frequency that the motion has (Underwood, Dynamic relaxation, in Computational methods for
/// transient analysis, 1983).
class MotionSums {
 public:
  /// Forces of contact count where they are those of springs.
  MotionSums(const Model& model, ContactForce contact);

  /// Keeps the forces of a step. dt_mean: between the middles of it and of the step before.
  void keep(const State& state, double dt_mean);

  /// Collective; the same on all ranks.
  MotionTotals find(const State& state, double dt_mean);

 private:
  MotionTotals sum_bodies(const State& state) const;
  static ExactSum sum_stored(const State& state);

  const Model& model_;
  Rows3<double> force_, moment_, contact_;  // of the step before; contact_: empty where it has no springs
  OwnedNodeSums<5> sums_{"percuss::motion_sums"};
};

}  // namespace percuss
