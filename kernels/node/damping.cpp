#include "kernels/node/damping.hpp"

namespace percuss {

void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                     const DampedMotion& motion) {
  Kokkos::parallel_for(
      "percuss::damp_velocities", Range(space, 0, static_cast<int>(nodes.entry.extent(0))), KOKKOS_LAMBDA(const int n) {
        const int entry = nodes.entry(n);
        const double share = entry < 0 ? 0 : find_damped_share(step.coefficients(entry), step.dt_mean, step.velocity);
        for (int k = 0; k < 3; ++k) {
          const double damped = find_damped_velocity(motion.before(n, k), motion.velocity(n, k), step.velocity);
          const double lost = motion.inverse_mass(n, k) > 0 ? share * damped : 0;
          motion.velocity(n, k) -= lost;
          motion.impulse(n, k) = -motion.mass(n) * lost;
        }
      });
}

}  // namespace percuss
