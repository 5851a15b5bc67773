#include "src/deck/sections/node_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/deck/keys/force_table_value.hpp"
#include "src/deck/keys/strength_keys.hpp"
#include "src/deck/sections/deck_keys.hpp"

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
      may("table", &SpringDeck::table, ForceTableValue{"elongation", "force"}),
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
      may("from", &WeldDeck::from, vector3()),
      may("to", &WeldDeck::to, vector3()),
      may("pitch", &WeldDeck::pitch, NumberValue{positive}),
      may("file", &WeldDeck::file, FileValue{}),
      may("radius", &WeldDeck::radius, NumberValue{positive}),
      may("normal", &WeldDeck::normal, DirectionValue{}),
      group<WeldDeck>("failure", MapValue<WeldDeck>{weld_failure_keys, check_strengths<WeldDeck>}),
  };
  return keys;
}

/// Most welds of a row: a pitch in other units than the places would make more.
constexpr double most_in_row = 10000;

/// Fills weld.at: even distances of at most the pitch, the first and the last at the ends.
bool fill_row(const Reader& reader, const Node& node, WeldDeck& weld) {
  for (const char* key : {"from", "to", "pitch"}) {
    if (node.find(key) != nullptr) continue;
    reader.error(node.spot, fmt::format("{} is missing{} (a row of welds has from, to and pitch)", reader.name_of(key),
                                        reader.in()));
    return false;
  }
  const Vec3 &a = *weld.from, &b = *weld.to;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const double spaces = std::max(1.0, std::ceil(length / *weld.pitch * (1 - 1e-9)));
  if (!(length > 0) || spaces >= most_in_row) {
    reader.error(node.find(length > 0 ? "pitch" : "to")->spot,
                 length > 0
                     ? fmt::format("{} is {:g}{} (the row of length {:g} would have {:.0f} welds): give a larger one",
                                   reader.name_of("pitch"), *weld.pitch, reader.in(), length, spaces + 1)
                     : fmt::format("{} is the same place as {}{} (a row has two ends): use at for one weld",
                                   reader.name_of("to"), reader.name_of("from"), reader.in()));
    return false;
  }
  for (double i = 0; i <= spaces; ++i) {
    Vec3& x = weld.at.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) x[k] = (a[k] * (spaces - i) + b[k] * i) / spaces;
  }
  return true;
}

/// The keys that say where welds are: none, or one way of these. Tells what does not go together.
bool check_weld_places(const Reader& reader, const Node& node, WeldDeck& weld) {
  const bool is_row = weld.from || weld.to || weld.pitch;
  const int ways = (weld.at.empty() ? 0 : 1) + (is_row ? 1 : 0) + (weld.file.empty() ? 0 : 1);
  if (ways > 1) {
    reader.error(node.spot, fmt::format("{} has places in several ways (must have one of at; from, to and pitch; file)",
                                        reader.self()));
    return false;
  }
  if (ways == 1 && !weld.radius && weld.file.empty()) {
    reader.error(node.find(is_row ? (weld.from ? "from"
                                     : weld.to ? "to"
                                               : "pitch")
                                  : "at")
                     ->key,
                 fmt::format("{} is missing{} (a weld at places holds the faces within a radius around each)",
                             reader.name_of("radius"), reader.in()));
    return false;
  }
  if (ways == 0 && weld.radius) {
    reader.error(node.find("radius")->key,
                 fmt::format("{} is missing{} (a weld at places holds the faces within a radius around each)",
                             reader.name_of("at"), reader.in()));
    return false;
  }
  return !is_row || fill_row(reader, node, weld);
}

/// A radius and places belong together, and have faces at their ends.
bool check_weld(const Reader& reader, const Node& node, WeldDeck& weld) {
  if (!check_weld_places(reader, node, weld)) return false;
  if (!weld.is_between_faces()) return true;
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

const Keys<EquationTermDeck>& equation_term_keys() {
  static const Keys<EquationTermDeck> keys = {
      need("nodes", &EquationTermDeck::of, SpringEndValue{}),
      need("direction", &EquationTermDeck::direction, EqualValue::direction()),
      need("factor", &EquationTermDeck::factor, NumberValue{}),
  };
  return keys;
}

const Keys<ConstraintDeck>& constraint_keys() {
  static const Keys<ConstraintDeck> keys = {
      may("equal", &ConstraintDeck::equal, EqualValue{}),
      may("nodes", &ConstraintDeck::nodes, SelectorValue{Chosen::nodes}),
      may("between", &ConstraintDeck::between, TupleValue<SpringEndValue, 2>{}),
      may("equation", &ConstraintDeck::equation, ListValue<MapValue<EquationTermDeck>>{{equation_term_keys}}),
      may("sum", &ConstraintDeck::sum, CurveValue{}),
  };
  return keys;
}

/// An equation of its own: nothing that makes nodes equal goes with it.
bool check_equation(const Reader& reader, const Node& node, const ConstraintDeck& constraint) {
  for (const char* const other : {"equal", "nodes", "between"}) {
    if (node.find(other) == nullptr) continue;
    reader.error(node.find(other)->key,
                 fmt::format("{} has equation and {} (an equation has its nodes and directions in its terms): leave "
                             "one of them out",
                             reader.self(), other));
    return false;
  }
  for (const EquationTermDeck& term : constraint.equation) {
    if (term.factor != 0) continue;
    reader.error(
        node.find("equation")->key,
        fmt::format("{} has a factor of 0 (it would not count): leave the term out", reader.name_of("equation")));
    return false;
  }
  if (!constraint.sum || (*constraint.sum)(0) == 0) return true;
  reader.error(node.find("sum")->key, fmt::format("{} is {:g} at time 0 (must be 0 there: the nodes would jump): start "
                                                  "the table at [0, 0]",
                                                  reader.name_of("sum"), (*constraint.sum)(0)));
  return false;
}

bool check_constraint(const Reader& reader, const Node& node, ConstraintDeck& constraint) {
  if (node.find("equation") != nullptr) return check_equation(reader, node, constraint);
  if (node.find("sum") != nullptr) {
    reader.error(node.find("sum")->key,
                 fmt::format("{} is without equation (it is the sum of its terms): add one", reader.name_of("sum")));
    return false;
  }
  if (node.find("equal") == nullptr) {
    reader.error(node.spot,
                 fmt::format("{} is missing{} (must have equal or equation)", reader.name_of("equal"), reader.in()));
    return false;
  }
  if (constraint.nodes.has_value() != constraint.between.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of nodes and between)", reader.self(),
                                      constraint.nodes ? "both nodes and between" : "neither nodes nor between"));
  return false;
}

// --- embedded

/// Parts by name, each once; all of them: none.
struct HostsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<std::string>& out) const {
    if (node.kind == Node::Kind::scalar) {
      std::string part;
      if (!PartNameValue{}.read(reader, name, node, part)) return false;
      if (!part.empty()) out.push_back(part);
      return true;
    }
    std::vector<std::string> parts;
    if (!ListValue<PartNameValue>{}.read(reader, name, node, parts)) return false;
    for (const std::string& part : parts) {
      if (!part.empty() && std::find(out.begin(), out.end(), part) == out.end()) {
        out.push_back(part);
        continue;
      }
      reader.refuse(node, name, "names from parts, each once");
      return false;
    }
    if (!out.empty()) return true;
    reader.refuse(node, name, "at least one part");
    return false;
  }
  std::string takes() const { return "a name from parts, a list of them, or all"; }
  Form form() const { return any_form({PartNameValue{}.form(), list_form(PartNameValue{}.form(), 1)}); }
};

const Keys<EmbeddedDeck>& embedded_keys() {
  static const Keys<EmbeddedDeck> keys = {
      need("nodes", &EmbeddedDeck::nodes, SelectorValue{Chosen::nodes}),
      may("in", &EmbeddedDeck::hosts, HostsValue{}),
      may("tolerance", &EmbeddedDeck::tolerance, NumberValue{not_negative}),
  };
  return keys;
}

}  // namespace

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value() { return {"spring", {spring_keys, check_spring}}; }
NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value() { return {"weld", {weld_keys, check_weld}}; }
NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value() {
  return {"constraint", {constraint_keys, check_constraint}};
}
NamedMapValue<EmbeddedDeck, MapValue<EmbeddedDeck>> embedded_value() { return {"embedded entry", {embedded_keys}}; }

}  // namespace percuss
