#pragma once
// Coordinates of the nodes of an Exodus II file, read by netCDF itself. The Exodus library takes a variable
// whose number in the file is 0 for one that is not there, and leaves its coordinates 0 without an error.

#include <cstdint>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// [nodes] places, 0 in the directions from `dimensions` on, from coordx, coordy and coordz or, in files of the older
/// layout, from the rows of coord. file: as ex_open() returns it. Throws InputError, without the name of the file.
std::vector<Vec3> read_exodus_coordinates(int file, int dimensions, std::int64_t nodes);

}  // namespace percuss
