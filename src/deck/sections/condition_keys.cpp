// Keys of `initial`, `loads`, `conditions` and `damping`.

#include "src/deck/sections/deck_keys.hpp"
#include "src/deck/sections/sensor_keys.hpp"

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

/// All nodes of a rigid body.
struct BodyValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, Selector& out) const {
    out.place = node.spot.place;
    std::string body;
    if (!NameValue{}.read(reader, name, node, body)) return false;
    out.name = body_prefix + body;
    return true;
  }
  std::string takes() const { return NameValue{}.takes(); }
  Form form() const { return NameValue{}.form(); }
};

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

const Keys<BlastDeck>& blast_keys() {
  using Burst = BlastDeck::Burst;
  static const Keys<BlastDeck> keys = {
      need("charge", &BlastDeck::charge, NumberValue{positive}),
      need("center", &BlastDeck::center, vector3()),
      may("time", &BlastDeck::time, NumberValue{}),
      may("negative_phase", &BlastDeck::has_negative_phase, BooleanValue{}),
      may("burst", &BlastDeck::burst, ChoiceValue<Burst>{{{"ground", Burst::ground}, {"air", Burst::air}}}),
  };
  return keys;
}

bool check_pressure(const Reader& reader, const Node& node, PressureDeck& pressure) {
  const Node *value = node.find("value"), *blast = node.find("blast");
  if ((value == nullptr) == (blast == nullptr)) {
    reader.error(node.spot, fmt::format("{} has {} (must have exactly one of value, blast)", reader.self(),
                                        value == nullptr ? "no pressure" : "value and blast"));
    return false;
  }
  if (!pressure.blast || !pressure.direction) return true;
  reader.error(node.find("direction")->key,
               fmt::format("{} has no effect (a blast acts against the normal)", reader.name_of("direction")));
  return false;
}

const Keys<PressureDeck>& pressure_keys() {
  static const Keys<PressureDeck> keys = with_switch<PressureDeck>({
      need("faces", &PressureDeck::where, SelectorValue{Chosen::faces}),
      may("value", &PressureDeck::value, CurveValue{}),
      may("blast", &PressureDeck::blast, MapValue<BlastDeck>{blast_keys}),
      may("direction", &PressureDeck::direction, DirectionValue{}),
  });
  return keys;
}

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

/// Reads a map from directions, at least one of them: read_one(place in `names`, inner reader, entry).
template <class ReadOne>
bool read_directions(const Reader& reader, const std::string& name, const Node& node, const std::string& takes,
                     const std::vector<std::string>& names, const ReadOne& read_one) {
  if (node.kind != Node::Kind::map || node.entries.empty()) {
    reader.refuse(node, name, takes);
    return false;
  }
  const Reader inner = reader.inside(name);
  bool good = true;
  for (const Entry& entry : node.entries) {
    const auto i = static_cast<std::size_t>(std::find(names.begin(), names.end(), entry.name) - names.begin());
    if (i < names.size()) {
      good = read_one(i, inner, entry) && good;
    } else {
      refuse_key(inner, entry, names, {});
      good = false;
    }
  }
  return good;
}

Form directions_form(const std::vector<std::string>& names) {
  Form form = map_form({});
  for (const std::string& name : names) form.keys.push_back({name, false, CurveValue{}.takes(), CurveValue{}.form()});
  form.least = 1;
  form.listed_as = "";
  return form;
}

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

/// The forces, or the moments, of a load on nodes: {x: curve, y: curve, z: curve}, at least one of them.
struct NodalValue {
  std::size_t first;  // 0: forces; 3: moments

  bool read(const Reader& reader, const std::string& name, const Node& node, NodalLoadDeck& out) const {
    const auto read_one = [&](std::size_t i, const Reader& inner, const Entry& entry) {
      if (first > 0) reader.reading().rotations.push_back({entry.value.key, "moment." + entry.name, reader.in()});
      out.active[first + i] = true;
      return CurveValue{}.read(inner, inner.name_of(entry.name), entry.value, out.value[first + i]);
    };
    return read_directions(reader, name, node, takes(), {"x", "y", "z"}, read_one);
  }
  std::string takes() const { return "a map from directions x, y, z to curves"; }
  Form form() const { return directions_form({"x", "y", "z"}); }
};

/// What acts on nodes or on a body.
bool check_nodes_or_body(const Reader& reader, const Node& node) {
  const bool has_nodes = node.find("nodes") != nullptr, has_body = node.find("body") != nullptr;
  if (has_nodes != has_body) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of nodes, body)", reader.self(),
                                      has_nodes ? "nodes and body" : "no nodes"));
  return false;
}

const Keys<NodalLoadDeck>& nodal_load_keys() {
  static const Keys<NodalLoadDeck> keys = with_switch<NodalLoadDeck>({
      may("nodes", &NodalLoadDeck::where, SelectorValue{Chosen::nodes}),
      may("body", &NodalLoadDeck::where, BodyValue{}),
      may("at", &NodalLoadDeck::at, vector3()),
      group<NodalLoadDeck>("force", NodalValue{0}),
      group<NodalLoadDeck>("moment", NodalValue{3}),
  });
  return keys;
}

bool check_nodal_load(const Reader& reader, const Node& node, NodalLoadDeck& load) {
  if (!check_nodes_or_body(reader, node)) return false;
  if (load.at && find_body(load.where).empty()) {
    reader.error(node.find("at")->key,
                 fmt::format("{} has no effect (only the load on a body has a point)", reader.name_of("at")));
    return false;
  }
  if (node.find("force") != nullptr || node.find("moment") != nullptr) return true;
  reader.error(node.spot, fmt::format("{} does nothing (must have a force, a moment or both)", reader.self()));
  return false;
}

const Keys<DampingDeck>& damping_keys() {
  static const Keys<DampingDeck> keys = {
      may("nodes", &DampingDeck::where, SelectorValue{Chosen::nodes}),
      need("coefficient", &DampingDeck::coefficient, CurveValue{true}),
  };
  return keys;
}

bool note_damping_place(const Reader&, const Node& node, DampingDeck& damping) {
  damping.where.place = node.spot.place;
  return true;
}

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

/// What holds no body: its nodes are not all on one plane, and it turns about its centre.
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

MapValue<InitialDeck> initial_value() { return {initial_keys, check_initial}; }
MapValue<PressureDeck> pressure_value() { return {pressure_keys, check_pressure}; }
MapValue<NodalLoadDeck> nodal_load_value() { return {nodal_load_keys, check_nodal_load}; }
MapValue<DampingDeck> damping_value() { return {damping_keys, note_damping_place}; }

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
