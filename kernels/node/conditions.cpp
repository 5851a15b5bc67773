#include "kernels/node/conditions.hpp"

#include "kernels/core/small_space.hpp"

namespace percuss {

void hold_velocities(const ExecSpace& space, const HeldDirections& held, const PrescribedMotions& motions,
                     const Rows3<const double>& x, double dt, const Rows3<double>& v) {
  if (held.count == 0) return;
  parallel_for(
      "percuss::hold_velocities", RangeOf(space, 0, held.count), KOKKOS_LAMBDA(const int i) {
        const int n = held.node(i);
        const int k = held.direction(i);
        const int m = held.motion(i);
        const double value = motions.value(m);
        const TurnShare& turn = motions.turn(m);
        if (turn.other >= 0) {
          v(n, k) =
              turn.sign * value * (x(n, turn.other) - turn.other_center) - motions.back(m) * (x(n, k) - turn.center);
        } else {
          v(n, k) = motions.is_displacement(m) != 0 ? (held.start(i) + value - x(n, k)) / dt : value;
        }
      });
}

}  // namespace percuss
