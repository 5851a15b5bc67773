#pragma once
// Cuts the elements into chunks and puts the mesh in chunk order. The last step of meshing: everything after it (the
// decomposition, the fixed order of every sum, what is skipped) counts in chunks.
//
// A chunk comes from the mesh alone, never from the number of ranks or threads, so that results do not depend on them.

#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/mesh/numbering.hpp"

namespace percuss {

/// Most elements a chunk has: enough to amortise a task, few enough that a chunk's state stays in the second-level
/// cache.
inline constexpr int max_chunk_elements = 64;

/// Cuts fall on multiples of this many elements, so that only the last pack of a part is partly empty (for any pack of
/// up to 16 lanes).
inline constexpr int chunk_granularity = 16;

/// A contiguous run of elements of one part.
struct Chunk {
  int first_element = 0;
  int element_count = 0;
  int part = 0;    // index into Mesh::parts
  int number = 0;  // place among the chunks of the whole mesh
  friend bool operator==(const Chunk&, const Chunk&) = default;
};

/// A mesh whose elements lie chunk after chunk.
struct ChunkedMesh {
  Mesh mesh;
  std::vector<Chunk> chunks;  // in the order of their elements; together they cover every element once
  Numbering numbering;        // of the whole mesh, the same on every rank
};

/// Cuts each part by recursive bisection of its element centres, across the widest extent, into the fewest chunks of at
/// most max_chunk_elements, near-equal in size; permutes elements, nodes, ids and sets. Parts keep the order of
/// Mesh::parts; within a chunk elements keep their order; nodes are numbered by first use. Equal coordinates are told
/// apart by the other two coordinates and then by element index: which elements share a chunk does not depend on the
/// order of the input unless centres coincide. O(n log n).
ChunkedMesh order_chunks(Mesh mesh);

}  // namespace percuss
