#pragma once
// Chunks: what everything after meshing counts in (the decomposition, the fixed order of every sum, what is skipped).
//
// A chunk comes from the mesh alone, never from the number of ranks or threads, so that results do not depend on them.
// Generated parts are cut by index (src/mesh/shapes/tiling.hpp), parts from files by the bisection here.

#include <cstdint>
#include <vector>

#include "src/mesh/mesh.hpp"
#include "src/mesh/numbering.hpp"
#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// Most elements a chunk of a part has. Large chunks have fewer copies of nodes (1.4 an element with 512, 2.0 with 64),
/// and what is stored and added up by copy is a sixth of the time of a step; small ones are easier to share out. So
/// a part has 2048 chunks before they grow: 32 for each of 64 ranks, which are even to 3 %.
inline constexpr int least_chunk_limit = 64, largest_chunk_limit = 512;
inline int find_chunk_limit(std::int64_t part_elements) {
  constexpr int chunks_of_a_part = 2048;
  int limit = least_chunk_limit;
  while (limit < largest_chunk_limit && part_elements >= std::int64_t{2} * limit * chunks_of_a_part) limit *= 2;
  return limit;
}

/// Cuts of a part from a file fall on multiples of this many elements, so that only the last pack of a part is partly
/// empty (for any pack of up to 16 lanes).
inline constexpr int chunk_granularity = 16;

/// A contiguous run of elements of one part and of one family; all have the material and the section of the first.
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

/// Block of the elements of a chunk: that of the first.
inline const ElementBlock& find_block(const ChunkedMesh& chunked, const Chunk& chunk) {
  return chunked.mesh.block_of(static_cast<std::size_t>(chunk.first_element));
}

/// Number of each element of the share in the whole mesh.
std::vector<std::int64_t> list_element_numbers(const ChunkedMesh& chunked);

/// Elements chunk after chunk.
struct ElementOrder {
  std::vector<int> elements;        // place i of the new order has element elements[i] of the old
  std::vector<int> first_of_chunk;  // [chunks + 1] into elements
};

/// Cuts a part, its hexahedra first and then its shells, by recursive bisection of its element centres, across the
/// widest extent, into the fewest chunks of at most find_chunk_limit() elements, near-equal in size; within a chunk
/// elements keep their order. Equal coordinates are distinguished by the other two coordinates and then by element
/// index: which elements share a chunk does not depend on the order of the input unless centres coincide. O(n log n).
/// groups: [elements] of which no two share a chunk either; empty: all are one.
ElementOrder bisect_elements(const PartMesh& mesh, const std::vector<int>& groups = {});

}  // namespace percuss
