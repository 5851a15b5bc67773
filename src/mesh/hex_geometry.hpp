#pragma once
// Volume and corner Jacobians of a solid, area of a shell, length of a beam, centres.

#include <array>
#include <cmath>
#include <cstddef>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// Places of the corners of an element as kernels see it (Topology::kernel_corners).
using ElementCorners = std::array<Vec3, kernel_corner_count>;

/// place(node): where a node is.
template <class Place>
ElementCorners gather_corners(const Elements& elements, std::size_t element, const Place& place) {
  ElementCorners x;
  const auto nodes = elements.kernel_nodes(element);
  for (std::size_t i = 0; i < nodes.size(); ++i) x[i] = place(nodes[i]);
  return x;
}
inline ElementCorners gather_corners(const Elements& elements, std::size_t element, const std::vector<Vec3>& nodes) {
  return gather_corners(elements, element, [&](int n) { return nodes[static_cast<std::size_t>(n)]; });
}

/// Mean of these corners. Chunks are cut by it: its last bits set the numbers of elements.
inline Vec3 find_center(const ElementCorners& x) {
  Vec3 center{};
  for (const Vec3& corner : x) {
    for (std::size_t d = 0; d < 3; ++d) center[d] += 0.125 * corner[d];
  }
  return center;
}

inline Vec3 subtract(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double find_distance(const Vec3& a, const Vec3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double triple_product(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(a, cross(b, c)); }

inline Vec3 add(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Area vector of a shell, along its normal: half the cross product of its diagonals.
inline Vec3 find_shell_area(const ElementCorners& x) {
  const Vec3 twice = cross(subtract(x[2], x[0]), subtract(x[3], x[1]));
  return {0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2]};
}

/// Its size [length^2].
inline double find_shell_area_size(const ElementCorners& x) {
  const Vec3 area = find_shell_area(x);
  return std::sqrt(dot(area, area));
}

/// Exact volume of a solid with bilinear or flat faces [length^3]; of a hexahedron it equals the mean-quadrature volume
/// of Flanagan and Belytschko (1981, equation 14). By the divergence theorem: a bilinear face halves the tetrahedron of
/// its four corners, so its share is the mean of its two triangulations.
inline double find_solid_volume(const Topology& topology, const ElementCorners& x) {
  double volume = 0;
  for (const FaceCorners& face : topology.faces()) {
    const auto corner = [&](std::size_t i) { return subtract(x[static_cast<std::size_t>(face.four[i])], x[0]); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    volume += triple_product(a, b, add(c, d)) + triple_product(add(a, b), c, d);
  }
  return volume / 12;
}

/// Volume of an element at time 0 [length^3]: of a shell its area times its thickness, of a beam its length times that
/// of its cross section.
inline double find_element_volume(const Mesh& mesh, std::size_t element) {
  const ElementCorners x = gather_corners(mesh.elements, element, mesh.nodes);
  if (mesh.topology_of(element).is_surface()) return mesh.thickness_of(element) * find_shell_area_size(x);
  if (mesh.topology_of(element).is_line()) return mesh.block_of(element).section.area * find_distance(x[0], x[1]);
  return find_solid_volume(mesh.topology_of(element), x);
}

/// Size of an element with this volume at time 0 [length]: the edge of a cube of it, of a square of a shell's area, or
/// the length of a beam.
inline double find_element_size(const Mesh& mesh, std::size_t element, double volume) {
  const Topology& topology = mesh.topology_of(element);
  if (topology.is_surface()) return std::sqrt(volume / mesh.thickness_of(element));
  return topology.is_line() ? volume / mesh.block_of(element).section.area : std::cbrt(volume);
}

/// Jacobian at a corner: the triple product of its three edges [length^3], and that of their lengths for comparison.
struct CornerJacobian {
  double value = 0;
  double edge_product = 0;
};
inline CornerJacobian find_corner_jacobian(const Topology& topology, const ElementCorners& x, int corner) {
  const auto c = static_cast<std::size_t>(corner);
  const auto edge = [&](std::size_t i) {
    return subtract(x[static_cast<std::size_t>(topology.corner_edges[c][i])], x[c]);
  };
  const Vec3 p = edge(0), q = edge(1), r = edge(2);
  return {triple_product(p, q, r), std::sqrt(dot(p, p)) * std::sqrt(dot(q, q)) * std::sqrt(dot(r, r))};
}

}  // namespace percuss
