#pragma once
// The pyramid of five corners: four of its base, counter-clockwise seen from the apex, then the apex.

#include "src/mesh/topology/topology.hpp"

namespace percuss {

/// The apex has the three edges of one of the tetrahedra that it makes with three corners of the base. Its share of the
/// mass is that of the volume which is nearest to it, about.
inline constexpr Topology pyramid5_topology{
    .name = "pyramid5",
    .noun = "pyramid",
    .how_many = "five",
    .family = ElementFamily::pyramids,
    .dimension = 3,
    .corner_count = 5,
    .face_count = 5,
    .edge_count = 8,
    .face_table = {make_face(0, 1, 4, 4), make_face(1, 2, 4, 4), make_face(2, 3, 4, 4), make_face(0, 4, 3, 3),
                   make_face(0, 3, 2, 1)},
    .edge_table = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}},
    .corner_edges = {{{1, 3, 4}, {2, 0, 4}, {3, 1, 4}, {0, 2, 4}, {2, 1, 0}}},
    .kernel_corners = {0, 1, 2, 3, 4, 4, 0, 2},
    .mass_eighths = {1.5, 1.5, 1.5, 1.5, 2},
    .vtk_type = 14,
    .xdmf_type = 7,
    .xdmf_name = "Pyramid",
    .exodus_names = {"PYR"},
    .exodus_sides = {0, 1, 2, 3, 4},
    .abaqus_names = {"C3D5"},
    .nastran_names = {"CPYRAM", "CPYRA"},
};

}  // namespace percuss
