#include "kernels/node/motion.hpp"

#include "kernels/core/prefetch.hpp"
#include "kernels/core/tensor.hpp"

namespace percuss {

namespace {

/// How many entries ahead of a sum its slots are prefetched: a node's slots lie in several chunks, which the hardware
/// does not predict. 48 to 96 are equally good, 24 and 200 less so.
constexpr int slots_ahead = 64;

/// The node's slots, summed in ascending order.
KOKKOS_INLINE_FUNCTION Vector3<double> sum_slots(const NodeSlots& nodes_to_slots, const Rows3<const double>& slot_force,
                                                 int n) {
  Vector3<double> f{0, 0, 0};
  const int end = nodes_to_slots.first(n + 1), last = static_cast<int>(nodes_to_slots.slots.extent(0)) - 1;
  for (int i = nodes_to_slots.first(n); i < end; ++i) {
    const int ahead = i + slots_ahead;
    fetch_ahead(&slot_force(nodes_to_slots.slots(ahead < last ? ahead : last), 0));
    const double* share = &slot_force(nodes_to_slots.slots(i), 0);
    f = f + Vector3<double>{share[0], share[1], share[2]};
  }
  return f;
}

/// v(n+1/2) of a node in one direction.
KOKKOS_INLINE_FUNCTION double predict(double v, double force, double inverse_mass, double gravity, double dt_mean) {
  return inverse_mass > 0 ? v + dt_mean * (force * inverse_mass + gravity) : v;
}

}  // namespace

void assemble_slots(const ExecSpace& space, const NodeSlots& nodes_to_slots, const Rows3<const double>& slot_force,
                    const Rows3<double>& force) {
  Kokkos::parallel_for(
      "percuss::assemble_slots", Range(space, 0, static_cast<int>(force.extent(0))), KOKKOS_LAMBDA(const int n) {
        const Vector3<double> f = sum_slots(nodes_to_slots, slot_force, n);
        force(n, 0) = f.x;
        force(n, 1) = f.y;
        force(n, 2) = f.z;
      });
}

void predict_velocities(const ExecSpace& space, const NodeForces& forces, double dt_mean, const Rows3<double>& force,
                        const Rows3<double>& v_before, const Rows3<double>& v) {
  const bool some_stay = forces.inertia.extent(0) > 0;
  Kokkos::parallel_for(
      "percuss::predict_velocities", Range(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
        if (some_stay && forces.inertia(n) == 0) return;
        const Vector3<double> sum = sum_slots(forces.nodes_to_slots, forces.slot_force, n);
        const double f[3] = {sum.x, sum.y, sum.z};
        for (int k = 0; k < 3; ++k) {
          const double before = v(n, k);
          force(n, k) = f[k];
          v_before(n, k) = before;
          v(n, k) = predict(before, f[k], forces.inverse_mass(n, k), forces.gravity.g[k], dt_mean);
        }
      });
}

void advance_free_nodes(const ExecSpace& space, const NodeForces& forces, double dt_mean, double dt,
                        const Rows3<double>& v, const Rows3<double>& x) {
  Kokkos::parallel_for(
      "percuss::advance_free_nodes", Range(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
        const Vector3<double> sum = sum_slots(forces.nodes_to_slots, forces.slot_force, n);
        const double f[3] = {sum.x, sum.y, sum.z};
        for (int k = 0; k < 3; ++k) {
          const double after = predict(v(n, k), f[k], forces.inverse_mass(n, k), forces.gravity.g[k], dt_mean);
          v(n, k) = after;
          x(n, k) += dt * after;
        }
      });
}

void mirror_velocities(const ExecSpace& space, const Rows3<const double>& v, const Rows3<double>& v_before) {
  Kokkos::parallel_for(
      "percuss::mirror_velocities", Range(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) v_before(n, k) = 2 * v_before(n, k) - v(n, k);
      });
}

void move_nodes(const ExecSpace& space, const Rows3<const double>& v, double dt, const Rows3<double>& x) {
  Kokkos::parallel_for(
      "percuss::move_nodes", Range(space, 0, static_cast<int>(x.extent(0))), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) x(n, k) += dt * v(n, k);
      });
}

}  // namespace percuss
