#pragma once
// The line of two nodes: beams and trusses. It has no faces.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

inline constexpr Topology line2_topology{
    .name = "line2",
    .noun = "beam",
    .how_many = "two",
    .family = ElementFamily::beams,
    .dimension = 1,
    .corner_count = 2,
    .face_count = 0,
    .edge_count = 1,
    .edge_table = {{{0, 1}}},
    .kernel_corners = {0, 1, 0, 1, 0, 1, 0, 1},
    .vtk_type = 3,
    .xdmf_type = 2,
    .xdmf_name = "Polyline",
    .exodus_names = {"BEAM", "BAR", "TRUSS", "ROD"},
    .abaqus_names = {"B31", "T3D2"},
    .nastran_names = {"CBAR", "CBEAM", "CROD", "CTUBE"},
};

}  // namespace percuss
