#pragma once
// Chunks before their nodes have numbers: what a rank makes or reads at first, and then gives to the ranks that will
// hold them. Every part alike.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/mesh/parts/scene_parts.hpp"

namespace percuss {

/// A node of a piece that a set names, or a face of one of its elements.
struct SetMember {
  int item = 0;  // node or element, index into the arrays of ChunkPieces
  int set = 0;   // place among the sets of all parts
  int face = 0;  // as ElementFace::face; 0 for a node
};

/// Some chunks, each with nodes of its own: a node of several chunks is there several times.
struct ChunkPieces {
  std::vector<int> chunks;                   // global numbers, ascending
  std::vector<int> parts;                    // [chunks]
  std::vector<int> first_element{0};         // [chunks + 1]
  std::vector<int> first_node{0};            // [chunks + 1]
  std::vector<int> blocks;                   // [elements] place among the blocks of all parts
  std::vector<std::size_t> first_corner{0};  // [elements + 1] into corners
  std::vector<std::uint16_t> corners;        // place of each among the nodes of the chunk
  std::vector<std::int64_t> element_ids;     // [elements] the user's
  std::vector<int> bodies;                   // [elements] as Mesh::bodies
  std::vector<std::uint8_t> exterior;        // [elements] as Mesh::exterior
  std::vector<double> thicknesses;           // [elements] that the file gives; 0: none [length]
  std::vector<std::int64_t> keys;            // [nodes] in the order of their first use in the chunk
  std::vector<std::int64_t> node_ids;        // [nodes] the user's
  std::vector<Vec3> places;                  // [nodes] at time 0 [length]
  std::vector<SetMember> node_members, face_members;

  std::size_t count_corners(std::size_t element) const { return first_corner[element + 1] - first_corner[element]; }

  /// Node of a corner of an element of chunk c (of these), as an index into the arrays of nodes.
  std::size_t find_node(std::size_t c, std::size_t element, std::size_t corner) const {
    return static_cast<std::size_t>(first_node[c]) + corners[first_corner[element] + corner];
  }
};

/// The pieces that rank `rank` of `size` begins with: its equal share of all generated chunks, in their order, and on
/// rank 0 the chunks of files, which only it has. Nothing else is made.
ChunkPieces make_pieces(const SceneParts& scene, int rank, int size);

}  // namespace percuss
