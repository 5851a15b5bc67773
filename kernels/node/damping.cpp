#include "kernels/node/damping.hpp"

namespace percuss {

void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const Array<const double>& coefficients,
                     double dt_mean, const DampedMotion& motion) {
  Kokkos::parallel_for(
      "percuss::damp_velocities", Range(space, 0, static_cast<int>(nodes.entry.extent(0))), KOKKOS_LAMBDA(const int n) {
        const int entry = nodes.entry(n);
        const double share = entry < 0 ? 0 : find_damped_share(coefficients(entry), dt_mean);
        for (int k = 0; k < 3; ++k) {
          const double lost =
              motion.inverse_mass(n, k) > 0 ? share * 0.5 * (motion.before(n, k) + motion.velocity(n, k)) : 0;
          motion.velocity(n, k) -= lost;
          motion.impulse(n, k) = -motion.mass(n) * lost;
        }
      });
}

}  // namespace percuss
