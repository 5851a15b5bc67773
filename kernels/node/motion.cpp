#include "kernels/node/motion.hpp"

#include "kernels/core/prefetch.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/small_space.hpp"
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

/// Step of predict_velocities() for one node.
struct Predictor {
  NodeForces forces;
  double dt_mean;
  Rows3<double> force, v_before, v;
  bool some_stay;

  KOKKOS_INLINE_FUNCTION void advance(int n) const {
    if (some_stay && forces.inertia(n) == 0) return;
    const Vector3<double> sum = sum_slots(forces.nodes_to_slots, forces.slot_force, n);
    const double f[3] = {sum.x, sum.y, sum.z};
    for (int k = 0; k < 3; ++k) {
      const double before = v(n, k);
      force(n, k) = f[k];
      v_before(n, k) = before;
      v(n, k) = predict(before, f[k], forces.inverse_mass(n, k), forces.gravity.g[k], dt_mean);
    }
  }
};

/// Rows from first to last - 1, whose first value is aligned to a register: the largest magnitude of a component.
KOKKOS_INLINE_FUNCTION double find_largest_in(const double* rows, int first, int last) {
  constexpr int chains = 4, lanes = pack_size<double>;  // each waits for its own last comparison only
  Pack<double> largest[chains] = {0.0, 0.0, 0.0, 0.0};
  int i = 3 * first;
  for (; i + chains * lanes <= 3 * last; i += chains * lanes) {
    for (int c = 0; c < chains; ++c) {
      const Pack<double> value = load_pack(rows + i + c * lanes);
      largest[c] = larger(largest[c], larger(value, -value));
    }
  }
  double of_all = find_largest_lane(larger(larger(largest[0], largest[1]), larger(largest[2], largest[3])));
  for (; i < 3 * last; ++i) of_all = larger(of_all, larger(rows[i], -rows[i]));
  return of_all;
}

/// Calls advance(n) for all nodes and returns the largest magnitude of a component of v afterwards. A block of nodes is
/// measured while it is in the first cache, a register at a time.
template <class Advance>
double advance_and_measure(const char* label, const ExecSpace& space, const Rows3<const double>& v,
                           const Advance& advance) {
  constexpr int block = 64;
  const int count = static_cast<int>(v.extent(0));
  const Rows3<const double> rows = v;
  double most = 0;
  parallel_reduce(
      label, RangeOf(space, 0, (count + block - 1) / block),
      KOKKOS_LAMBDA(const int b, double& largest) {
        const int first = b * block, last = first + block < count ? first + block : count;
        for (int n = first; n < last; ++n) advance(n);
        const double one = find_largest_in(rows.data(), first, last);
        if (one > largest) largest = one;
      },
      Kokkos::Max<double>(most));
  return count > 0 ? most : 0;
}

}  // namespace

void assemble_slots(const ExecSpace& space, const NodeSlots& nodes_to_slots, const Rows3<const double>& slot_force,
                    const Rows3<double>& force) {
  parallel_for(
      "percuss::assemble_slots", RangeOf(space, 0, static_cast<int>(force.extent(0))), KOKKOS_LAMBDA(const int n) {
        const Vector3<double> f = sum_slots(nodes_to_slots, slot_force, n);
        force(n, 0) = f.x;
        force(n, 1) = f.y;
        force(n, 2) = f.z;
      });
}

void predict_velocities(const ExecSpace& space, const NodeForces& forces, double dt_mean, const Rows3<double>& force,
                        const Rows3<double>& v_before, const Rows3<double>& v) {
  const Predictor predictor{forces, dt_mean, force, v_before, v, forces.inertia.extent(0) > 0};
  parallel_for(
      "percuss::predict_velocities", RangeOf(space, 0, static_cast<int>(v.extent(0))),
      KOKKOS_LAMBDA(const int n) { predictor.advance(n); });
}

double predict_and_measure(const ExecSpace& space, const NodeForces& forces, double dt_mean, const Rows3<double>& force,
                           const Rows3<double>& v_before, const Rows3<double>& v) {
  const Predictor predictor{forces, dt_mean, force, v_before, v, forces.inertia.extent(0) > 0};
  return advance_and_measure("percuss::predict_velocities", space, v,
                             [predictor] KOKKOS_FUNCTION(int n) { predictor.advance(n); });
}

void advance_free_nodes(const ExecSpace& space, const NodeForces& forces, double dt_mean, double dt,
                        const Rows3<double>& v, const Rows3<double>& x) {
  parallel_for(
      "percuss::advance_free_nodes", RangeOf(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
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
  parallel_for(
      "percuss::mirror_velocities", RangeOf(space, 0, static_cast<int>(v.extent(0))), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) v_before(n, k) = 2 * v_before(n, k) - v(n, k);
      });
}

void move_nodes(const ExecSpace& space, const Rows3<const double>& v, double dt, const Rows3<double>& x) {
  parallel_for(
      "percuss::move_nodes", RangeOf(space, 0, static_cast<int>(x.extent(0))), KOKKOS_LAMBDA(const int n) {
        for (int k = 0; k < 3; ++k) x(n, k) += dt * v(n, k);
      });
}

double move_and_measure(const ExecSpace& space, const Rows3<const double>& v, double dt, const Rows3<double>& x) {
  return advance_and_measure("percuss::move_nodes", space, v, [v, dt, x] KOKKOS_FUNCTION(int n) {
    for (int k = 0; k < 3; ++k) x(n, k) += dt * v(n, k);
  });
}

double find_largest_component(const ExecSpace& space, const Rows3<const double>& v) {
  return advance_and_measure("percuss::largest_component", space, v, [] KOKKOS_FUNCTION(int) {});
}

double find_largest_component(const ExecSpace& space, const Array<const int>& nodes, int count,
                              const Rows3<const double>& v) {
  double most = 0;
  parallel_reduce(
      "percuss::largest_component_of_nodes", RangeOf(space, 0, count),
      KOKKOS_LAMBDA(const int i, double& largest) {
        for (int k = 0; k < 3; ++k) largest = larger(largest, larger(v(nodes(i), k), -v(nodes(i), k)));
      },
      Kokkos::Max<double>(most));
  return count > 0 ? most : 0;
}

}  // namespace percuss
