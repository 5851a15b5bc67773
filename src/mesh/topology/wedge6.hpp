#pragma once
// The wedge of six corners: three of one triangle, counter-clockwise seen from the other, then those across.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

inline constexpr Topology wedge6_topology{
    .name = "wedge6",
    .noun = "wedge",
    .how_many = "six",
    .family = ElementFamily::wedges,
    .dimension = 3,
    .corner_count = 6,
    .face_count = 5,
    .edge_count = 9,
    .face_table = {make_face(0, 1, 4, 3), make_face(1, 2, 5, 4), make_face(0, 3, 5, 2), make_face(0, 2, 1, 1),
                   make_face(3, 4, 5, 5)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
    .corner_edges = {{{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}}},
    .kernel_corners = {0, 1, 2, 3, 4, 5, 0, 5},
    .vtk_type = 13,
    .vtk_corners = {0, 2, 1, 3, 5, 4},
    .xdmf_type = 8,
    .xdmf_name = "Wedge",
    .exodus_names = {"WEDGE"},
    .exodus_sides = {0, 1, 2, 3, 4},
    .abaqus_names = {"C3D6", "C3D6R"},
    .nastran_names = {"CPENTA"},
};

}  // namespace percuss
