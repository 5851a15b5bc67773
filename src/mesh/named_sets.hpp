#pragma once
// Sets of the mesh that have a name of their own: those that a file of results has.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

/// Names of sets of the mesh, ascending: those of mesh files, and sides of generated parts that the deck names. A set
/// of all nodes of a part is none of them.
struct NamedSets {
  std::vector<std::string> of_nodes, of_sides;
};

NamedSets find_named_sets(const Deck& deck, const Mesh& mesh);

}  // namespace percuss
