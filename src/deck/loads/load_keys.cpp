#include "src/deck/loads/load_keys.hpp"

#include "src/deck/keys/switch_keys.hpp"
#include "src/deck/loads/node_values.hpp"

namespace percuss {
namespace {

/// [x, y, z], each a number or a curve.
struct GravityValue {
  TupleValue<CurveValue, 3> values;

  bool read(const Reader& reader, const std::string& name, const Node& node, Deck& out) const {
    return values.read(reader, name, node, out.gravity.along);
  }
  std::string takes() const { return values.takes(); }
  Form form() const { return values.form(); }
};

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

const Keys<Deck>& load_keys() {
  static const Keys<Deck> keys = {
      group<Deck>("gravity", GravityValue{}),
      may("pressure", &Deck::pressures, ListValue<MapValue<PressureDeck>>{{pressure_keys, check_pressure}}),
      may("nodal", &Deck::nodal_loads, ListValue<MapValue<NodalLoadDeck>>{{nodal_load_keys, check_nodal_load}}),
  };
  return keys;
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

}  // namespace

MapValue<Deck> loads_value() { return {load_keys}; }
MapValue<DampingDeck> damping_value() { return {damping_keys, note_damping_place}; }

}  // namespace percuss
