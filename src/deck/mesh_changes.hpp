#pragma once
// What a deck changes in a mesh before it is used: images and places of parts, joined and displaced nodes, mass without
// elements.

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
  std::vector<std::string> sides{};  // "part/side": only nodes of these, of the parts that have some here
};

/// Change of a part into its mirror image or a copy, after it is placed.
struct PartImage {
  enum class Kind { mirror, turn, shift };
  Kind kind = Kind::shift;
  Vec3 way{};          // mirror: unit normal of the plane; turn: unit axis; shift: the shift [length]
  Vec3 center{};       // a point of the plane or of the axis
  double degrees = 0;  // of a turn
  bool operator==(const PartImage&) const = default;
};

/// Parts that are mirrored into new ones.
struct MirrorDeck {
  std::vector<std::string> parts;
  Vec3 normal{}, point{};          // of the plane
  std::string suffix = "_mirror";  // of the names of the new parts
  Place place;
};

/// Parts that are repeated along a line or about an axis; copies count from 2.
struct PatternDeck {
  struct Linear {
    int count = 0;  // the original included
    Vec3 step{};    // [length]
  };
  struct Circular {
    int count = 0;
    Vec3 axis{}, center{};
    std::optional<double> step;  // [degrees]; none: 360 / count
  };
  std::vector<std::string> parts;
  std::optional<Linear> linear;  // one of both
  std::optional<Circular> circular;
  Place place;
};

/// Parts that are turned and moved together before the run: something of them is lowest, and they rest on something.
struct PlaceDeck {
  /// Lowest corner, edge or face, with the mass centre above it: of the box of the parts by its direction, or of a set
  /// by its name.
  struct Lowest {
    enum class Kind { corner, edge, face };
    Kind kind = Kind::corner;
    std::optional<Vec3> of_box;  // each -1, 0 or 1
    std::string set;             // "part/set", instead
    Place place;
  };
  /// Wall or part on which parts are placed.
  struct Support {
    std::string wall, part;  // one of both
    double clearance = 0;    // [length]
    Place place;
  };
  std::vector<std::string> parts;
  std::optional<Lowest> lowest;
  std::optional<Support> rest_on;
  std::optional<Vec3> direction;  // in which they move and fall, a unit vector; none: that of gravity at time 0
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
