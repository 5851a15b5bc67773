#pragma once
// What a selector means where the nodes of a surface count: those of faces, or a set of nodes as the edge of a shell;
// and where elements count.

#include <string>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// [sets] their names, ascending. Sets: a map from names.
template <class Sets>
std::vector<std::string> list_names(const Sets& sets) {
  std::vector<std::string> names;
  names.reserve(sets.size());
  for (const auto& [name, set] : sets) names.push_back(name);
  return names;
}

struct SurfaceNodes {
  std::vector<int> nodes;          // ascending
  std::vector<ElementFace> faces;  // exterior, ascending: those selected, or around the nodes of a set
  bool is_node_set = false;
};

/// Faces that the selector means, with their corners; if it names a set of nodes alone, these with the exterior faces
/// around them. Throws InputError as select_faces() and select_nodes() do. Collective over Mesh::ranks.
SurfaceNodes select_surface_nodes(const Mesh& mesh, const Deck& deck, const Selector& selector);

/// [elements of a set] ascending: those all of whose faces are in it, as a set of elements has them
/// (src/mesh/reading/part_reader.cpp). faces: ascending.
std::vector<int> list_whole_elements(const Elements& elements, const std::vector<ElementFace>& faces);

/// [elements] whether each is of one of the parts, element sets or element blocks; a name may be that of a set and of a
/// block, which then means the set. Throws InputError, on all ranks, for a name that is
/// none, or that has no element. Collective over Mesh::ranks.
std::vector<char> mark_elements(const Mesh& mesh, const Deck& deck, const std::vector<Selector>& selectors);

}  // namespace percuss
