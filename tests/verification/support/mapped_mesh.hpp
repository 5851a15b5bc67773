#pragma once
// Meshes for whole runs and linear models: a lattice of hexahedra, each node put where a function says, and the quarter
// of a cylinder.

#include <functional>
#include <vector>

#include "src/mesh/shapes/rounded_lattice.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::test {

/// Cells in three directions on the unit cube; `place` maps it to space. One block of id 1, "body".
testing_mesh::WrittenMesh make_mapped_box(const std::array<int, 3>& cells,
                                          const std::function<Vec3(const Vec3&)>& place);

/// Adds a node set of all nodes for which `holds` is true.
void add_node_set(testing_mesh::WrittenMesh& mesh, int id, const char* name,
                  const std::function<bool(const Vec3&)>& holds);

/// Cuts each hexahedron of the mesh into twelve tetrahedra, as percuss cuts generated shapes. Sets of nodes stay.
void cut_into_tetrahedra(testing_mesh::WrittenMesh& mesh);

/// Cuts each hexahedron of the mesh into two wedges along its third direction.
void cut_into_wedges(testing_mesh::WrittenMesh& mesh);

/// A quarter of a cylinder along z, between the planes x = 0 and y = 0: 3 n^2 elements a section, `along` sections.
/// Nodes lie as in a generated cylinder of 4 n cells across, or with a core of another form. Sets "foot" (z = 0),
/// "x_plane" (x = 0), "y_plane".
testing_mesh::WrittenMesh make_quarter_cylinder(double radius, double length, int n, int along);
testing_mesh::WrittenMesh make_quarter_cylinder(double radius, double length, int n, int along, CoreForm form);

}  // namespace percuss::test
