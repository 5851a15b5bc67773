#pragma once
// What a deck changes in a mesh before it is used: joined and displaced nodes, mass without elements.

#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/place_function.hpp"
#include "src/deck/functions/selector.hpp"

namespace percuss {

/// Nodes of different parts that lie at one place become one.
struct JoinDeck {
  std::vector<std::string> parts;   // empty: all
  std::optional<double> tolerance;  // [length]; default: a share of the size of the mesh
  Place place;
};

/// Random displacements from -amplitude to amplitude.
struct NoiseDeck {
  double amplitude = 0;          // [length]
  std::optional<double> length;  // over which it changes; none: each node has its own
  long seed = 1;
};

/// Displacement of nodes before anything else sees them: exactly one of mode and noise.
struct ImperfectionDeck {
  Selector where;
  std::optional<PlaceFunction> mode;  // [length]
  std::optional<NoiseDeck> noise;
  std::optional<Vec3> direction;  // a unit vector; none: along the normal of the shells
  Place place;
};

/// Mass without elements, on nodes.
struct AddedMassDeck {
  enum class Spread { by_mass, evenly };
  Selector where;
  double mass = 0;  // of all the nodes together
  Spread spread = Spread::by_mass;
  Place place;
};

}  // namespace percuss
