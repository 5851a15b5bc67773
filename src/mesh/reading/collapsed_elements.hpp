#pragma once
// Hexahedra of a file that are wedges, pyramids or tetrahedra: what they become, and which face a side of theirs is.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "src/mesh/topology/collapsed_hexahedron.hpp"
#include "src/mesh/topology/elements.hpp"

namespace percuss {

class CollapsedElements {
 public:
  /// Kind of element that a hexahedron becomes in the part; nodes: of the file, in and out. One with nodes that stand
  /// twice in a way that makes no other solid stays as it is, and is refused later.
  TopologyKind collapse(int element, std::vector<int>& nodes) {
    const std::vector<std::int64_t> ids(nodes.begin(), nodes.end());
    std::vector<std::int64_t> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return TopologyKind::hex8;
    const auto solid = collapse_hexahedron(ids);
    if (!solid) return TopologyKind::hex8;
    before_[element] = nodes;
    nodes.assign(solid->nodes.begin(), solid->nodes.end());
    return solid->kind;
  }

  bool has(int element) const { return before_.contains(element); }

  /// The face that a face of the hexahedron became; -1: it has no area. to_part: nodes of the part by those of the
  /// file.
  int find_face(const Elements& elements, int element, int face, const std::vector<int>& to_part) const {
    const std::vector<int>& nodes = before_.at(element);
    std::vector<int> wanted;
    for (const int corner : hex8_topology.face_table[static_cast<std::size_t>(face)].corners())
      wanted.push_back(to_part[static_cast<std::size_t>(nodes[static_cast<std::size_t>(corner)])]);
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    const int count = elements.topology_of(static_cast<std::size_t>(element)).face_count;
    for (int f = 0; f < count && wanted.size() >= 3; ++f) {
      const std::array<int, 4> key = elements.face_key({element, f});
      const bool is_triangle = key[3] == std::numeric_limits<int>::max();
      if (is_triangle == (wanted.size() == 3) && std::equal(wanted.begin(), wanted.end(), key.begin())) return f;
    }
    return -1;
  }

 private:
  std::map<int, std::vector<int>> before_;  // by element of the part: nodes of the hexahedron in the file
};

}  // namespace percuss
