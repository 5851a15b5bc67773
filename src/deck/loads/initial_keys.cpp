#include "src/deck/loads/initial_keys.hpp"

#include "src/deck/loads/node_values.hpp"

namespace percuss {
namespace {

// No default of the centre: the centre of mass of a quarter is not the centre of the whole.
const Keys<RadialVelocityDeck>& radial_velocity_keys() {
  static const Keys<RadialVelocityDeck> keys = {
      need("speed", &RadialVelocityDeck::speed, NumberValue{}),
      need("center", &RadialVelocityDeck::center, vector3()),
      may("axis", &RadialVelocityDeck::axis, DirectionValue{}),
  };
  return keys;
}

const Keys<InitialDeck>& initial_keys() {
  static const Keys<InitialDeck> keys = {
      may("part", &InitialDeck::where, SelectorValue{Chosen::nodes}),
      may("nodes", &InitialDeck::where, SelectorValue{Chosen::nodes}),
      may("body", &InitialDeck::where, BodyValue{}),
      may("velocity", &InitialDeck::velocity, vector3()),
      may("angular_velocity", &InitialDeck::angular_velocity, vector3()),
      may("center", &InitialDeck::center, vector3()),
      may("radial_velocity", &InitialDeck::radial_velocity, MapValue<RadialVelocityDeck>{radial_velocity_keys}),
  };
  return keys;
}

/// A body has the velocity of its centre and its spin about that.
bool check_initial_of_body(const Reader& reader, const Node& node) {
  for (const char* key : {"part", "nodes", "center", "radial_velocity"}) {
    if (node.find(key) == nullptr) continue;
    reader.error(node.find(key)->key, fmt::format("{} has body and {} (a body moves with its mass centre, and turns "
                                                  "about it): leave one of them out",
                                                  reader.self(), key));
    return false;
  }
  return true;
}

bool check_initial(const Reader& reader, const Node& node, InitialDeck& initial) {
  initial.where.place = node.spot.place;
  if (const Node* both = node.find("part") != nullptr ? node.find("nodes") : nullptr) {
    reader.error(both->key, fmt::format("{} has both part and nodes (must be one of them)", reader.self()));
    return false;
  }
  if (node.find("body") != nullptr && !check_initial_of_body(reader, node)) return false;
  const bool spins = node.find("angular_velocity") != nullptr;
  if (!spins && !initial.radial_velocity && node.find("velocity") == nullptr) {
    reader.error(node.spot, fmt::format("{} has no velocity (required: velocity, angular_velocity or radial_velocity)",
                                        reader.self()));
    return false;
  }
  if (initial.center && !spins) {
    reader.error(node.find("center")->key,
                 fmt::format("{} has no effect (there is no angular_velocity)", reader.name_of("center")));
    return false;
  }
  return true;
}

}  // namespace

MapValue<InitialDeck> initial_value() { return {initial_keys, check_initial}; }

}  // namespace percuss
