#include "kernels/node/damping.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION double find_node_damping(const DampedNodes& nodes, const DampingStep& step, int n) {
  const int entry = nodes.entry(n);
  return entry < 0 ? 0 : find_damping(step.coefficients(entry), step.dt_mean);
}

}  // namespace

void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                     const DampedMotion& motion, const Array<double>& growth) {
  parallel_for(
      "percuss::damp_velocities", RangeOf(space, 0, static_cast<int>(nodes.entry.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        const double h = find_node_damping(nodes, step, n), share = find_damped_share(h);
        const bool has_growth = growth.extent(0) > 0;
        if (has_growth) growth(n) = 1;
        for (int k = 0; k < 3; ++k) {
          const double inverse = motion.inverse_mass(n, k), before = motion.before(n, k);
          if (has_growth && inverse > 0) growth(n) = 1 + h;
          motion.velocity(n, k) -= inverse > 0 ? share * 0.5 * (before + motion.velocity(n, k)) : 0;
          motion.damped_inverse(n, k) = inverse / (1 + h);
        }
      });
}

void find_damping_impulses(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                           const DampedMotion& motion, const Rows3<double>& impulse) {
  parallel_for(
      "percuss::find_damping_impulses", RangeOf(space, 0, static_cast<int>(nodes.entry.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        if (motion.tensor_row.extent(0) > 0 && motion.tensor_row(n) >= 0) return;
        const double h = find_node_damping(nodes, step, n);
        for (int k = 0; k < 3; ++k) {
          const double both = motion.before(n, k) + motion.velocity(n, k);
          impulse(n, k) = motion.inverse_mass(n, k) > 0 ? -h * motion.mass(n) * both : 0;
        }
      });
}

}  // namespace percuss
