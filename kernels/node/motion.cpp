#include "kernels/node/motion.hpp"

namespace percuss {

void assemble_forces(const ExecSpace& space, const NodeSlots& nodes_to_slots, const Rows3<const double>& slot_force,
                     const Rows3<double>& force) {
  Kokkos::parallel_for(
      "percuss::assemble_forces", Range(space, 0, static_cast<int>(force.extent(0))), KOKKOS_LAMBDA(const int n) {
        double f[3] = {0, 0, 0};
        for (int i = nodes_to_slots.first(n); i < nodes_to_slots.first(n + 1); ++i) {
          const int s = nodes_to_slots.slots(i);
          for (int k = 0; k < 3; ++k) f[k] += slot_force(s, k);
        }
        for (int k = 0; k < 3; ++k) force(n, k) = f[k];
      });
}

void predict_velocities(const ExecSpace& space, const Rows3<const double>& force,
                        const Rows3<const double>& inverse_mass, const Gravity& gravity, double dt_mean,
                        const Rows3<double>& v_before, const Rows3<double>& v) {
  Kokkos::parallel_for(
      "percuss::predict_velocities", Range(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) {
          const double before = v(n, k);
          const double w = inverse_mass(n, k);
          v_before(n, k) = before;
          v(n, k) = w > 0 ? before + dt_mean * (force(n, k) * w + gravity.g[k]) : before;
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
