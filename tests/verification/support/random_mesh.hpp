#pragma once
// A cube of hexahedra with random nodes, as an Exodus mesh.

#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::test {

struct RandomMesh {
  testing_mesh::WrittenMesh written;  // one block "body"; nodes within 1 m about the origin
  std::vector<bool> is_interior;      // by node
};

/// The cube of edge 1 about the origin, n elements a side. Each node is moved by up to `distortion` of an element's
/// edge in every direction: interior nodes always, those on the surface only along it.
RandomMesh make_random_mesh(int n, double distortion, unsigned long seed);

}  // namespace percuss::test
