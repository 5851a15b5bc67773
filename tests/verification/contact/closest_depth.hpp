#pragma once
// How deep bodies of hexahedra are inside one another, by geometry alone: nothing of the contact code is asked.

#include "kernels/core/views.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss::test {

/// The deepest point of the surface of one body inside another, as its distance from the other's surface / shortest
/// edge of the mesh at time 0. Looks at nodes and at points on the edges of exterior faces.
double find_closest_depth(const ChunkedMesh& chunked, const Rows3<double>& x);

}  // namespace percuss::test
