#pragma once
// The mesh of a scene as the ranks hold it: whole chunks to ranks (section 3 of the paper).

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"

namespace percuss {

/// Makes the mesh of the deck and divides its chunks over the ranks, equal in cost and with few shared nodes. Returns
/// this rank's share: its chunks and elements in ascending global number, the nodes they use in ascending global number
/// (also those that belong to chunks of other ranks), of the sets what lies in the share. Parts are known to all ranks,
/// warnings to rank 0. The same mesh, numbers included, for any number of ranks. Collective; throws what
/// build_mesh() throws, on every rank the same.
ChunkedMesh load_mesh(const Deck& deck, const Communicator& ranks);

}  // namespace percuss
