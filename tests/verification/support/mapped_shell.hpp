#pragma once
// Meshes of shells for whole runs: a lattice of quadrilaterals, each node put where a function says.

#include <array>
#include <functional>

#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::test {

/// Cells in two directions on the unit square; `place` maps it to space. One block of id 1, "surface"; normals are
/// along the cross product of the two directions. Node (i, j) has the id 1 + i + (cells[0] + 1) j.
testing_mesh::WrittenMesh make_mapped_shell(const std::array<int, 2>& cells,
                                            const std::function<Vec3(double, double)>& place);

/// The map with the nodes inside the square moved at random, by up to a share of a cell either way in both directions;
/// for one mesh, whose nodes are placed one after the other.
std::function<Vec3(double, double)> distort(const std::array<int, 2>& cells, double share,
                                            const std::function<Vec3(double, double)>& place);

/// A quarter (x, y >= 0) of the unit disc: a core of n x n cells and n rings around it. `place` maps it to space. Node
/// sets "x_min" and "y_min" on the axes, "rim"; the node in the middle has the id 1.
testing_mesh::WrittenMesh make_quarter_disc(int n, const std::function<Vec3(double, double)>& place);

/// How the quadrilaterals of a lattice become triangles: all of them, cut the same way or by turns, as a block of kind
/// TRI3; or every other one, as a block of kind SHELL4 in which the halves name a corner twice, at any place.
enum class Halving { one_way, alternating, every_other };

/// Halves elements of the block of make_mapped_shell(); `row`: cells in the first direction.
void halve(int row, Halving halving, testing_mesh::WrittenMesh& mesh);

/// The sides of the square as node sets "u_min", "u_max", "v_min", "v_max".
void add_edge_sets(const std::array<int, 2>& cells, testing_mesh::WrittenMesh& mesh);

}  // namespace percuss::test
