#pragma once
// The area of the contact surface that belongs to a node: a quarter of each quadrilateral around it, a third of each
// triangle.

#include "kernels/contact/geometry/point3.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// The share of each of its corners in the area vector of a face, outward. The vector of a bilinear face is half the
/// cross product of its diagonals; a triangle has one corner twice.
KOKKOS_INLINE_FUNCTION Point3 find_corner_area(const Point3 (&corner)[4], bool is_triangle) {
  const double share = is_triangle ? 1.0 / 3 : 0.25;
  return (0.5 * share) * cross(corner[2] - corner[0], corner[3] - corner[1]);
}

/// Faces around contact nodes, with the share of a corner in the area vector of each, in a memory.
template <class Memory>
struct NodeFacesIn {
  Kokkos::View<const int*, Kokkos::LayoutRight, Memory> first;         // [nodes + 1] into faces
  Kokkos::View<const int*, Kokkos::LayoutRight, Memory> faces;         // around each node
  Kokkos::View<const double* [3], Kokkos::LayoutRight, Memory> areas;  // [faces] find_corner_area() [area]

  /// Area of node i that faces against a direction: the sum of what the faces around it show to one who looks along it.
  /// Faces that are turned away by more than 60 degrees, such as the sides at the foot of a block, are left out.
  KOKKOS_INLINE_FUNCTION double find_area(int i, const Point3& direction) const {
    constexpr double least_cosine = 0.5;
    double area = 0;
    for (int k = first(i); k < first(i + 1); ++k) {
      const Point3 a = load_row(areas, faces(k));
      const double shown = -dot(a, direction);
      if (shown > least_cosine * std::sqrt(dot(a, a))) area += shown;
    }
    return area;
  }
};
using NodeFaces = NodeFacesIn<MemSpace>;
using HostNodeFaces = NodeFacesIn<HostMirror<Array<int>>::memory_space>;

/// Impulse of a node over the area that it acts on [stress x time]; 0 where there is no such area.
template <class Memory>
KOKKOS_INLINE_FUNCTION double find_press(const NodeFacesIn<Memory>& around, int i, const Point3& impulse,
                                         double& area) {
  const double size = std::sqrt(dot(impulse, impulse));
  area = size > 0 ? around.find_area(i, (1 / size) * impulse) : 0;
  return area > 0 ? size / area : 0;
}

}  // namespace percuss
