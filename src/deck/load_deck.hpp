#pragma once
// Velocities at the start, conditions, loads and damping.

#include <array>
#include <cstddef>
#include <optional>

#include "src/deck/functions/curve.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/sensor_deck.hpp"

namespace percuss {

/// A speed that is equal at every node, along the line to it from a point or from an axis.
struct RadialVelocityDeck {
  double speed = 0;  // outward
  Vec3 center{};
  std::optional<Vec3> axis;  // a unit vector; none: from the point
};

struct InitialDeck {
  Selector where;
  Vec3 velocity{};
  Vec3 angular_velocity{};     // rad/s
  std::optional<Vec3> center;  // default: the mass centre of the selected nodes
  std::optional<RadialVelocityDeck> radial_velocity;
};

/// A rotation about an axis of space at rest, from where the nodes are.
struct TurnDeck {
  std::size_t axis = 0;    // x, y, z
  Vec3 through{};          // a point of the axis
  Curve angular_velocity;  // [rad / time]
};

/// Exactly one of the kinds a list entry. Directions are the axes x, y, z and, of nodes of shells, rotations about
/// them. Of a body: of its centre, and its turns about axes through it; directions that are not named stay free.
struct ConditionDeck {
  enum class Kind { fixed, symmetry, velocity, displacement, turn };
  Selector where;
  Kind kind = Kind::fixed;
  std::array<bool, 6> active{};  // which directions are held: x, y, z, then rotations about x, y, z
  std::array<Curve, 6> value;    // velocity, displacement or angular velocity [rad / time] in each active direction
  std::optional<TurnDeck> turn;  // both directions across its axis are active
  SwitchDeck when;
};

/// Acceleration of everything [length / time^2].
struct GravityDeck {
  std::array<Curve, 3> along;  // x, y, z

  Vec3 at(double time) const { return {along[0](time), along[1](time), along[2](time)}; }
  /// Whether it is the same at all times.
  bool is_constant() const { return along[0].is_constant() && along[1].is_constant() && along[2].is_constant(); }
  bool any() const { return !is_constant() || at(0) != Vec3{}; }
};

/// A charge of TNT: a hemisphere on the ground, or a sphere in free air.
struct BlastDeck {
  enum class Burst { ground, air };
  double charge = 0;  // [mass]
  Vec3 center{};
  double time = 0;  // of the detonation
  bool has_negative_phase = false;
  Burst burst = Burst::ground;
};

/// Pressure on faces, positive acts against the outward normal, on the current area. With a direction (a unit vector):
/// a dead load along it, on the area at the start.
struct PressureDeck {
  Selector where;
  Curve value;
  std::optional<BlastDeck> blast;  // instead of the value
  std::optional<Vec3> direction;
  SwitchDeck when;
};

/// Forces and, of nodes of shells, moments, on each of the nodes; or on a point of a rigid body.
struct NodalLoadDeck {
  Selector where;
  std::array<bool, 6> active{};  // which are given: forces along x, y, z, then moments about x, y, z
  std::array<Curve, 6> value;
  SwitchDeck when;
  std::optional<Vec3> at{};  // of a body, at time 0; none: its centre
};

/// A force -c m v on nodes, of shells also -c I w.
struct DampingDeck {
  Selector where;
  Curve coefficient;  // c [1 / time]
};

}  // namespace percuss
