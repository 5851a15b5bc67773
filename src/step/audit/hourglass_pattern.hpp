#pragma once
// How much of the hourglass displacement of elements alternates from one to the next. A smooth field, such as bending
// or twist, has the same second derivatives in neighbours: where they meet, their hourglass displacements are opposite.
// In the pattern that elements of one point do not resist by themselves every second node moves alike, and the
// displacements of neighbours are equal where they meet.

#include <array>
#include <span>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// Displacement of the corners of an element besides a linear field.
struct HourglassDisplacement {
  std::array<Vec3, most_corners> of_corners{};
  double square = 0;  // sum over the corners [length^2]
};

/// Displacement in hourglass modes of a hexahedron or a shell of four corners: from its corners at the start and now.
/// Zero for every linear motion, such as a rotation, of an element of any shape. Of other elements zero.
HourglassDisplacement find_hourglass_displacement(const Topology& topology, std::span<const Vec3> start,
                                                  std::span<const Vec3> now);

/// Share of the hourglass motion that alternates, of each of some elements that lie side by side, 0 to 1; 1 without
/// neighbours among them. motions: [elements].
std::vector<double> find_alternating_shares(const Mesh& mesh, int first_element,
                                            const std::vector<HourglassDisplacement>& motions);

}  // namespace percuss
