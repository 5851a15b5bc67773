#include "src/deck/contact/wall_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/deck/keys/switch_keys.hpp"

namespace percuss {
namespace {

/// One selector or a list of them.
struct SelectorsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Selector>& out) const {
    if (node.kind == Node::Kind::list) return ListValue<SelectorValue>{{Chosen::nodes}}.read(reader, name, node, out);
    Selector one;
    if (!SelectorValue{Chosen::nodes}.read(reader, name, node, one)) return false;
    out.push_back(std::move(one));
    return true;
  }
  std::string takes() const { return "a selector or a list of them"; }
  Form form() const { return any_form({SelectorValue{}.form(), list_form(SelectorValue{}.form())}); }
};

const Keys<RectangleDeck>& rectangle_keys() {
  static const Keys<RectangleDeck> keys = {
      need("along", &RectangleDeck::along, DirectionValue{}),
      need("size", &RectangleDeck::size, TupleValue<NumberValue, 2>{NumberValue{positive}}),
  };
  return keys;
}

const Keys<CylinderWallDeck>& cylinder_wall_keys() {
  static const Keys<CylinderWallDeck> keys = {
      need("axis", &CylinderWallDeck::axis, DirectionValue{}),
      need("radius", &CylinderWallDeck::radius, NumberValue{positive}),
      may("length", &CylinderWallDeck::length, NumberValue{positive}),
  };
  return keys;
}

const Keys<SphereWallDeck>& sphere_wall_keys() {
  static const Keys<SphereWallDeck> keys = {need("radius", &SphereWallDeck::radius, NumberValue{positive})};
  return keys;
}

const Keys<WallDeck>& wall_keys() {
  static const Keys<WallDeck> keys = with_switch<WallDeck>({
      may("name", &WallDeck::name, NameValue{}),
      may("point", &WallDeck::point, vector3()),
      may("normal", &WallDeck::normal, DirectionValue{}),
      may("rectangle", &WallDeck::rectangle, MapValue<RectangleDeck>{rectangle_keys}),
      may("cylinder", &WallDeck::cylinder, MapValue<CylinderWallDeck>{cylinder_wall_keys}),
      may("sphere", &WallDeck::sphere, MapValue<SphereWallDeck>{sphere_wall_keys}),
      may("direction", &WallDeck::direction, DirectionValue{}),
      may("speed", &WallDeck::speed, CurveValue{}),
      may("mass", &WallDeck::mass, NumberValue{positive}),
      may("start_speed", &WallDeck::start_speed, NumberValue{}),
      may("friction", &WallDeck::friction, NumberValue{not_negative}),
      may("nodes", &WallDeck::nodes, SelectorsValue{}),
      may("thickness", &WallDeck::includes_thickness, ChoiceValue<bool>{{{"ignored", false}, {"included", true}}}),
  });
  return keys;
}

/// Makes the direction of a rectangle perpendicular to the normal.
bool turn_rectangle(const Reader& reader, const Node& node, WallDeck& wall) {
  if (!wall.rectangle) return true;
  Vec3& along = wall.rectangle->along;
  const Vec3& n = wall.normal;
  const double out = along[0] * n[0] + along[1] * n[1] + along[2] * n[2];
  for (std::size_t k = 0; k < 3; ++k) along[k] -= out * n[k];
  const double length = std::hypot(along[0], along[1], along[2]);
  constexpr double least = 1e-3;  // component of the direction: with less it points out of the wall, but for round-off
  if (length < least) {
    reader.error(node.find("rectangle")->spot, fmt::format("{} points along the normal (it must lie in the wall)",
                                                           reader.name_of("rectangle.along")));
    return false;
  }
  for (double& component : along) component /= length;
  return true;
}

/// Planes have a normal, and cylinders and spheres what belongs to them.
bool check_wall_shape(const Reader& reader, const Node& node, const WallDeck& wall) {
  const auto refuse = [&](const char* key, const char* why) {
    const Node* value = node.find(key);
    if (value == nullptr) return false;
    reader.error(value->key, fmt::format("{} has no effect ({})", reader.name_of(key), why));
    return true;
  };
  if (!wall.is_round()) {
    if (refuse("direction", "a plane moves along its normal")) return false;
    if (node.find("normal") != nullptr) return true;
    refuse_missing(reader, node, "normal", DirectionValue{}.takes() + "; cylinder or sphere in its place");
    return false;
  }
  if (wall.cylinder && refuse("sphere", "the wall is a cylinder")) return false;
  const char* const what = "a cylinder or a sphere has none";
  for (const char* key : {"normal", "rectangle", "mass", "start_speed"})
    if (refuse(key, what)) return false;
  const bool has_direction = node.find("direction") != nullptr;
  if (wall.speed && !has_direction) {
    reader.error(node.find("speed")->key,
                 fmt::format("{} has no direction: give the key direction as well", reader.name_of("speed")));
    return false;
  }
  return wall.speed || !refuse("direction", "the wall has no speed");
}

bool check_wall_motion(const Reader& reader, const Node& node, const WallDeck& wall) {
  if (wall.speed && wall.mass) {
    reader.error(node.find("mass")->key,
                 fmt::format("{} has no effect (speed already prescribes the motion of the wall): leave out one",
                             reader.name_of("mass")));
    return false;
  }
  if (wall.mass || node.find("start_speed") == nullptr) return true;
  reader.error(node.find("start_speed")->key,
               fmt::format("{} has no effect (it applies only to a wall with a mass): give a mass, or a speed",
                           reader.name_of("start_speed")));
  return false;
}

bool check_wall(const Reader& reader, const Node& node, WallDeck& wall) {
  wall.place = node.spot.place;
  if (!check_wall_shape(reader, node, wall) || !turn_rectangle(reader, node, wall) ||
      !check_wall_motion(reader, node, wall))
    return false;
  // A list that names the whole mesh says nothing more than no list.
  const auto all =
      std::find_if(wall.nodes.begin(), wall.nodes.end(), [](const Selector& s) { return s.name.empty() && !s.inside; });
  if (all != wall.nodes.end()) wall.nodes.clear();
  return true;
}

}  // namespace

MapValue<WallDeck> wall_value() { return {wall_keys, check_wall}; }

}  // namespace percuss
