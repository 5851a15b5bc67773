#pragma once
// The shell of four corners, around its normal. Its surfaces are its faces: the bottom, and the top, to which the
// normal points. Exodus counts the top first.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

/// The faces of every surface element.
inline constexpr int bottom_face = 0, top_face = 1;

inline constexpr Topology quad4_topology{
    .name = "quad4",
    .noun = "shell",
    .how_many = "four",
    .family = ElementFamily::shells,
    .dimension = 2,
    .corner_count = 4,
    .face_count = 2,
    .edge_count = 4,
    .face_table = {make_face(0, 3, 2, 1), make_face(0, 1, 2, 3)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
    .kernel_corners = {0, 1, 2, 3, 0, 1, 2, 3},
    .vtk_type = 9,
    .xdmf_type = 5,
    .xdmf_name = "Quadrilateral",
    .exodus_names = {"SHELL", "QUAD"},
    .exodus_sides = {top_face, bottom_face},
    .abaqus_names = {"S4", "S4R"},
    .nastran_names = {"CQUAD4", "CQUADR"},
};

}  // namespace percuss
