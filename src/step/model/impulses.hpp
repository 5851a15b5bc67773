#pragma once
// Impulses on nodes: their sums with moments, and those that a condition gives to a node that it holds.

#include <array>

#include "kernels/rigid/rigid_motion.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// The point about which moments are booked, as kernels take it.
struct MomentCenter {
  double at[3];
  explicit MomentCenter(const Vec3& c) : at{c[0], c[1], c[2]} {}
};

inline void add_work(const ExactSum& work, Books& books) {
  books.external_work.merge(work);
  books.external_work.normalize();
}

/// Calls add(first + i, ...) for the impulse j at position r (relative to the point of moments) and its moment: three
/// sums each [force x time, force x length x time].
template <class Add>
KOKKOS_INLINE_FUNCTION void add_impulse(const double (&r)[3], const double (&j)[3], int first, const Add& add) {
  for (int k = 0; k < 3; ++k) add(first + k, j[k]);
  add(first + 3, r[1] * j[2] - r[2] * j[1]);
  add(first + 4, r[2] * j[0] - r[0] * j[2]);
  add(first + 5, r[0] * j[1] - r[1] * j[0]);
}

/// Merges three sums of impulse and three of its moment into the books.
inline void add_to_books(const ExactSum* impulse, const ExactSum* moment, Books& books) {
  for (std::size_t k = 0; k < 3; ++k) {
    books.impulse[k].merge(impulse[k]);
    books.impulse[k].normalize();
    books.moment_impulse[k].merge(moment[k]);
    books.moment_impulse[k].normalize();
  }
}

/// Adds sums that stand one after the other from `first` on, impulse first.
template <std::size_t K>
void add_to_books(const std::array<ExactSum, K>& sums, std::size_t first, Books& books) {
  add_to_books(&sums[first], &sums[first + 3], books);
}

/// Impulse of welds or ties on a node in a direction, of rows that are empty without them.
KOKKOS_INLINE_FUNCTION double find_joined(const Rows3<const double>& rows, int n, int k) {
  return rows.extent(0) > 0 ? rows(n, k) : 0;
}

/// Whatever holds a direction gives J = m (v+ - v-) - dt_mean (f + m g) - P, with the forces f at n, the velocities
/// before and after the step and the impulse P of contact and welds.
struct HeldReactions {
  HeldDirections held;
  Gravity gravity;
  Rows3<const double> v, v_before, force, impulse, welded;
  Array<const double> mass;
  double dt_mean = 0;

  /// J of entry i of the held directions [force x time].
  KOKKOS_INLINE_FUNCTION double operator()(int i) const {
    const int n = held.node(i), k = held.direction(i);
    const double m = mass(n);
    return m * (v(n, k) - v_before(n, k)) - dt_mean * (force(n, k) + m * gravity.g[k]) - impulse(n, k) -
           find_joined(welded, n, k);
  }
};

inline HeldReactions find_reactions(const State& state, double dt_mean) {
  return {state.held,    state.gravity,      state.v,    state.v_before, state.force,
          state.impulse, state.weld_impulse, state.mass, dt_mean};
}

/// Likewise of a held rotation: J = L+ - L- - dt_mean m - P, with the angular momenta at n and the moments P of welds
/// and ties. The momentum of a node with a tensor changes by its turn too, at a constant spin.
struct HeldMoments {
  HeldDirections held;
  SpinInertia inertia;
  Rows3<const double> w, w_before, moment, welded, tied;
  double dt_mean = 0, half_before = 0, half_after = 0;  // the latter: half steps before and after n

  /// L+ - L- of entry i of the held directions. half_before: 0 in the first step, of whose spins of free directions
  /// w_before is the mirror image.
  KOKKOS_INLINE_FUNCTION double find_gain(int i) const {
    const int n = held.node(i), k = held.direction(i);
    if (!inertia.has_tensor(n)) return inertia.number(n) * (w(n, k) - w_before(n, k));
    double before[3];
    for (int d = 0; d < 3; ++d) {
      const bool is_mirrored = half_before == 0 && inertia.inverse(n, d) > 0;
      before[d] = is_mirrored ? 0.5 * (w(n, d) + w_before(n, d)) : w_before(n, d);
    }
    const Vector3<double> gained = inertia.find_momentum(n, {w(n, 0), w(n, 1), w(n, 2)}, -half_after) -
                                   inertia.find_momentum(n, {before[0], before[1], before[2]}, half_before);
    return get(gained, k);
  }
  /// The part of it that others than elements and the condition give.
  KOKKOS_INLINE_FUNCTION double find_others(int i) const {
    const int n = held.node(i), k = held.direction(i);
    return find_joined(welded, n, k) + find_joined(tied, n, k);
  }
  /// J of entry i [force x length x time].
  KOKKOS_INLINE_FUNCTION double operator()(int i) const {
    return find_gain(i) - dt_mean * moment(held.node(i), held.direction(i)) - find_others(i);
  }
};

inline HeldMoments find_held_moments(const State& state, double dt_mean) {
  const double last_dt = state.turning_nodes(0).last_dt;
  return {state.held_spins,  state.spin_inertia(), state.w, state.w_before, state.moment,
          state.weld_moment, state.tie_moment,     dt_mean, 0.5 * last_dt,  dt_mean - 0.5 * last_dt};
}

}  // namespace percuss
