#include "tests/verification/contact/closest_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss::test {
namespace {

struct Surface {
  std::vector<std::array<Point3, 4>> faces;  // exterior
  std::vector<int> face_body;
  std::vector<std::array<Point3, 8>> elements;
  std::vector<int> element_body;
  double edge = std::numeric_limits<double>::infinity();
};

Surface list_surface(const ChunkedMesh& chunked, const Rows3<double>& places) {
  const Mesh& mesh = chunked.mesh;
  const auto x = to_host(places);
  Surface surface;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    std::array<Point3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto n = static_cast<std::size_t>(mesh.corners(e)[i]);
      corners[i] = {x(n, 0), x(n, 1), x(n, 2)};
      for (const int other : hex8_topology.corner_edges[i])
        surface.edge = std::min(
            surface.edge,
            find_distance(mesh.nodes[n],
                          mesh.nodes[static_cast<std::size_t>(mesh.corners(e)[static_cast<std::size_t>(other)])]));
    }
    surface.elements.push_back(corners);
    surface.element_body.push_back(mesh.bodies[e]);
    for (std::size_t f = 0; f < 6; ++f) {
      if ((mesh.exterior[e] >> f & 1) == 0) continue;
      std::array<Point3, 4> face;
      for (std::size_t i = 0; i < 4; ++i)
        face[i] = corners[static_cast<std::size_t>(hex8_topology.face_table[f].four[i])];
      surface.faces.push_back(face);
      surface.face_body.push_back(mesh.bodies[e]);
    }
  }
  return surface;
}

/// Inside all twelve planes of the two triangulations of each face, to round-off: exact for planar faces.
bool is_inside(const std::array<Point3, 8>& corners, const Point3& p) {
  for (const FaceCorners& hex_face : hex8_topology.faces()) {
    const std::array<int, 4>& face = hex_face.four;
    Point3 middle{}, normal{};
    for (int i = 0; i < 4; ++i) middle = middle + 0.25 * corners[static_cast<std::size_t>(face[i])];
    const auto corner = [&](int i) { return corners[static_cast<std::size_t>(face[i])]; };
    normal = cross(corner(2) - corner(0), corner(3) - corner(1));
    if (dot(p - middle, normal) > 0) return false;
  }
  return true;
}

/// Depth of a point of a body in all others; 0 outside.
double find_depth(const Surface& surface, int body, const Point3& p) {
  double deepest = 0;
  for (std::size_t e = 0; e < surface.elements.size(); ++e) {
    const int other = surface.element_body[e];
    if (other == body || !is_inside(surface.elements[e], p)) continue;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
      if (surface.face_body[f] != other) continue;
      FacePoints face;
      for (std::size_t i = 0; i < 4; ++i) face.corner[i] = surface.faces[f][i] - p;
      least = std::min(least, find_closest_point(face).distance);
    }
    deepest = std::max(deepest, least);
  }
  return deepest;
}

}  // namespace

double find_closest_depth(const ChunkedMesh& chunked, const Rows3<double>& x) {
  const Surface surface = list_surface(chunked, x);
  constexpr int points = 4;  // of an edge
  double deepest = 0;
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (std::size_t i = 0; i < 4; ++i)
      for (int k = 0; k < points; ++k) {
        const double s = static_cast<double>(k) / points;
        const Point3 p = (1 - s) * surface.faces[f][i] + s * surface.faces[f][(i + 1) % 4];
        deepest = std::max(deepest, find_depth(surface, surface.face_body[f], p));
      }
  return deepest / surface.edge;
}

}  // namespace percuss::test
