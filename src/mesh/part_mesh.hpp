#pragma once
// The mesh of one part from a file, all of it, before it is cut into chunks. Generated shapes are never held like this
// (src/mesh/shapes/shape_source.hpp).

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Nodes and elements of one part; indexes are 0-based and count within the part.
struct PartMesh {
  std::vector<Vec3> nodes;                                    // [length]
  Elements elements;                                          // blocks without part, material and section
  std::vector<std::int64_t> node_ids;                         // ids of the file; empty: counted from 1
  std::vector<std::int64_t> element_ids;                      // likewise
  std::vector<int> file_nodes;                                // place of each in the file, from 0
  std::map<std::string, std::vector<int>> node_sets;          // by the name without the part's; ascending, unique
  std::map<std::string, std::vector<ElementFace>> side_sets;  // likewise
  std::vector<Warning> warnings;                              // without the part in their places
  std::vector<std::string> notes;                             // what was done to it, likewise
};

/// Gives each side set without a node set of its name one: the nodes of its faces.
void add_side_nodes(PartMesh& mesh);

/// Copies (array), rotates and translates the part, in this order.
void place_part(PartMesh& mesh, const PartDeck& part);

}  // namespace percuss
