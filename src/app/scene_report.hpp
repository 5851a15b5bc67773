#pragma once
// What a scene is, in words: the answer of `percuss check`.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/mesh/mesh.hpp"

namespace percuss {

struct SceneReport {
  const Deck& deck;
  const Mesh& mesh;
  double first_step = 0;        // time unit of the deck
  int controlling_element = 0;  // index of the element that limits it
  int contact_nodes = 0, contact_faces = 0;
  std::string overlap = {};  // what contact says about overlap at the start; empty if there is none
};

/// Several lines: parts with elements, nodes and mass, bodies, contact, loads, output, the first time step, warnings.
std::string format_scene(const SceneReport& scene);

/// Mass of each part [mass]: exact volume of its elements times density.
std::vector<double> sum_part_masses(const Mesh& mesh, const Deck& deck);

}  // namespace percuss
