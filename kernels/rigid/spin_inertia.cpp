#include "kernels/rigid/spin_inertia.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/rigid/rigid_motion.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION Vector3<double> load_spin(const Rows3<const double>& rows, int n) {
  return {rows(n, 0), rows(n, 1), rows(n, 2)};
}

KOKKOS_INLINE_FUNCTION void store_spin(const Rows3<double>& rows, int n, const Vector3<double>& a) {
  rows(n, 0) = a.x;
  rows(n, 1) = a.y;
  rows(n, 2) = a.z;
}

KOKKOS_INLINE_FUNCTION bool is_zero_vector(const Vector3<double>& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

/// Matrix of the rotation with Gibbs' vector tan(angle / 2).
KOKKOS_INLINE_FUNCTION Matrix3<double> find_turn_matrix(const Vector3<double>& gibbs) {
  return find_rotation(normalize(Orientation{1, gibbs.x, gibbs.y, gibbs.z}));
}

/// Calls visit(row, node) for all nodes with a tensor and a rotation.
template <class Visit>
void for_each_tensor(const char* label, const ExecSpace& space, const SpinInertia& inertia, const Visit& visit) {
  const SpinInertia of = inertia;
  parallel_for(
      label, RangeOf(space, 0, static_cast<int>(of.tensors.node.extent(0))), KOKKOS_LAMBDA(const int i) {
        const int n = of.tensors.node(i);
        if (of.number(n) > 0) visit(i, n);
      });
}

/// The spin over a step of dt with this momentum; held directions keep that of `now`.
KOKKOS_INLINE_FUNCTION Vector3<double> find_spin(const SpinInertia& inertia, int n, const Vector3<double>& momentum,
                                                 const Vector3<double>& now, double dt) {
  HeldSpin hold;
  for (int k = 0; k < 3; ++k) {
    hold.held[k] = !(inertia.inverse(n, k) > 0);
    hold.rate[k] = get(now, k);
  }
  if (hold.held[0] && hold.held[1] && hold.held[2]) return now;
  return (2 / dt) * find_turn(inertia.find_tensor(n), momentum, hold, dt);
}

}  // namespace

void predict_tensor_spins(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes) {
  const TurningNodes of = nodes;
  const double half = 0.5 * of.last_dt, dt_mean = 0.5 * (of.last_dt + of.dt);
  for_each_tensor("percuss::predict_tensor_spins", space, inertia, [=] KOKKOS_FUNCTION(int, int n) {
    const Vector3<double> moment = load_spin(of.moment, n), before = load_spin(of.before, n);
    if (is_zero_vector(moment) && is_zero_vector(before)) return;
    const Vector3<double> momentum = inertia.find_momentum(n, before, half) + dt_mean * moment;
    store_spin(of.spin, n, find_spin(inertia, n, momentum, before, of.dt));
  });
}

void follow_held_spins(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes) {
  const TurningNodes of = nodes;
  for_each_tensor("percuss::follow_held_spins", space, inertia, [=] KOKKOS_FUNCTION(int, int n) {
    const Vector3<double> spin = load_spin(of.spin, n), before = load_spin(of.before, n);
    Vector3<double> predicted = spin;
    bool is_forced = false;
    for (int k = 0; k < 3; ++k) {
      if (inertia.inverse(n, k) > 0) continue;
      set(predicted, k, get(before, k));
      is_forced = is_forced || get(before, k) != get(spin, k);
    }
    if (!is_forced) return;
    const Vector3<double> momentum = inertia.find_momentum(n, predicted, -0.5 * of.dt);
    store_spin(of.spin, n, find_spin(inertia, n, momentum, spin, of.dt));
  });
}

void complete_damping(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes,
                      const Rows3<double>& impulse) {
  const TurningNodes of = nodes;
  for_each_tensor("percuss::complete_damping", space, inertia, [=] KOKKOS_FUNCTION(int, int n) {
    const double half = -0.5 * of.dt;
    const Vector3<double> spin = load_spin(of.spin, n);
    const Vector3<double> before = spin - (1 / inertia.number(n)) * load_spin(impulse, n);
    const Vector3<double> whole = inertia.find_momentum(n, spin, half) - inertia.find_momentum(n, before, half);
    for (int k = 0; k < 3; ++k)
      if (inertia.inverse(n, k) > 0) impulse(n, k) = get(whole, k);
  });
}

void turn_tensors(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes) {
  const TurningNodes of = nodes;
  for_each_tensor("percuss::turn_tensors", space, inertia, [=] KOKKOS_FUNCTION(int i, int n) {
    const Vector3<double> spin = load_spin(of.spin, n);
    if (is_zero_vector(spin)) return;
    const TensorRows& rows = inertia.tensors.excess;
    store_tensor(push_forward(find_turn_matrix((0.5 * of.dt) * spin), load_tensor(rows, i)), rows, i);
  });
}

}  // namespace percuss
