#include "src/deck/connections/turn_spring_keys.hpp"

#include <cmath>

#include "src/deck/keys/force_table_value.hpp"
#include "src/deck/rigid_bodies.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

const Keys<TurnLawDeck>& law_keys() {
  static const ForceTableValue by_angle{"angle", "moment"}, by_rate{"rate", "moment"};
  static const Keys<TurnLawDeck> keys = {
      may("stiffness", &TurnLawDeck::stiffness, NumberValue{positive}),
      may("table", &TurnLawDeck::table, by_angle),
      may("damping", &TurnLawDeck::damping, NumberValue{positive}),
      may("damping_table", &TurnLawDeck::damping_table, by_rate),
      may("friction", &TurnLawDeck::friction, NumberValue{positive}),
      may("friction_table", &TurnLawDeck::friction_table, by_angle),
      may("least", &TurnLawDeck::least, NumberValue{any_number}),
      may("most", &TurnLawDeck::most, NumberValue{any_number}),
      may("hold_stiffness", &TurnLawDeck::hold_stiffness, NumberValue{positive}),
  };
  return keys;
}

/// Only one of two keys.
bool check_either(const Reader& reader, const Node& node, const char* number, const char* table) {
  if (node.find(number) == nullptr || node.find(table) == nullptr) return true;
  reader.error(node.find(table)->key,
               fmt::format("{} has both {} and {} (must have one of them)", reader.self(), number, table));
  return false;
}

bool check_law(const Reader& reader, const Node& node, TurnLawDeck& law) {
  if (!check_either(reader, node, "stiffness", "table") || !check_either(reader, node, "damping", "damping_table") ||
      !check_either(reader, node, "friction", "friction_table"))
    return false;
  const bool holds = law.friction || !law.friction_table.empty() || law.least || law.most;
  if (holds != law.hold_stiffness.has_value()) {
    reader.error(
        node.spot,
        fmt::format("{} {} (friction and stops have the stiffness hold_stiffness): {}", reader.self(),
                    holds ? "has friction or stops, but no hold_stiffness" : "has a hold_stiffness for nothing",
                    holds ? "give it" : "leave it out, or give friction, least or most"));
    return false;
  }
  if (law.least && law.most && *law.least >= *law.most) {
    reader.error(node.find("most")->spot, fmt::format("{} is {}{} (must be above least, {})", reader.name_of("most"),
                                                      *law.most, reader.in(), *law.least));
    return false;
  }
  for (const auto& [angle, moment] : law.friction_table) {
    if (moment >= 0) continue;
    reader.error(node.find("friction_table")->spot,
                 fmt::format("{} has the moment {}{} (friction acts against the turn, whatever its direction): give "
                             "moments of at least 0",
                             reader.name_of("friction_table"), moment, reader.in()));
    return false;
  }
  if (holds || law.stiffness || !law.table.empty() || law.damping > 0 || !law.damping_table.empty()) return true;
  reader.error(node.spot,
               fmt::format("{} does nothing (must have a spring, a damper, friction or a stop)", reader.self()));
  return false;
}

using AxesValue = TupleValue<DirectionValue, 2>;

const Keys<TurnSpringDeck>& turn_spring_keys() {
  static const MapValue<TurnLawDeck> law{law_keys, check_law};
  static const Keys<TurnSpringDeck> keys = {
      need("bodies", &TurnSpringDeck::bodies, ListValue<NameValue>{}),
      may("axes", &TurnSpringDeck::axes, AxesValue{}),
      may("second_axes", &TurnSpringDeck::second_axes, AxesValue{}),
      may("x", &TurnSpringDeck::x, law),
      may("y", &TurnSpringDeck::y, law),
      may("z", &TurnSpringDeck::z, law),
  };
  return keys;
}

/// Makes the second direction perpendicular to the first. Whether they have a plane.
bool square_axes(std::array<Vec3, 2>& axes) {
  constexpr double least = 1e-6;
  const Vec3& x = axes[0];
  Vec3 y = axes[1];
  const double along = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  for (std::size_t k = 0; k < 3; ++k) y[k] -= along * x[k];
  const double length = std::hypot(y[0], y[1], y[2]);
  if (length < least) return false;
  for (std::size_t k = 0; k < 3; ++k) axes[1][k] = y[k] / length;
  return true;
}

bool check_axes(const Reader& reader, const Node& node, const char* key, std::array<Vec3, 2>& axes) {
  if (square_axes(axes)) return true;
  reader.error(node.find(key)->spot,
               fmt::format("{} has two directions on one line{} (they are the axis x and a direction in the plane of x "
                           "and y): give two that differ",
                           reader.name_of(key), reader.in()));
  return false;
}

bool check_turn_spring(const Reader& reader, const Node& node, TurnSpringDeck& spring) {
  spring.place = node.spot.place;
  const Node& bodies = *node.find("bodies");
  if (spring.bodies.size() != 2 || spring.bodies[0] == spring.bodies[1]) {
    reader.error(
        bodies.spot,
        fmt::format("{} must name two bodies{} (it resists the turn of one against the other): give two, of which "
                    "one may be a rigid part that is fixed",
                    reader.name_of("bodies"), reader.in()));
    return false;
  }
  if (!check_axes(reader, node, "axes", spring.axes)) return false;
  if (spring.second_axes && !check_axes(reader, node, "second_axes", *spring.second_axes)) return false;
  if (spring.x || spring.y || spring.z) return true;
  reader.error(node.spot, fmt::format("{} does nothing (must have x, y or z)", reader.self()));
  return false;
}

}  // namespace

NamedMapValue<TurnSpringDeck, MapValue<TurnSpringDeck>> turn_springs_value() {
  return {"turn spring", {turn_spring_keys, check_turn_spring}};
}

void check_turn_springs(const Deck& deck, const Node& root, Reading& reading) {
  const RigidNames names = name_rigid_bodies(deck);
  for (const TurnSpringDeck& spring : deck.turn_springs) {
    const Node& bodies = *root.find("turn_springs")->find(spring.name)->find("bodies");
    for (std::size_t i = 0; i < spring.bodies.size() && i < bodies.items.size(); ++i) {
      const std::string& name = spring.bodies[i];
      if (names.find(name) >= 0) continue;
      reading.errors.add(bodies.items[i].spot,
                         fmt::format("turn spring '{}' is to act on '{}', which is no rigid body{}", spring.name, name,
                                     name_hint(name, names.bodies)));
    }
  }
}

}  // namespace percuss
