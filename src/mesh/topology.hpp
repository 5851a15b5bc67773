#pragma once
// What the connectivity of a whole part says: exterior faces and bodies. Generated parts know both without it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace percuss {

/// [elements] bit f: face f (row of hex_faces) belongs to no other element; of a shell both surfaces.
std::vector<std::uint8_t> mark_exterior_faces(const std::vector<std::array<int, 8>>& elements, std::size_t node_count);

/// [elements] number of the connected body (through shared nodes), counted from 0 by lowest element.
std::vector<int> find_bodies(const std::vector<std::array<int, 8>>& elements, std::size_t node_count);

}  // namespace percuss
