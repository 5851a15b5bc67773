#include "src/deck/sections/node_keys.hpp"

#include <fmt/format.h>

#include <limits>

#include "src/deck/sections/strength_keys.hpp"

namespace percuss {
namespace {

// --- springs

const Keys<HistoryPoint>& end_keys() {
  static const Keys<HistoryPoint> keys = {
      may("near", &HistoryPoint::near, vector3()),
      may("id", &HistoryPoint::id, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
  return keys;
}

bool check_end(const Reader& reader, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  if (point.near.has_value() != point.id.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of near and id)", reader.self(),
                                      point.near ? "both near and id" : "neither near nor id"));
  return false;
}

/// One node by its place or id, or a selector.
struct SpringEndValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, SpringEndDeck& out) const {
    const bool is_point = node.find("near") != nullptr || node.find("id") != nullptr || node.find("part") != nullptr;
    if (!is_point) return SelectorValue{}.read(reader, name, node, out.where);
    HistoryPoint point;
    if (!MapValue<HistoryPoint>{end_keys, check_end}.read(reader, name, node, point)) return false;
    out.point = std::move(point);
    return true;
  }
  std::string takes() const { return "a node as {near: [x, y, z]} or {id: n}, or a selector"; }
  Form form() const { return any_form({SelectorValue{}.form(), form_of(end_keys())}); }
};

/// Rows [elongation, force], at least two, elongations ascending.
struct ForceTableValue {
  bool read(const Reader& reader, const std::string& name, const Node& node,
            std::vector<std::array<double, 2>>& out) const {
    std::vector<std::array<double, 2>> rows;
    if (!ListValue<TupleValue<NumberValue, 2>>{}.read(reader, name, node, rows)) return false;
    if (rows.size() < 2) {
      reader.refuse(node, name, "at least two rows [elongation, force]");
      return false;
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (rows[i][0] > rows[i - 1][0]) continue;
      reader.error(node.items[i].spot, fmt::format("{}.{} has elongation {} after {} (elongations must ascend)", name,
                                                   i, rows[i][0], rows[i - 1][0]));
      return false;
    }
    out = std::move(rows);
    return true;
  }
  std::string takes() const { return "rows [elongation, force], elongations ascending"; }
  Form form() const { return list_form(TupleValue<NumberValue, 2>{}.form(), 2); }
};

const Keys<SpringDeck>& spring_failure_keys() {
  static const Keys<SpringDeck> keys = {
      may("force", &SpringDeck::largest_force, NumberValue{positive}),
      may("elongation", &SpringDeck::largest_elongation, NumberValue{positive}),
  };
  return keys;
}

const Keys<SpringDeck>& spring_keys() {
  using Acts = SpringDeck::Acts;
  static const Keys<SpringDeck> keys = {
      need("between", &SpringDeck::between, TupleValue<SpringEndValue, 2>{}),
      may("stiffness", &SpringDeck::stiffness, NumberValue{positive}),
      may("table", &SpringDeck::table, ForceTableValue{}),
      may("damping", &SpringDeck::damping, NumberValue{positive}),
      may("acts", &SpringDeck::acts,
          ChoiceValue<Acts>{{{"both", Acts::both}, {"tension", Acts::tension}, {"compression", Acts::compression}}}),
      may("rest_length", &SpringDeck::rest_length, NumberValue{not_negative}),
      group<SpringDeck>("failure", MapValue<SpringDeck>{spring_failure_keys}),
  };
  return keys;
}

bool check_spring(const Reader& reader, const Node& node, SpringDeck& spring) {
  const Node* table = node.find("table");
  if (table != nullptr && spring.stiffness) {
    reader.error(table->key, fmt::format("{} has both stiffness and table (must have one of them)", reader.self()));
    return false;
  }
  if (table != nullptr || spring.stiffness || spring.damping > 0) return true;
  reader.error(node.spot, fmt::format("{} does nothing (must have stiffness, table or damping)", reader.self()));
  return false;
}

// --- welds

const Keys<WeldDeck>& weld_failure_keys() {
  static const Keys<WeldDeck> keys = [] {
    Keys<WeldDeck> all = strength_keys<WeldDeck>();
    all.push_back(may("time", &WeldDeck::time, NumberValue{not_negative}));
    return all;
  }();
  return keys;
}

/// One place, or several.
struct PlacesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<Vec3>& out) const {
    const bool is_list = node.kind == Node::Kind::list && !node.items.empty() && node.items[0].kind == Node::Kind::list;
    if (is_list) return ListValue<TupleValue<NumberValue, 3>>{vector3()}.read(reader, name, node, out);
    Vec3 place{};
    if (!vector3().read(reader, name, node, place)) return false;
    out = {place};
    return true;
  }
  std::string takes() const { return "a list of 3, each a number, or a list of these"; }
  Form form() const { return any_form({vector3().form(), list_form(vector3().form(), 1)}); }
};

const Keys<WeldDeck>& weld_keys() {
  static const Keys<WeldDeck> keys = {
      need("between", &WeldDeck::between, TupleValue<SpringEndValue, 2>{}),
      may("at", &WeldDeck::at, PlacesValue{}),
      may("radius", &WeldDeck::radius, NumberValue{positive}),
      may("normal", &WeldDeck::normal, DirectionValue{}),
      group<WeldDeck>("failure", MapValue<WeldDeck>{weld_failure_keys, check_strengths<WeldDeck>}),
  };
  return keys;
}

/// A radius and places belong together, and have faces at their ends.
bool check_weld(const Reader& reader, const Node& node, WeldDeck& weld) {
  const Node* const radius = node.find("radius");
  const Node* const places = node.find("at");
  if (radius == nullptr && places == nullptr) return true;
  if (radius == nullptr || places == nullptr) {
    reader.error((radius == nullptr ? places : radius)->key,
                 fmt::format("{} is missing{} (a weld at places holds the faces within a radius around each)",
                             reader.name_of(radius == nullptr ? "radius" : "at"), reader.in()));
    return false;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (!weld.between[i].point) continue;
    reader.error(node.find("between")->items[i].spot,
                 fmt::format("{}.{} is a node (a weld with a radius is between faces): give a selector of faces",
                             reader.name_of("between"), i));
    return false;
  }
  return true;
}

// --- constraints

/// Directions in which nodes move equally.
struct EqualValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::array<bool, 3>& out) const {
    std::vector<std::size_t> equal;
    if (!ListValue<ChoiceValue<std::size_t>>{direction()}.read(reader, name, node, equal)) return false;
    for (const std::size_t k : equal) out[k] = true;
    if (!equal.empty()) return true;
    reader.refuse(node, name, "at least one of x, y and z");
    return false;
  }
  std::string takes() const { return "a list of directions: x, y, z"; }
  Form form() const { return list_form(direction().form(), 1); }

  static ChoiceValue<std::size_t> direction() { return {{{"x", 0}, {"y", 1}, {"z", 2}}}; }
};

const Keys<ConstraintDeck>& constraint_keys() {
  static const Keys<ConstraintDeck> keys = {
      need("equal", &ConstraintDeck::equal, EqualValue{}),
      may("nodes", &ConstraintDeck::nodes, SelectorValue{Chosen::nodes}),
      may("between", &ConstraintDeck::between, TupleValue<SpringEndValue, 2>{}),
  };
  return keys;
}

bool check_constraint(const Reader& reader, const Node& node, ConstraintDeck& constraint) {
  if (constraint.nodes.has_value() != constraint.between.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of nodes and between)", reader.self(),
                                      constraint.nodes ? "both nodes and between" : "neither nodes nor between"));
  return false;
}

}  // namespace

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value() { return {"spring", {spring_keys, check_spring}}; }
NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value() { return {"weld", {weld_keys, check_weld}}; }
NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value() {
  return {"constraint", {constraint_keys, check_constraint}};
}

}  // namespace percuss
