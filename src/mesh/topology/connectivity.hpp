#pragma once
// What the connectivity of a whole part says: exterior faces and bodies. Generated parts know both without it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/mesh/topology/elements.hpp"

namespace percuss {

/// [elements] bit f: face f belongs to no other element; of a surface element both.
std::vector<std::uint8_t> mark_exterior_faces(const Elements& elements, std::size_t node_count);

/// [elements] number of the connected body (through shared nodes), counted from 0 by lowest element.
std::vector<int> find_bodies(const Elements& elements, std::size_t node_count);

}  // namespace percuss
