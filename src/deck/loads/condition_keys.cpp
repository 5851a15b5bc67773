#include "src/deck/loads/condition_keys.hpp"

#include "src/deck/keys/switch_keys.hpp"
#include "src/deck/loads/node_values.hpp"

namespace percuss {
namespace {

// The directions that a key names: sets them in `active`.
bool read_direction(const Reader& reader, const std::string& name, const Node& node, std::array<bool, 6>& active) {
  const ChoiceValue<std::size_t> axis{{{"x", 0}, {"y", 1}, {"z", 2}, {"rx", 3}, {"ry", 4}, {"rz", 5}}};
  std::size_t i = 0;
  if (!axis.read(reader, name, node, i)) return false;
  if (active[i]) {
    reader.error(node.spot, fmt::format("{} is {} again (each axis once)", name, node.text));
    return false;
  }
  if (i > 2) reader.reading().rotations.push_back({node.spot, node.text, reader.in()});
  active[i] = true;
  return true;
}

struct FixedValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const {
    out.kind = ConditionDeck::Kind::fixed;
    if (node.kind == Node::Kind::scalar) return read_direction(reader, name, node, out.active);
    if (node.kind != Node::Kind::list || node.items.empty()) {
      reader.refuse(node, name, takes());
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      good = read_direction(reader, fmt::format("{}.{}", name, i), node.items[i], out.active) && good;
    }
    return good;
  }
  std::string takes() const { return "a list of directions: x, y, z, rx, ry, rz"; }
  Form form() const {
    const Form direction = word_form({"x", "y", "z", "rx", "ry", "rz"});
    return any_form({direction, list_form(direction, 1)});
  }
};

struct SymmetryValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const {
    out.kind = ConditionDeck::Kind::symmetry;
    const ChoiceValue<std::size_t> normal{{{"x", 0}, {"y", 1}, {"z", 2}}};
    std::size_t axis = 0;
    if (!normal.read(reader, name, node, axis)) return false;
    out.active[axis] = true;
    for (std::size_t i = 0; i < 3; ++i) out.active[3 + i] = i != axis;  // the normals of shells stay in the plane
    return true;
  }
  std::string takes() const { return "x | y | z, the normal of the plane"; }
  Form form() const { return word_form({"x", "y", "z"}); }
};

/// {x: curve, y: curve, z: curve}, at least one of them; of velocities also {rx: curve, ...}.
struct MotionValue {
  ConditionDeck::Kind kind;

  bool read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const {
    out.kind = kind;
    const auto read_one = [&](std::size_t i, const Reader& inner, const Entry& entry) {
      if (i > 2) reader.reading().rotations.push_back({entry.value.key, entry.name, reader.in()});
      out.active[i] = true;
      return read_motion(inner, entry, out.value[i]);
    };
    return read_directions(reader, name, node, takes(), list_directions(), read_one);
  }
  std::string takes() const {
    return fmt::format("a map from directions {} to curves", fmt::join(list_directions(), ", "));
  }
  Form form() const { return directions_form(list_directions()); }

 private:
  std::vector<std::string> list_directions() const {
    if (kind == ConditionDeck::Kind::velocity) return {"x", "y", "z", "rx", "ry", "rz"};
    return {"x", "y", "z"};
  }

  bool read_motion(const Reader& reader, const Entry& entry, Curve& curve) const {
    const std::string name = reader.name_of(entry.name);
    if (!CurveValue{}.read(reader, name, entry.value, curve)) return false;
    if (kind != ConditionDeck::Kind::displacement || curve(0) == 0) return true;
    reader.error(entry.value.spot,
                 fmt::format("{} is {:g} at time 0 (must be 0 there: the node would jump): start the table at [0, 0]",
                             name, curve(0)));
    return false;
  }
};

const Keys<TurnDeck>& turn_keys() {
  static const Keys<TurnDeck> keys = {
      need("axis", &TurnDeck::axis, ChoiceValue<std::size_t>{{{"x", 0}, {"y", 1}, {"z", 2}}}),
      need("through", &TurnDeck::through, vector3()),
      need("angular_velocity", &TurnDeck::angular_velocity, CurveValue{}),
  };
  return keys;
}

const Keys<ConditionDeck>& condition_kind_keys() {
  static const Keys<ConditionDeck> keys = {
      group<ConditionDeck>("fixed", FixedValue{}),
      group<ConditionDeck>("symmetry", SymmetryValue{}),
      group<ConditionDeck>("velocity", MotionValue{ConditionDeck::Kind::velocity}),
      group<ConditionDeck>("displacement", MotionValue{ConditionDeck::Kind::displacement}),
      may("turn", &ConditionDeck::turn, MapValue<TurnDeck>{turn_keys}),
  };
  return keys;
}

const Keys<ConditionDeck>& condition_keys() {
  static const Keys<ConditionDeck> keys = [] {
    Keys<ConditionDeck> all = {may("nodes", &ConditionDeck::where, SelectorValue{Chosen::nodes}),
                               may("body", &ConditionDeck::where, BodyValue{})};
    for (const auto& key : condition_kind_keys()) all.push_back(key);
    return with_switch(std::move(all));
  }();
  return keys;
}

/// A turn holds both directions across its axis.
void note_turn(ConditionDeck& condition) {
  if (!condition.turn) return;
  condition.kind = ConditionDeck::Kind::turn;
  for (std::size_t k = 0; k < 3; ++k) condition.active[k] = k != condition.turn->axis;
}

/// Checks a condition of a body against kinds that hold none: its nodes are not all on one plane, and it turns about
/// its centre.
bool check_condition_of_body(const Reader& reader, const std::string& name, const Node& node,
                             const ConditionDeck& condition) {
  if (find_body(condition.where).empty()) return true;
  if (condition.kind == ConditionDeck::Kind::symmetry) {
    reader.error(node.find("symmetry")->key, fmt::format("'{}' is a symmetry of a body (its nodes are not all on one "
                                                         "plane): use fixed",
                                                         name));
    return false;
  }
  if (!condition.turn) return true;
  reader.error(
      node.find("turn")->key,
      fmt::format("'{}' is a turn of a body (which turns about its mass centre): use velocity with rx, ry, rz, "
                  "or a joint to the ground",
                  name));
  return false;
}

}  // namespace

bool ConditionValue::read(const Reader& reader, const std::string& name, const Node& node, ConditionDeck& out) const {
  if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
  const Reader inner = reader.inside(name);
  const bool good = read_keys(inner, node, condition_keys(), out);
  std::vector<std::string> given, known;
  for (const auto& key : condition_kind_keys()) {
    known.push_back(key.name);
    if (node.find(key.name) != nullptr) given.push_back(key.name);
  }
  note_turn(out);
  if (given.size() == 1)
    return check_nodes_or_body(inner, node) && check_condition_of_body(reader, name, node, out) && good;
  const std::string what = given.empty() ? "does nothing" : fmt::format("has {}", fmt::join(given, " and "));
  reader.error(node.spot, fmt::format("'{}' {} (must have exactly one of {})", name, what, fmt::join(known, ", ")));
  return false;
}

Form ConditionValue::form() const {
  Form form = form_of(condition_keys());
  for (const auto& key : condition_kind_keys()) form.exactly_one.push_back(key.name);
  return form;
}

}  // namespace percuss
