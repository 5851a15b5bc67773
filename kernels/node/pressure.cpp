#include "kernels/node/pressure.hpp"

#include "kernels/core/tensor.hpp"

namespace percuss {

namespace {

/// What a corner takes of the load of a face, over a quarter: 1; of a triangle, a corner of which stands twice, a third
/// of it for each node.
KOKKOS_INLINE_FUNCTION double find_corner_part(const Rows4<const int>& nodes, int face, int corner) {
  bool triangle = false;
  for (int i = 0; i < 4; ++i) triangle = triangle || nodes(face, i) == nodes(face, (i + 1) % 4);
  if (!triangle) return 1;
  const int n = nodes(face, corner);
  const bool twice = n == nodes(face, (corner + 1) % 4) || n == nodes(face, (corner + 3) % 4);
  return twice ? 2.0 / 3 : 4.0 / 3;
}

}  // namespace

void apply_pressure(const ExecSpace& space, const PressureFaces& faces, const Array<const double>& pressure,
                    const Rows3<const double>& x, const Rows3<double>& slot_force) {
  if (faces.count == 0) return;
  Kokkos::parallel_for(
      "percuss::apply_pressure", Range(space, 0, faces.count), KOKKOS_LAMBDA(const int f) {
        Vector3<double> corner[4];
        for (int i = 0; i < 4; ++i) {
          const int n = faces.nodes(f, i);
          corner[i] = {x(n, 0), x(n, 1), x(n, 2)};
        }
        const double p = (faces.share.extent(0) == 0 ? 1.0 : faces.share(f)) * pressure(faces.load(f));
        const Vector3<double> dead{faces.dead_share(f, 0), faces.dead_share(f, 1), faces.dead_share(f, 2)};
        const bool follows = dead.x == 0 && dead.y == 0 && dead.z == 0;
        const Vector3<double> twice_area = cross(corner[2] - corner[0], corner[3] - corner[1]);
        const Vector3<double> share = follows ? (-0.125 * p) * twice_area : p * dead;
        for (int i = 0; i < 4; ++i) {
          const int s = faces.first_slot + 4 * f + i;
          const double part = find_corner_part(faces.nodes, f, i);
          slot_force(s, 0) = part * share.x;
          slot_force(s, 1) = part * share.y;
          slot_force(s, 2) = part * share.z;
        }
      });
}

}  // namespace percuss
