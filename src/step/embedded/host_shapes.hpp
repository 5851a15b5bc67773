#pragma once
// Where a point lies within a solid: what the shape functions of its corners are there.

#include <array>
#include <optional>
#include <span>

#include "src/mesh/mesh.hpp"

namespace percuss {

struct HostPoint {
  std::array<double, most_corners> weights{};  // of the corners; their sum is 1, and they give the point
  double outside = 0;  // how far it is beyond the faces, as a share of the size of the solid; at most 0: within
};

/// Finds a point by the shape functions of hexahedra, wedges, pyramids and tetrahedra with straight edges. corners: as
/// many as the topology has. None: the point is far outside, or the solid has no volume there.
std::optional<HostPoint> find_host_point(TopologyKind kind, std::span<const Vec3> corners, const Vec3& place);

}  // namespace percuss
