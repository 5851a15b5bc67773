#pragma once
// The shell of three corners. Where four are wanted the third stands twice.

#include "src/mesh/topology/quad4.hpp"
#include "src/mesh/topology/topology.hpp"

namespace percuss {

inline constexpr Topology tri3_topology{
    .name = "tri3",
    .noun = "shell",
    .how_many = "three",
    .family = ElementFamily::shells,
    .dimension = 2,
    .corner_count = 3,
    .face_count = 2,
    .edge_count = 3,
    .face_table = {make_face(0, 2, 2, 1), make_face(0, 1, 2, 2)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 0}}},
    .kernel_corners = {0, 1, 2, 2, 0, 1, 2, 2},
    .vtk_type = 5,
    .xdmf_type = 4,
    .xdmf_name = "Triangle",
    .exodus_names = {"SHELL", "TRI"},
    .exodus_sides = {top_face, bottom_face},
    .abaqus_names = {"S3", "S3R"},
    .nastran_names = {"CTRIA3", "CTRIAR"},
};

}  // namespace percuss
