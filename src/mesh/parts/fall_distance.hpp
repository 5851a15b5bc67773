#pragma once
// How far bodies fall along a direction until they touch something.

#include <array>
#include <optional>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// A node and half the thickness of its shells, 0 of solids [length].
struct FallingNode {
  Vec3 place{};
  double half_thickness = 0;
};

/// A triangle of the surface of a body.
struct FallingTriangle {
  std::array<Vec3, 3> corners{};
  double half_thickness = 0;
};

/// Way along the unit direction until the first node is `clearance` away from the wall, whose `thickness` says whether
/// shells are thick for it; negative: back. As if all came from far against the direction. None: no node meets it.
std::optional<double> find_fall_to_wall(const WallDeck& wall, const std::vector<FallingNode>& nodes,
                                        const Vec3& direction, double clearance);

/// Way along the unit direction until a triangle of one body touches one of the other, as if the first came from far
/// against the direction: exact for points on triangles and for crossing edges. Thicknesses count along the common
/// normal. None: they pass each other.
std::optional<double> find_fall_to_body(const std::vector<FallingTriangle>& falling,
                                        const std::vector<FallingTriangle>& still, const Vec3& direction);

}  // namespace percuss
