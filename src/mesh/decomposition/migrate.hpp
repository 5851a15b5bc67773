#pragma once
// Chunks go to the ranks that will hold them.

#include "comm/communicator.hpp"
#include "src/mesh/ordering.hpp"
#include "src/mesh/pieces/chunk_pieces.hpp"

namespace percuss {

/// Sends every chunk of the pieces to its rank (numbering.ranks) and puts together what arrives: chunks, elements and
/// nodes of this rank in ascending global number, sets by their full names, parts, corners, ids, bodies, exterior
/// faces. numbers: [nodes of the pieces] global. Collective. Throws MpiError.
ChunkedMesh migrate_chunks(const Communicator& ranks, const SceneParts& scene, Numbering numbering,
                           const ChunkPieces& pieces, const std::vector<std::int64_t>& numbers);

}  // namespace percuss
