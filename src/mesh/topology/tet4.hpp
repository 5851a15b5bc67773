#pragma once
// The tetrahedron of four corners: three of one face, counter-clockwise seen from the fourth.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

inline constexpr Topology tet4_topology{
    .name = "tet4",
    .noun = "tetrahedron",
    .how_many = "four",
    .family = ElementFamily::tetrahedra,
    .dimension = 3,
    .corner_count = 4,
    .face_count = 4,
    .edge_count = 6,
    .face_table = {make_face(0, 1, 3, 3), make_face(1, 2, 3, 3), make_face(0, 3, 2, 2), make_face(0, 2, 1, 1)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
    .corner_edges = {{{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}}},
    .kernel_corners = {0, 1, 2, 3, 0, 1, 2, 3},
    .vtk_type = 10,
    .xdmf_type = 6,
    .xdmf_name = "Tetrahedron",
    .exodus_names = {"TET"},
    .exodus_sides = {0, 1, 2, 3},
    .abaqus_names = {"C3D4"},
    .nastran_names = {"CTETRA"},
};

}  // namespace percuss
