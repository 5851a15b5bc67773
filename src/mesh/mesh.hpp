#pragma once
// The mesh of a scene on the host: nodes, eight-node hexahedra and four-node shells, parts and sets. Const after
// set-up, except for erosion: `eroded` and `exterior`.
//
// Node and element indexes are 0-based positions in these arrays. Elements are ordered by chunk, and the user's ids
// stay with them. Where several ranks share the mesh, these are the elements of one of them and the nodes that they
// use.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Corners of the six faces of a hexahedron (Exodus II / VTK corner order), outward by the right-hand rule.
inline constexpr int hex_faces[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                        {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};

/// The faces of a shell, whose four corners stand twice in an element: the second is where its normal points to.
inline constexpr int shell_bottom = 4, shell_top = 5;

/// An element with the corners of a shell.
inline std::array<int, 8> make_shell(const std::array<int, 4>& nodes) {
  return {nodes[0], nodes[1], nodes[2], nodes[3], nodes[0], nodes[1], nodes[2], nodes[3]};
}

/// Whether an element is a shell: no hexahedron names a node twice. Corner: an index, a number or an id.
template <class Corner>
bool is_shell(const std::array<Corner, 8>& corners) {
  return corners[0] == corners[4];
}

/// Whether a shell is a triangle: its last corner is the third again.
template <class Corner>
bool is_triangle(const std::array<Corner, 8>& corners) {
  return is_shell(corners) && corners[2] == corners[3];
}

/// A face as a side set names it.
struct ElementFace {
  int element = 0;
  int face = 0;  // row of hex_faces (Exodus side number - 1)
  friend auto operator<=>(const ElementFace&, const ElementFace&) = default;
};

struct MeshPart {
  std::string name;
  int material = 0;      // index into Deck::materials
  double thickness = 0;  // of its shells [length]; 0: it has none
  int points = 0;        // across the thickness; 0: by the material
};

/// What erosion has left of a mesh, the same on all ranks that hold it together (src/step/erosion.hpp).
struct ErodedMesh {
  enum NodeState : std::uint8_t { held, particle, vanished };  // by a living element; by none, but there; gone

  bool any = false;                // whether an element of any rank has died
  std::vector<std::uint8_t> dead;  // [elements] of this share
  std::vector<NodeState> nodes;    // [nodes]
};

struct Mesh {
  std::vector<Vec3> nodes;                            // position at time 0 [length]
  std::vector<std::int64_t> node_ids;                 // the user's ids, 1-based; unique within the mesh
  std::vector<std::array<int, 8>> elements;           // corners, Exodus II HEX8 order; of a shell twice
  std::vector<std::int64_t> element_ids;              // the user's ids
  std::vector<int> element_part;                      // index into parts
  std::vector<MeshPart> parts;                        // the deck's parts; a part's Exodus blocks all share its material
  std::map<std::string, std::vector<int>> node_sets;  // "part", "part/side", "part/set"; ascending, unique
  std::map<std::string, std::vector<ElementFace>> side_sets;  // "part/side", "part/set"; ascending, unique
  std::vector<Warning> warnings;                              // found while building (unused nodes dropped, ...)

  // Of the whole mesh, of which this may be the share of one rank:
  std::vector<std::int64_t> node_numbers;  // [nodes] place of each in the whole mesh, ascending
  std::vector<std::uint8_t> exterior;      // [elements] bit f: face f belongs to no other element that lives
  std::vector<int> bodies;                 // [elements] number of the connected body, from 0 by lowest element
  ErodedMesh eroded;
  Vec3 low{}, high{};                 // box of all nodes [length]
  std::optional<Communicator> ranks;  // those that hold it together; none: this one holds it all
};

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

/// The faces that Mesh::exterior marks, ascending.
std::vector<ElementFace> find_exterior_faces(const Mesh& mesh);

}  // namespace percuss
