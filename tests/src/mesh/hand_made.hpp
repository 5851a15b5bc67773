#pragma once
// Meshes that tests make by hand: elements one by one, a block for each topology.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "src/mesh/topology/elements.hpp"

namespace percuss::testing_mesh {

inline void add_element(Elements& elements, TopologyKind kind, std::initializer_list<int> nodes, int part = 0) {
  const auto found = std::find_if(elements.blocks.begin(), elements.blocks.end(), [&](const ElementBlock& block) {
    return block.topology == kind && block.part == part;
  });
  const int block = static_cast<int>(found - elements.blocks.begin());
  if (found == elements.blocks.end()) {
    elements.blocks.emplace_back();
    elements.blocks.back().topology = kind;
    elements.blocks.back().part = part;
  }
  elements.add(block, nodes);
}

/// The corners of an element, to be compared with others.
inline std::vector<int> list_corners(const Elements& elements, std::size_t element) {
  return {elements.corners(element).begin(), elements.corners(element).end()};
}

/// [elements] the part of each.
inline std::vector<int> list_parts(const Elements& elements) {
  std::vector<int> parts;
  for (std::size_t e = 0; e < elements.size(); ++e) parts.push_back(elements.block_of(e).part);
  return parts;
}

}  // namespace percuss::testing_mesh
