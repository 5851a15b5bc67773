#pragma once
// Hexahedra with corners that have come together, as formats write wedges, pyramids and tetrahedra: judged by the faces
// that are left, whatever the order of the corners.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "src/mesh/topology/topologies.hpp"

namespace percuss {

/// A solid by the nodes of its corners, in the order of its topology.
struct SolidOfNodes {
  TopologyKind kind = TopologyKind::hex8;
  std::vector<std::int64_t> nodes;
};

/// Solid of a hexahedron with these nodes at its corners: a wedge where two parallel edges of a face are of no length,
/// a pyramid where a face is a point, a tetrahedron where an edge of the opposite face is of no length as well (that
/// face may also be bent about three of its corners, the fourth of which is the apex). None of these: nothing.
std::optional<SolidOfNodes> collapse_hexahedron(std::span<const std::int64_t> nodes);

}  // namespace percuss
