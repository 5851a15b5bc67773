#include "src/step/relaxation/motion_sums.hpp"

#include <array>

#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

MotionSums::MotionSums(const Model& model, ContactForce contact)
    : model_(model), force_("percuss::force_before", static_cast<std::size_t>(model.node_count)) {
  if (model.has_rotations)
    moment_ = Rows3<double>("percuss::moment_before", static_cast<std::size_t>(model.node_count));
  if (contact == ContactForce::spring)
    contact_ = Rows3<double>("percuss::contact_before", static_cast<std::size_t>(model.node_count));
}

void MotionSums::keep(const State& state, double dt_mean) {
  copy_values(force_, state.force);
  if (model_.has_rotations) copy_values(moment_, state.moment);
  if (contact_.extent(0) == 0) return;
  const auto contact = contact_, impulse = state.impulse;
  parallel_for(
      "percuss::keep_contact", RangeOf(ExecSpace(), 0, model_.node_count), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) contact(n, k) = impulse(n, k) / dt_mean;
      });
}

/// Twice the energy of rigid bodies, which every rank knows. Their velocities hardly change in a step.
MotionTotals MotionSums::sum_bodies(const State& state) const {
  MotionTotals totals;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const RigidState& body = state.bodies[b];
    totals.moving_inertia += model_.rigid.bodies[b].mass * dot(body.velocity, body.velocity);
    totals.inertia += dot(body.spin_momentum, body.spin);
  }
  totals.inertia += totals.moving_inertia;
  totals.kinetic = 0.5 * totals.inertia;
  return totals;
}

/// Energy stored in this rank's elements: stresses, hourglass modes, resistance to folding.
ExactSum MotionSums::sum_stored(const State& state) {
  ExactSum sum;
  const auto work = to_host(state.results.work);
  for (std::size_t c = 0; c < work.extent(0); ++c)
    for (std::size_t kind = 0; kind < work_kinds; ++kind)
      if (kind != WorkKind::viscous) sum.add(work(c, kind));
  return sum;
}

MotionTotals MotionSums::find(const State& state, double dt_mean) {
  const auto v = state.v, before = state.v_before, force = state.force, force_before = force_;
  const auto w = state.w, w_before = state.w_before, moment = state.moment, moment_before = moment_;
  const auto mass = state.mass;
  const SpinInertia inertia = state.spin_inertia();
  const auto impulse = state.impulse, contact_before = contact_;
  const bool turns = model_.has_rotations, has_springs = contact_.extent(0) > 0;
  const Array<const int> body_of_node = model_.rigid.body_of_node;
  auto sums = sums_(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 5>& sum) {
        const bool is_rigid = RigidModel::holds(body_of_node, n);
        const double m = is_rigid ? 0 : mass(n), power_so_far = sum[1], inertia_so_far = sum[2];
        for (int k = 0; k < 3; ++k) {
          sum[0] += 0.5 * m * v(n, k) * v(n, k);
          sum[1] -= before(n, k) * (force(n, k) - force_before(n, k));
          sum[2] += m * before(n, k) * before(n, k);
          if (has_springs) sum[1] -= before(n, k) * (impulse(n, k) / dt_mean - contact_before(n, k));
        }
        sum[3] += sum[1] - power_so_far;
        sum[4] += sum[2] - inertia_so_far;
        for (int k = 0; turns && k < 3; ++k) sum[1] -= w_before(n, k) * (moment(n, k) - moment_before(n, k));
        if (!turns || is_rigid) return;
        const Vector3<double> now{w(n, 0), w(n, 1), w(n, 2)}, then{w_before(n, 0), w_before(n, 1), w_before(n, 2)};
        sum[0] += 0.5 * dot(inertia.find_momentum(n, now), now);
        sum[2] += dot(inertia.find_momentum(n, then), then);
      });
  std::array<ExactSum, 6> all{sums[0], sums[1], sums[2], sum_stored(state), sums[3], sums[4]};
  sum_over_ranks(model_.ranks, all);
  const MotionTotals of_bodies = sum_bodies(state);
  double stored = all[3].round();
  for (const double work : state.books.stored_by_actions()) stored += work;
  return {all[0].round() + of_bodies.kinetic,
          all[1].round(),
          all[2].round() + of_bodies.inertia,
          stored,
          all[4].round(),
          all[5].round() + of_bodies.moving_inertia};
}

}  // namespace percuss
