#pragma once
// Chunks of different bodies that lie next to each other: what contact across them would send makes it worth to keep
// them on one rank, though they share no node.

#include <cstdint>
#include <vector>

#include "comm/partition/graph_partition.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Where a chunk is and how much surface it has.
struct ChunkBox {
  Vec3 low{}, high{};      // [length]
  std::int64_t faces = 0;  // exterior
};

/// Weight of a face across which chunks may touch, in shared nodes: forces on its corners are exchanged in every
/// iteration of the enforcement, those of a shared node once a step.
inline constexpr int near_face_weight = 4;

/// Edges between chunks of different bodies (what `shared` connects is one), whose boxes lie within the length of a
/// face of each other at time 0, by how many faces may touch there, estimated from the boxes; merged with `shared`,
/// ascending by (a, b). Where nearly every box meets every other, or the weights are too many to be added up, `shared`
/// alone.
std::vector<GraphEdge> add_near_chunks(const std::vector<ChunkBox>& chunks, std::vector<GraphEdge> shared);

}  // namespace percuss
