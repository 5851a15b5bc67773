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

  /// The load of a corner that takes a quarter.
  KOKKOS_INLINE_FUNCTION Vector3<double> find_share(int f, double p, const Vector3<double> (&corner)[4]) const {
    const Vector3<double> dead{faces.dead_share(f, 0), faces.dead_share(f, 1), faces.dead_share(f, 2)};
    const bool follows = dead.x == 0 && dead.y == 0 && dead.z == 0;
    return follows ? (-0.125 * p) * cross(corner[2] - corner[0], corner[3] - corner[1]) : p * dead;
  }

  KOKKOS_FORCEINLINE_FUNCTION void press(int f, double (&sum)[PressureSum::count]) const {
    const int first = faces.first_slot + 4 * f;
    const double p = find_pressure(f);
    const Vector3<double> in_slot = read_row(slot_force, first);
    if (p == 0 && in_slot.x == 0 && in_slot.y == 0 && in_slot.z == 0) return;  // as before a blast arrives
    int node[4];
    for (int i = 0; i < 4; ++i) node[i] = faces.nodes(f, i);
    Vector3<double> corner[4];
    for (int i = 0; i < 4; ++i) corner[i] = read_row(nodes.x, node[i]);
    const Vector3<double> share = find_share(f, p, corner);
    double part[4] = {1, 1, 1, 1};
    if (has_repeated_corner(node))
      for (int i = 0; i < 4; ++i) part[i] = find_part_of_triangle(node, i);
    Vector3<double> place{0, 0, 0}, velocity{0, 0, 0};  // four times those of the load
    for (int i = 0; i < 4; ++i) {
      slot_force(first + i, 0) = part[i] * share.x;
      slot_force(first + i, 1) = part[i] * share.y;
      slot_force(first + i, 2) = part[i] * share.z;
      place = place + part[i] * corner[i];
      velocity = velocity + part[i] * read_row(nodes.v, node[i]);
    }
    const Vector3<double> arm = place - Vector3<double>{4 * nodes.center[0], 4 * nodes.center[1], 4 * nodes.center[2]};
    add(share, cross(arm, share), sum);
    sum[PressureSum::old_power] += dot(in_slot, velocity) / part[0];
    sum[PressureSum::power] += dot(share, velocity);
  }

  KOKKOS_INLINE_FUNCTION static void add(const Vector3<double>& share, const Vector3<double>& moment,
                                         double (&sum)[PressureSum::count]) {
    const double values[6] = {4 * share.x, 4 * share.y, 4 * share.z, moment.x, moment.y, moment.z};
    for (int k = 0; k < 6; ++k) sum[PressureSum::force + k] += values[k];
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
