#pragma once
// Mesh-quality warnings for a mesh from a file: a few elements that determine the step of the whole scene, and shells
// with reversed orientation. Generated parts have neither.

#include <cstddef>
#include <string>
#include <vector>

#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// Adds a warning if a few of the first `element_count` elements (one copy of the part) are far thinner than the median
/// of them, and one if shells have normals opposite to those of their neighbours; both name elements by the user's ids.
/// The shapes must have been checked.
void warn_of_doubts(const PartMesh& mesh, std::size_t element_count, std::vector<Warning>& warnings);

}  // namespace percuss
