#pragma once
// What a restart compares of the mesh: everything that was read of it, piece by piece, so that a message can name what
// has changed.

#include <string>
#include <vector>

#include "src/mesh/ordering.hpp"

namespace percuss {

/// A line each, "HASH COUNT what": nodes with their ids and places; the elements of each block with their ids, corners,
/// thicknesses and section; each node set and side set (element sets are among these) by its name; each file of
/// `start.fields`. The same for any number of ranks. Collective. Throws InputError, SystemError, the same on all ranks,
/// where such a file cannot be read.
std::vector<std::string> list_mesh_pieces(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks);

/// 16 hexadecimal digits of all of them.
std::string hash_mesh_pieces(const std::vector<std::string>& pieces);

/// Differences, a text each: "node set 'p/held' has other members (4)".
std::vector<std::string> compare_mesh_pieces(const std::vector<std::string>& now,
                                             const std::vector<std::string>& checkpoint);

}  // namespace percuss
