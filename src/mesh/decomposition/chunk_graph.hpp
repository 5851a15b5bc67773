#pragma once
// The chunks of a scene, numbered, and the graph that their decomposition divides.

#include <cstdint>
#include <vector>

#include "comm/partition/graph_partition.hpp"
#include "src/mesh/numbering.hpp"
#include "src/mesh/pieces/chunk_pieces.hpp"

namespace percuss {

/// Work of a chunk on the scale of hexahedron_cost: its elements, and, in a scene with contact, its exterior faces,
/// which take part in the search. Faces weigh little because the contact work is divided otherwise and only what each
/// rank does for its own nodes and faces stays with it.
inline constexpr int contact_face_cost = 1;

/// Pieces whose nodes have their numbers in the whole mesh.
struct NumberedChunks {
  std::vector<std::int64_t> numbers;  // [nodes of the pieces]
  Numbering numbering;                // the same on every rank; no rank holds a chunk yet (no ranks)
  std::vector<std::int64_t> work;     // [chunks] of its elements, on the scale of hexahedron_cost; on every rank
  Graph graph;  // rank 0: a vertex a chunk, an edge where chunks share nodes or, with contact, lie next to each other
};

/// Gives every node to the lowest chunk that uses it and numbers the nodes of each chunk by first use; counts what
/// chunks share. pieces: every chunk of the scene on one rank. Collective. Throws MpiError.
NumberedChunks number_chunks(const Deck& deck, const Communicator& ranks, const SceneParts& scene,
                             const ChunkPieces& pieces);

}  // namespace percuss
