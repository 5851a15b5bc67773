#pragma once
// How a run comes to its state at time 0: dynamic relaxation under the loads of that time, preloads of sections, states
// from files, fluids at rest.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/selector.hpp"

namespace percuss {

/// Damped steps before time 0.
struct RelaxationDeck {
  enum class Unsettled { refuse, warn };
  double tolerance = 1e-6;  // of the kinetic energy, as a share of its largest
  long max_steps = 100000;  // more are refused, or warned of
  Unsettled unsettled = Unsettled::refuse;
  long ramp = 500;                // steps in which loads and preloads rise to their values
  std::optional<double> damping;  // c of -c m v; none: from the lowest frequency [1 / time]
  std::vector<Selector> hold;     // nodes that stay at rest meanwhile
};

/// The normal force of a section through a part at time 0: a plane cuts a layer of elements. Without a plane each beam
/// of the part has the force.
struct PreloadDeck {
  std::string name;
  std::string part;
  std::optional<Vec3> point, normal;  // both or none; the latter a unit vector
  double force = 0;                   // positive pulls
  Place place;
};

/// Quantities that a file can have: of elements, but for velocities of nodes.
enum class StartQuantity { stress, plastic_strain, temperature, velocity };

/// A file of stresses of elements or velocities of nodes at time 0, by the user's ids.
struct StartFieldsDeck {
  std::string file;                 // as found: relative paths are relative to the deck
  std::string part;                 // whose ids they are; empty: of any
  std::optional<double> time;       // of an Exodus II file; none: its last [time]
  std::vector<StartQuantity> take;  // of a mesh file; empty: all that it has
  Place place;
};

/// Fluids that begin at rest: with the pressure of what stands above them in the gravity of time 0.
struct HydrostaticDeck {
  std::vector<std::string> parts;
  Vec3 surface{};       // a point of the free surface, which lies across gravity
  double pressure = 0;  // on it
  Place place;
};

struct StartDeck {
  std::optional<RelaxationDeck> relaxation;
  std::vector<HydrostaticDeck> hydrostatic;
  std::vector<PreloadDeck> preloads;
  std::vector<StartFieldsDeck> fields;

  /// The entry that has a part by its name; nullptr: none.
  const HydrostaticDeck* find_hydrostatic(const std::string& part) const {
    for (const HydrostaticDeck& fluid : hydrostatic)
      if (std::find(fluid.parts.begin(), fluid.parts.end(), part) != fluid.parts.end()) return &fluid;
    return nullptr;
  }
};

}  // namespace percuss
