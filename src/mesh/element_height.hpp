#pragma once
// How thin an element is.

#include <cmath>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {

/// Across the thinnest direction of an element, to which the stable step is proportional [length]: the edge of a cube
/// or a square, the height of a triangle, the length of a beam.
inline double find_element_height(const Topology& topology, const ElementCorners& x) {
  const auto place = [&](int corner) { return x[static_cast<std::size_t>(corner)]; };
  if (topology.is_line()) return find_distance(x[0], x[1]);
  if (topology.is_surface()) {
    double longest = 0;
    for (const auto& [a, b] : topology.edges()) longest = std::fmax(longest, find_distance(place(a), place(b)));
    return (topology.corner_count == 3 ? 2 : 1) * find_shell_area_size(x) / longest;
  }
  double largest = 0;
  for (const FaceCorners& face : topology.faces()) {
    const Vec3 twice =
        cross(subtract(place(face.four[2]), place(face.four[0])), subtract(place(face.four[3]), place(face.four[1])));
    largest = std::fmax(largest, 0.5 * std::sqrt(dot(twice, twice)));
  }
  return find_solid_volume(topology, x) / largest;
}

}  // namespace percuss
