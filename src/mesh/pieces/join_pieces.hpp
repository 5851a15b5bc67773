#pragma once
// What joints of parts (src/mesh/parts/part_joints.hpp) mean for the pieces of a mesh.

#include "src/mesh/pieces/chunk_pieces.hpp"

namespace percuss {

/// Gives joined nodes their common key, id and place; the faces between joined parts are no longer exterior, bodies
/// that are joined become one, and each joined node gets all sets and parts that it is in, of whichever part. The
/// set of part p is called that of number (node sets of all parts) + p. Does nothing where no parts are joined.
/// Collective. Throws MpiError.
void join_pieces(const Communicator& ranks, const SceneParts& scene, ChunkPieces& pieces);

}  // namespace percuss
