#pragma once
// Where in an element a place of space is: the weights of its corners, by the shape functions of the hexahedron with
// repeated corners, or of the middle surface of a shell.

#include <array>

#include "src/mesh/hex_geometry.hpp"

namespace percuss {

struct MaterialPlace {
  std::array<double, kernel_corner_count> weights{};  // sum to 1
  double distance = 0;                                // from the place to the point that they give [length]
};

/// The point of an element that is nearest to a place. x: its corners; is_shell: the first four are those of a shell.
MaterialPlace find_material_place(const ElementCorners& x, bool is_shell, const Vec3& place);

}  // namespace percuss
