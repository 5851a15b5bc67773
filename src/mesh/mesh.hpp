#pragma once
// The mesh of a scene on the host: nodes, elements in blocks, parts and sets. Const after set-up, except for erosion:
// `eroded` and `exterior`.
//
// Node and element indexes are 0-based positions in these arrays. Elements are ordered by chunk, and the user's ids
// stay with them. Where several ranks share the mesh, these are the elements of one of them and the nodes that they
// use.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/topology/elements.hpp"

namespace percuss {

struct MeshPart {
  std::string name;
};

/// Two parts that share nodes.
struct PartJoint {
  int part = 0, other = 0;  // part < other, indexes into Mesh::parts
  std::int64_t nodes = 0;
  double farthest = 0;  // that a node of either was from where both are now [length]; 0: they were one from the start
};

/// Remainder of a mesh after erosion, the same on all ranks that hold it together (src/step/erosion.hpp).
struct ErodedMesh {
  enum NodeState : std::uint8_t { held, particle, vanished };  // by a living element; by none, but there; gone

  bool any = false;                // whether an element of any rank has died
  std::vector<std::uint8_t> dead;  // [elements] of this share
  std::vector<NodeState> nodes;    // [nodes]
};

struct Mesh {
  std::vector<Vec3> nodes;                                    // position at time 0 [length]
  std::vector<std::int64_t> node_ids;                         // the user's ids, 1-based; unique within the mesh
  Elements elements;                                          // with the blocks of all parts, part after part
  std::vector<std::int64_t> element_ids;                      // the user's ids
  std::vector<MeshPart> parts;                                // the deck's parts; each has one block or several
  std::map<std::string, std::vector<int>> node_sets;          // "part", "part/side", "part/set"; ascending, unique
  std::map<std::string, std::vector<ElementFace>> side_sets;  // "part/side", "part/set"; ascending, unique
  std::vector<Warning> warnings;                              // found while building (unused nodes dropped, ...)
  std::vector<std::string> notes;                             // what was done to it, a line each

  // Data of the whole mesh, of which this may be the share of one rank:
  std::vector<std::int64_t> node_numbers;  // [nodes] place of each in the whole mesh, ascending
  std::vector<std::uint8_t> exterior;      // [elements] bit f: face f belongs to no other element that lives
  std::vector<int> bodies;                 // [elements] number of the connected body, from 0 by lowest element
  ErodedMesh eroded;
  Vec3 low{}, high{};                 // box of all nodes [length]
  std::vector<PartJoint> joints;      // the same on all ranks; ascending by part and other
  std::optional<Communicator> ranks;  // ranks that share the mesh; none: this rank holds all of it

  std::span<const int> corners(std::size_t element) const { return elements.corners(element); }
  const ElementBlock& block_of(std::size_t element) const { return elements.block_of(element); }
  const Topology& topology_of(std::size_t element) const { return elements.topology_of(element); }
  int part_of(std::size_t element) const { return block_of(element).part; }
  double thickness_of(std::size_t element) const { return elements.thickness_of(element); }
};

/// Whether some block of the mesh is of tetrahedra, wedges or pyramids; the same on all ranks.
inline bool has_small_solids(const Mesh& mesh) {
  return std::any_of(mesh.elements.blocks.begin(), mesh.elements.blocks.end(), [](const ElementBlock& block) {
    const Topology& topology = find_topology(block.topology);
    return topology.is_solid() && topology.family != ElementFamily::hexahedra;
  });
}

/// Whether some block of the mesh is of surface elements; the same on all ranks.
inline bool has_shells(const Mesh& mesh) {
  const std::vector<ElementBlock>& blocks = mesh.elements.blocks;
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const ElementBlock& block) { return find_topology(block.topology).is_surface(); });
}

/// Whether some block of the mesh is of beams; the same on all ranks.
inline bool has_beams(const Mesh& mesh) {
  const std::vector<ElementBlock>& blocks = mesh.elements.blocks;
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const ElementBlock& block) { return find_topology(block.topology).is_line(); });
}

/// load_mesh() (src/mesh/decomposition/decompose.hpp) on this rank alone, without its chunks.
Mesh build_mesh(const Deck& deck);

/// Nodes that the selector means, ascending; a side set means the nodes of its faces. `inside` counts nodes on the
/// faces of the box in (within 1e-9 of the mesh's diagonal). A set's name without its part will do where only one part
/// has it. Throws InputError (nearest name hinted) if the name is unknown or ambiguous or if nothing is selected, of a
/// mesh that is eroded only the former.
std::vector<int> select_nodes(const Mesh& mesh, const Deck& deck, const Selector& selector);

/// Exterior faces that the selector means, ascending: those of a side set (its interior faces left out), of a part or
/// of the whole mesh; with `inside` only those with all four corners inside. Throws InputError likewise.
std::vector<ElementFace> select_faces(const Mesh& mesh, const Deck& deck, const Selector& selector);
/// Selects among `exterior`, the faces of find_exterior_faces(), for callers that select several times.
std::vector<ElementFace> select_faces(const Mesh& mesh, const Deck& deck, const Selector& selector,
                                      const std::vector<ElementFace>& exterior);

/// Selects faces that may touch: a part of beams alone, which touch without faces, has none.
std::vector<ElementFace> select_touching_faces(const Mesh& mesh, const Deck& deck, const Selector& selector,
                                               const std::vector<ElementFace>& exterior);

/// Whether a selector names a whole part that has nothing but beams; the same on all ranks.
bool names_beams_alone(const Mesh& mesh, const Selector& selector);

/// The faces that Mesh::exterior marks, ascending.
std::vector<ElementFace> find_exterior_faces(const Mesh& mesh);

}  // namespace percuss
