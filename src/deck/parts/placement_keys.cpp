#include "src/deck/parts/placement_keys.hpp"

#include <algorithm>
#include <cmath>

#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

using Lowest = PlaceDeck::Lowest;

/// A set by its name, or a corner, an edge or a face of the box by its direction.
struct LowestValue {
  Lowest::Kind kind = Lowest::Kind::corner;

  bool read(const Reader& reader, const std::string& name, const Node& node, Lowest& out) const {
    out.kind = kind;
    out.place = node.spot.place;
    if (node.kind != Node::Kind::list) {
      if (!TextValue{}.read(reader, name, node, out.set)) return false;
      reader.reading().selectors.push_back({node.spot, out.set, fmt::format(" in {}", name)});
      return true;
    }
    Vec3 way{};
    if (!vector3().read(reader, name, node, way)) return false;
    const auto zeros = std::count(way.begin(), way.end(), 0.0);
    const bool is_whole = std::all_of(way.begin(), way.end(), [](double x) { return x == 0 || std::abs(x) == 1; });
    if (!is_whole || zeros != wanted_zeros()) {
      reader.refuse(node, name, rule());
      return false;
    }
    out.of_box = way;
    return true;
  }
  std::string takes() const { return "a name of a set, or " + rule(); }
  Form form() const { return any_form({TextValue{}.form(), vector3().form()}); }

 private:
  long wanted_zeros() const { return kind == Lowest::Kind::corner ? 0 : kind == Lowest::Kind::edge ? 1 : 2; }
  std::string rule() const {
    return kind == Lowest::Kind::corner ? "a list of 3, each -1 or 1"
           : kind == Lowest::Kind::edge ? "a list of 3: one 0, the others -1 or 1"
                                        : "a list of 3: two 0, the other -1 or 1";
  }
};

const Keys<Lowest>& lowest_keys() {
  static const Keys<Lowest> keys = {
      group<Lowest>("corner", LowestValue{Lowest::Kind::corner}),
      group<Lowest>("edge", LowestValue{Lowest::Kind::edge}),
      group<Lowest>("face", LowestValue{Lowest::Kind::face}),
  };
  return keys;
}

bool check_lowest(const Reader& reader, const Node& node, Lowest&) {
  const auto given = std::count_if(lowest_keys().begin(), lowest_keys().end(),
                                   [&](const auto& key) { return node.find(key.name) != nullptr; });
  if (given == 1) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of corner, edge and face)", reader.self(),
                                      given == 0 ? "none of its keys" : "several keys"));
  return false;
}

const Keys<PlaceDeck::Support>& support_keys() {
  using Support = PlaceDeck::Support;
  static const Keys<Support> keys = {
      may("wall", &Support::wall, NameValue{}),
      may("part", &Support::part, NameValue{}),
      may("clearance", &Support::clearance, NumberValue{not_negative}),
  };
  return keys;
}

bool check_support(const Reader& reader, const Node& node, PlaceDeck::Support& support) {
  support.place = node.spot.place;
  const bool has_wall = node.find("wall") != nullptr, has_part = node.find("part") != nullptr;
  if (has_wall != has_part) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of wall and part)", reader.self(),
                                      has_wall ? "both wall and part" : "neither wall nor part"));
  return false;
}

const Keys<PlaceDeck>& place_keys() {
  static const Keys<PlaceDeck> keys = {
      need("parts", &PlaceDeck::parts, ListValue<NameValue>{}),
      may("lowest", &PlaceDeck::lowest, MapValue<Lowest>{lowest_keys, check_lowest}),
      may("rest_on", &PlaceDeck::rest_on, MapValue<PlaceDeck::Support>{support_keys, check_support}),
      may("direction", &PlaceDeck::direction, DirectionValue{}),
  };
  return keys;
}

bool check_place(const Reader& reader, const Node& node, PlaceDeck& place) {
  place.place = node.spot.place;
  if (place.parts.empty()) {
    reader.refuse(*node.find("parts"), reader.name_of("parts"), "a list of at least one part");
    return false;
  }
  if (node.find("lowest") != nullptr || node.find("rest_on") != nullptr) return true;
  reader.error(node.spot, fmt::format("{} does nothing (must have lowest or rest_on)", reader.self()));
  return false;
}

/// Tells what is wrong with one entry of `place`.
class PlaceCheck {
 public:
  PlaceCheck(const Deck& deck, std::size_t index, Reading& reading)
      : deck_(deck), place_(deck.placements[index]), key_(fmt::format("place.{}", index)), reading_(reading) {
    for (const PartDeck& part : deck.parts) parts_.push_back(part.name);
    for (const WallDeck& wall : deck.walls)
      if (!wall.name.empty()) walls_.push_back(wall.name);
  }

  void check() const {
    for (const std::string& name : place_.parts) check_part(name);
    if (place_.rest_on) check_support_name(*place_.rest_on);
    if (!place_.direction && deck_.gravity.at(0) == Vec3{})
      tell(place_.place, fmt::format("{} has no direction (there is no gravity at time 0, which would give it): add "
                                     "direction",
                                     key_));
  }

 private:
  void tell(Place place, const std::string& text) const { reading_.errors.add({place, -1}, text); }

  static bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void check_part(const std::string& name) const {
    const auto part = std::find(parts_.begin(), parts_.end(), name);
    if (part == parts_.end())
      return tell(place_.place,
                  fmt::format("{}.parts names part '{}', which is unknown{}", key_, name, name_hint(name, parts_)));
    if (std::count(place_.parts.begin(), place_.parts.end(), name) > 1)
      return tell(place_.place,
                  fmt::format("{}.parts names part '{}' twice (it moves once): name it once", key_, name));
    const PartDeck& deck = deck_.parts[static_cast<std::size_t>(part - parts_.begin())];
    if (const std::string why = find_obstacle(deck); !why.empty())
      tell(place_.place,
           fmt::format("{} moves part '{}', which has {}, and that would not follow: place it by rotate and at", key_,
                       name, why));
  }

  /// Key of a part that gives a place or directions in space.
  std::string find_obstacle(const PartDeck& part) const {
    if (part.rigid && (part.rigid->center || part.rigid->inertia)) return "rigid.center or rigid.inertia";
    if (part.thickness_by_place) return "thickness.expression";
    if (!place_.lowest) return "";
    if (part.toward) return "toward";
    const auto material = std::find_if(deck_.materials.begin(), deck_.materials.end(),
                                       [&](const MaterialDeck& m) { return m.name == part.material; });
    return material != deck_.materials.end() && !material->law.vectors.empty() ? "a material with directions" : "";
  }

  void check_support_name(const PlaceDeck::Support& support) const {
    if (!support.wall.empty() && !has(walls_, support.wall))
      tell(support.place, fmt::format("{}.rest_on.wall is '{}', which is no name of a wall{}", key_, support.wall,
                                      walls_.empty() ? ": give the wall a name" : name_hint(support.wall, walls_)));
    if (support.part.empty()) return;
    if (!has(parts_, support.part))
      tell(support.place, fmt::format("{}.rest_on.part is '{}', which is unknown{}", key_, support.part,
                                      name_hint(support.part, parts_)));
    if (has(place_.parts, support.part))
      tell(support.place,
           fmt::format("{}.rest_on.part is '{}' (it moves itself): name a part that stays", key_, support.part));
  }

  const Deck& deck_;
  const PlaceDeck& place_;
  std::string key_;
  Reading& reading_;
  std::vector<std::string> parts_, walls_;
};

}  // namespace

MapValue<PlaceDeck> place_value() { return {place_keys, check_place}; }

void check_places(const Deck& deck, Reading& reading) {
  for (std::size_t i = 0; i < deck.placements.size(); ++i) PlaceCheck(deck, i, reading).check();
}

}  // namespace percuss
