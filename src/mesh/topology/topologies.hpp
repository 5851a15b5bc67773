#pragma once
// All topologies: the list that readers, writers and checks go through.

#include "src/mesh/topology/hex8.hpp"
#include "src/mesh/topology/line2.hpp"
#include "src/mesh/topology/pyramid5.hpp"
#include "src/mesh/topology/quad4.hpp"
#include "src/mesh/topology/tet4.hpp"
#include "src/mesh/topology/tri3.hpp"
#include "src/mesh/topology/wedge6.hpp"

namespace percuss {

/// Kinds of topologies, in the order of `topologies`.
enum class TopologyKind : std::uint8_t { hex8, quad4, tri3, tet4, line2, wedge6, pyramid5 };

inline constexpr std::array topologies{hex8_topology,  quad4_topology,  tri3_topology,    tet4_topology,
                                       line2_topology, wedge6_topology, pyramid5_topology};
inline constexpr std::size_t topology_count = topologies.size();

constexpr const Topology& find_topology(TopologyKind kind) { return topologies[static_cast<std::size_t>(kind)]; }

/// Number of a face in the whole mesh, and back.
constexpr std::int64_t find_face_number(std::int64_t element, int face) {
  return static_cast<std::int64_t>(most_faces) * element + face;
}
constexpr std::int64_t find_element_of_face(std::int64_t face_number) {
  return face_number / static_cast<std::int64_t>(most_faces);
}

}  // namespace percuss
