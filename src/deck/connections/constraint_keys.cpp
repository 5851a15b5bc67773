#include "src/deck/connections/constraint_keys.hpp"

#include <algorithm>

#include "src/deck/connections/spring_end_value.hpp"

namespace percuss {
namespace {

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

NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value() {
  return {"constraint", {constraint_keys, check_constraint}};
}
NamedMapValue<EmbeddedDeck, MapValue<EmbeddedDeck>> embedded_value() { return {"embedded entry", {embedded_keys}}; }

}  // namespace percuss
