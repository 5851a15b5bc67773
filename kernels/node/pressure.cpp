#include "kernels/node/pressure.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/core/tensor.hpp"

namespace percuss {

namespace {

/// Whether a corner stands twice.
KOKKOS_INLINE_FUNCTION bool has_repeated_corner(const int (&node)[4]) {
  return node[0] == node[1] || node[1] == node[2] || node[2] == node[3] || node[3] == node[0];
}

/// What a corner takes of the load of a triangle, over a quarter: a third of it for each node.
KOKKOS_INLINE_FUNCTION double find_part_of_triangle(const int (&node)[4], int corner) {
  const bool twice = node[corner] == node[(corner + 1) % 4] || node[corner] == node[(corner + 3) % 4];
  return twice ? 2.0 / 3 : 4.0 / 3;
}

KOKKOS_INLINE_FUNCTION Vector3<double> read_row(const Rows3<const double>& rows, int n) {
  return {rows(n, 0), rows(n, 1), rows(n, 2)};
}

/// Puts the load of a face into its slots and adds it to the sums of its run.
struct FacePresser {
  PressureFaces faces;
  Array<const double> pressure;
  PressedNodes nodes;
  Rows3<double> slot_force;

  KOKKOS_INLINE_FUNCTION double find_pressure(int f) const {
    return (faces.share.extent(0) == 0 ? 1.0 : faces.share(f)) * pressure(faces.load(f));
  }

  KOKKOS_FORCEINLINE_FUNCTION void press(int f, double (&sum)[PressureSum::count]) const {
    const int first = faces.first_slot + 4 * f;
    const double p = find_pressure(f);
    const Vector3<double> in_slot = read_row(slot_force, first);
    if (p == 0 && in_slot.x == 0 && in_slot.y == 0 && in_slot.z == 0) return;  // as before a blast arrives
    int node[4];
    for (int i = 0; i < 4; ++i) node[i] = faces.nodes(f, i);
    Vector3<double> corner[4], load[4];
    for (int i = 0; i < 4; ++i) corner[i] = read_row(nodes.x, node[i]);
    find_loads(f, p, node, corner, load);
    const Vector3<double> center{nodes.center[0], nodes.center[1], nodes.center[2]};
    for (int i = 0; i < 4; ++i) {
      const int slot = first + i;
      const Vector3<double> velocity = read_row(nodes.v, node[i]), moment = cross(corner[i] - center, load[i]);
      const double values[6] = {load[i].x, load[i].y, load[i].z, moment.x, moment.y, moment.z};
      for (int k = 0; k < 6; ++k) sum[PressureSum::force + k] += values[k];
      sum[PressureSum::old_power] += dot(read_row(slot_force, slot), velocity);
      sum[PressureSum::power] += dot(load[i], velocity);
      slot_force(slot, 0) = load[i].x;
      slot_force(slot, 1) = load[i].y;
      slot_force(slot, 2) = load[i].z;
    }
  }

  /// A follower load works against the exact gradient of the volume behind the face, as the pressure of an element
  /// does: with equal shares on a face that warps or tapers, the pressure of the air on water feeds its ripples.
  KOKKOS_INLINE_FUNCTION void find_loads(int f, double p, const int (&node)[4], const Vector3<double> (&corner)[4],
                                         Vector3<double> (&load)[4]) const {
    const Vector3<double> dead{faces.dead_share(f, 0), faces.dead_share(f, 1), faces.dead_share(f, 2)};
    const bool follows = dead.x == 0 && dead.y == 0 && dead.z == 0;
    const Vector3<double> one = corner[2] - corner[0], other = corner[3] - corner[1];  // diagonals
    const Vector3<double> share = follows ? (-0.125 * p) * cross(one, other) : p * dead;
    if (has_repeated_corner(node)) {
      for (int i = 0; i < 4; ++i) load[i] = find_part_of_triangle(node, i) * share;
      return;
    }
    for (int i = 0; i < 4; ++i) load[i] = share;
    if (!follows) return;
    const Vector3<double> along = one - other, across = one + other,
                          twist = corner[0] - corner[1] + corner[2] - corner[3];
    const Vector3<double> of_xi = (-p / 48) * cross(along, twist), of_eta = (-p / 48) * cross(twist, across);
    load[0] = load[0] - of_xi - of_eta;
    load[1] = load[1] + of_xi - of_eta;
    load[2] = load[2] + of_xi + of_eta;
    load[3] = load[3] - of_xi + of_eta;
  }
};

}  // namespace

void apply_pressure(const ExecSpace& space, const PressureFaces& faces, const Array<const double>& pressure,
                    const PressedNodes& nodes, const Rows3<double>& slot_force, const PressureSums& sums) {
  if (faces.count == 0) return;
  const FacePresser presser{faces, pressure, nodes, slot_force};
  parallel_for(
      "percuss::apply_pressure", RangeOf(space, 0, faces.run_count), KOKKOS_LAMBDA(const int r) {
        double sum[PressureSum::count] = {};
        const int end = presser.faces.first_of_run(r + 1);
        for (int f = presser.faces.first_of_run(r); f < end; ++f) presser.press(f, sum);
        for (int k = 0; k < PressureSum::count; ++k) sums(r, k) = sum[k];
      });
}

}  // namespace percuss
