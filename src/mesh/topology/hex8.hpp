#pragma once
// The hexahedron of eight corners: four of one face, counter-clockwise seen from the opposite one, then those across.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

inline constexpr Topology hex8_topology{
    .name = "hex8",
    .noun = "hexahedron",
    .how_many = "eight",
    .family = ElementFamily::hexahedra,
    .dimension = 3,
    .corner_count = 8,
    .face_count = 6,
    .edge_count = 12,
    .face_table = {make_face(0, 1, 5, 4), make_face(1, 2, 6, 5), make_face(2, 3, 7, 6), make_face(0, 4, 7, 3),
                   make_face(0, 3, 2, 1), make_face(4, 5, 6, 7)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
    .corner_edges = {{{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}},
    .kernel_corners = {0, 1, 2, 3, 4, 5, 6, 7},
    .vtk_type = 12,
    .xdmf_type = 9,
    .xdmf_name = "Hexahedron",
    .exodus_names = {"HEX"},
    .exodus_sides = {0, 1, 2, 3, 4, 5},
    .abaqus_names = {"C3D8", "C3D8R"},
    .nastran_names = {"CHEXA"},
};

}  // namespace percuss
