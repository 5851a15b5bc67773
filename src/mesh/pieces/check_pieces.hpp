#pragma once
// The checks of generated parts, each rank its own share, and one answer for all.

#include "src/mesh/pieces/chunk_pieces.hpp"

namespace percuss {

/// Checks the geometry of the generated parts and throws InputError, on every rank the same, with all that is wrong
/// with any part: what scene.parts say and what the ranks find, in the order of the deck, each line with its place
/// there and its part. Adds to the warnings of the parts on rank 0. Collective.
void check_pieces(const Deck& deck, const Communicator& ranks, const ChunkPieces& pieces, SceneParts& scene);

}  // namespace percuss
