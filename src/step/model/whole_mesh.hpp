#pragma once
// Nodes and elements of the whole mesh, and who has them.

#include <cstdint>
#include <string>

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// The ranks that hold the mesh together; this one alone if it holds it all.
Communicator find_ranks(const Mesh& mesh);

/// Whether this rank counts a node of its share in sums over all nodes.
bool owns_node(const ChunkedMesh& chunked, int node);

/// Number of an element of this rank in the whole mesh.
std::int64_t find_element_number(const ChunkedMesh& chunked, int element);

/// Index of a node (element) of the whole mesh in this rank's share; -1 if it is not there.
int find_local_node(const ChunkedMesh& chunked, std::int64_t number);
int find_local_element(const ChunkedMesh& chunked, std::int64_t number);

/// The user's id of a node of the whole mesh, which messages name. Collective. Throws MpiError.
std::int64_t find_node_id(const ChunkedMesh& chunked, std::int64_t number);

/// "element 7 of part 'bar'", of an element of this rank.
std::string name_element(const Mesh& mesh, int element);

}  // namespace percuss
