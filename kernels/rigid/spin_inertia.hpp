#pragma once
// Rotary inertia of nodes: a number that holds for any axis, and of nodes of beams a tensor besides.
//
// Nodes of shells have one number. A beam is slender: about its axis it has the polar inertia of its section, across it
// much more (docs/theory_line_elements.md). The tensor is what the nodes have beyond the number. Such a node is a small
// rigid body: it keeps its angular momentum as it turns, and its energy.

#include "kernels/core/tensor.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// xx, yy, zz, xy, yz, zx of each row.
using TensorRows = Kokkos::View<double* [6], Kokkos::LayoutRight, MemSpace>;

/// The tensors of nodes that have one; empty: none has.
struct SpinTensors {
  Array<int> node;    // [rows] mesh node, ascending
  Array<int> row;     // [nodes] -1: the number alone
  TensorRows excess;  // [rows] beyond the number, at n

  bool any() const { return node.extent(0) > 0; }
};

KOKKOS_INLINE_FUNCTION Symmetric3<double> load_tensor(const TensorRows& rows, int i) {
  return {rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3), rows(i, 4), rows(i, 5)};
}

KOKKOS_INLINE_FUNCTION void store_tensor(const Symmetric3<double>& a, const TensorRows& rows, int i) {
  rows(i, 0) = a.xx;
  rows(i, 1) = a.yy;
  rows(i, 2) = a.zz;
  rows(i, 3) = a.xy;
  rows(i, 4) = a.yz;
  rows(i, 5) = a.zx;
}

/// Both together, as sums over nodes see them.
struct SpinInertia {
  Array<double> number;   // [nodes] 0: the node has no rotation
  Rows3<double> inverse;  // [nodes] of the number; 0 in held directions
  SpinTensors tensors{};

  KOKKOS_INLINE_FUNCTION bool has_tensor(int n) const { return tensors.row.extent(0) > 0 && tensors.row(n) >= 0; }

  KOKKOS_INLINE_FUNCTION Symmetric3<double> find_tensor(int n) const {
    const double i = number(n);
    return load_tensor(tensors.excess, tensors.row(n)) + Symmetric3<double>{i, i, i, 0, 0, 0};
  }

  /// Angular momentum at a spin. By component of the number alone where there is no tensor. half: half of the step over
  /// which the spin brought the tensor to its place at n; negative for a spin that takes it from there.
  KOKKOS_INLINE_FUNCTION Vector3<double> find_momentum(int n, const Vector3<double>& spin, double half = 0) const {
    const double i = number(n);
    const Vector3<double> momentum{i * spin.x, i * spin.y, i * spin.z};
    if (!has_tensor(n)) return momentum;
    const Vector3<double> whole = momentum + load_tensor(tensors.excess, tensors.row(n)) * spin;
    if (half == 0) return whole;
    return (1 / (1 + half * half * dot(spin, spin))) * (whole - half * cross(spin, whole));
  }

  /// Change of the spin that a moment impulse causes in the directions that are free.
  KOKKOS_INLINE_FUNCTION Vector3<double> find_change(int n, const Vector3<double>& moment) const;
};

/// The solution of a u = b in the directions that are free; 0 in the others. a: of a node that has a rotation.
KOKKOS_INLINE_FUNCTION Vector3<double> solve_free(Symmetric3<double> a, Vector3<double> b, const bool (&held)[3]) {
  // With the held rows and columns those of the unit matrix the solution is 0 there.
  if (held[0]) a.xx = 1, a.xy = a.zx = 0, b.x = 0;
  if (held[1]) a.yy = 1, a.xy = a.yz = 0, b.y = 0;
  if (held[2]) a.zz = 1, a.yz = a.zx = 0, b.z = 0;
  return solve(a, b);
}

KOKKOS_INLINE_FUNCTION Vector3<double> SpinInertia::find_change(int n, const Vector3<double>& moment) const {
  if (!has_tensor(n)) return {inverse(n, 0) * moment.x, inverse(n, 1) * moment.y, inverse(n, 2) * moment.z};
  const bool held[3] = {!(inverse(n, 0) > 0), !(inverse(n, 1) > 0), !(inverse(n, 2) > 0)};
  if (held[0] && held[1] && held[2]) return {0, 0, 0};
  return solve_free(find_tensor(n), moment, held);
}

/// Spins of nodes in a step from n: w(n-1/2), w(n+1/2) and the assembled moments at n; the steps before n and after it.
struct TurningNodes {
  Rows3<double> before, spin;
  Rows3<const double> moment;
  double last_dt = 0, dt = 0;  // last_dt: 0 in the first step, whose w is that of time 0
};

/// w(n+1/2) of nodes with a tensor as moments and elements alone would have it, in place of what predict_velocities()
/// made of the number: each turns as a rigid body (rigid_motion.hpp), whose momentum the moments change.
void predict_tensor_spins(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes);

/// For nodes whose spin is held in some directions, adds the change that the held motion causes in the others, whose
/// momentum stays.
void follow_held_spins(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes);

/// What damping has taken of the momentum of nodes with a tensor, whose spins are those after it: the difference of
/// both momenta. impulse: in, of the number; out, of both.
void complete_damping(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes,
                      const Rows3<double>& impulse);

/// Turns the tensors from n to n+1, as their nodes turn.
void turn_tensors(const ExecSpace& space, const SpinInertia& inertia, const TurningNodes& nodes);

}  // namespace percuss
