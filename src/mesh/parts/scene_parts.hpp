#pragma once
// The parts of a scene before any of their elements is made: how many nodes, elements and chunks each has, from where
// they are numbered, and what its sets are called. The same on every rank; only rank 0 holds the parts from files.
//
// A key identifies nodes before they have numbers: nodes of a part, copy after copy, part after part. Where parts are
// joined, several keys are one node.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/numbering.hpp"
#include "src/mesh/part_mesh.hpp"
#include "src/mesh/parts/part_placement.hpp"
#include "src/mesh/shapes/shape_source.hpp"
#include "src/mesh/shapes/tiling.hpp"

namespace percuss {

/// A part from a file, its elements in chunk order.
struct FilePart {
  PartMesh mesh;                       // with ids that are unique in the scene
  std::vector<int> first_of_chunk;     // [chunks + 1] into its elements
  std::vector<std::uint8_t> exterior;  // [elements] as Mesh::exterior
  std::vector<int> bodies;             // [elements] counted within the part
};

/// A part that is generated.
struct GeneratedPart {
  std::unique_ptr<ShapeSource> source;
  PartPlacement place;
  PartTiling tiling;
};

struct ScenePart {
  std::string name;
  std::vector<ElementBlock> blocks;  // with part, material and section, the same on every rank
  std::optional<GeneratedPart> generated;
  std::unique_ptr<FilePart> file;                        // rank 0, of a part from a file
  std::int64_t nodes = 0, elements = 0;                  // with all copies
  std::int64_t first_key = 0;                            // of its nodes
  std::int64_t first_node_id = 0, first_element_id = 0;  // the user's, of a generated part
  int first_chunk = 0, chunks = 0, first_body = 0, bodies = 0, first_block = 0;
  std::vector<std::string> node_sets, side_sets;  // names without the part's; those of a shape are its sides
  int first_node_set = 0, first_side_set = 0;     // places among those of all parts
  std::string error;                              // what is wrong, without its place; such a part is left out
  std::vector<Warning> warnings;                  // rank 0, likewise
  std::vector<std::string> notes;                 // of Mesh::notes; rank 0, likewise
};

/// A node that several parts have: all keys with one root are one node.
struct JoinedNode {
  std::int64_t key = 0, root = 0;  // root: the lowest of them
  std::int64_t id = 0;             // the user's, of the root
  Vec3 place{};                    // likewise [length]
};

struct SceneParts {
  std::vector<ScenePart> parts;
  std::vector<JoinedNode> joined;           // ascending by key, the roots among them
  std::vector<PartJoint> joints;            // as Mesh::joints
  std::int64_t keys = 0;                    // of nodes, 0 <= key < keys
  std::vector<std::int64_t> first_element;  // [chunks + 1] as Numbering::first_element
  std::vector<Warning> warnings;            // rank 0, of no part alone
  std::vector<std::string> notes;           // likewise

  int chunk_count() const { return static_cast<int>(first_element.size()) - 1; }
};

/// Counts the generated parts and reads the others on rank 0. What is wrong with a part stays with it. Collective;
/// throws SystemError, on every rank, if a file is there but cannot be read.
SceneParts describe_parts(const Deck& deck, const Communicator& ranks);

/// Where a node of a part stands, counted over its copies [length]. Of parts from files on rank 0 alone.
Vec3 find_node_place(const ScenePart& part, std::int64_t node);

/// "part 'bar': " or "part 'bar': bar.e: ", as messages about a part begin.
std::string describe_source(const PartDeck& part);

}  // namespace percuss
