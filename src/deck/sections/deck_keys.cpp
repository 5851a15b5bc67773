// Keys of `time`, `elements`, with what parts may have of them, and `audit`, and the top of the deck.

#include "src/deck/sections/deck_keys.hpp"

#include "src/deck/sections/node_keys.hpp"
#include "src/deck/sections/sensor_keys.hpp"
#include "src/deck/sections/wall_keys.hpp"
#include "src/deck/units.hpp"
#include "src/deck/warning_rules.hpp"

namespace percuss {
namespace {

const Keys<MassScalingDeck>& mass_scaling_keys() {
  static const Keys<MassScalingDeck> keys = {
      need("step", &MassScalingDeck::step, NumberValue{positive}),
      may("max_added", &MassScalingDeck::max_added, NumberValue{positive}),
      may("every", &MassScalingDeck::every, IntegerValue{1, std::numeric_limits<long>::max()}),
  };
  return keys;
}

bool note_place(const Reader&, const Node& node, MassScalingDeck& scaling) {
  scaling.place = node.spot.place;
  return true;
}

const Keys<TimeDeck>& time_keys() {
  using StepEstimate = TimeDeck::StepEstimate;
  static const Keys<TimeDeck> keys = {
      need("end", &TimeDeck::end, NumberValue{positive}),
      may("step_scale", &TimeDeck::step_scale, NumberValue{{"above 0, at most 1", 0, 1, true}}),
      may("step_estimate", &TimeDeck::step_estimate,
          ChoiceValue<StepEstimate>{{{"element", StepEstimate::element}, {"global", StepEstimate::global}}}),
      may("mass_scaling", &TimeDeck::mass_scaling, mass_scaling_value()),
      may("until", &TimeDeck::until, SensorNameValue{}),
      may("max_step", &TimeDeck::max_step, NumberValue{positive}),
      may("max_steps", &TimeDeck::max_steps, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("collapse_ratio", &TimeDeck::collapse_ratio, NumberValue{{"at least 0 and below 1", 0, 1, false, true}}),
  };
  return keys;
}

using Hourglass = ElementDeck::Hourglass;
using Integration = ElementDeck::Integration;

ChoiceValue<Hourglass> hourglass_kind() {
  return {{{"assumed_strain", Hourglass::assumed_strain},
           {"stiffness", Hourglass::stiffness},
           {"viscous", Hourglass::viscous}}};
}

/// T: as below; membranes are a matter of a part.
template <class T>
ChoiceValue<Integration> integration_kind() {
  ChoiceValue<Integration> kinds{
      {{"one_point", Integration::one_point}, {"full", Integration::full}, {"thick_shell", Integration::thick_shell}}};
  if constexpr (std::is_same_v<T, PartElementDeck>) kinds.choices.push_back({"membrane", Integration::membrane});
  return kinds;
}

/// Points across a thick shell.
struct ThickPointsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, int& out) const {
    int points = 0;
    if (!IntegerValue{3, 5}.read(reader, name, node, points)) return false;
    if (points == 4) {
      reader.refuse(node, name, takes());
      return false;
    }
    out = points;
    return true;
  }
  bool read(const Reader& reader, const std::string& name, const Node& node, std::optional<int>& out) const {
    int points = 0;
    if (!read(reader, name, node, points)) return false;
    out = points;
    return true;
  }
  std::string takes() const { return "3 or 5"; }
  Form form() const { return IntegerValue{3, 5}.form(); }
};

/// T: ElementDeck or PartElementDeck, whose members have the same names.
template <class T>
const Keys<T>& integration_keys() {
  using Across = ElementDeck::Across;
  static const Keys<T> keys = {
      need("kind", &T::integration, integration_kind<T>()),
      may("points", &T::thick_points, ThickPointsValue{}),
      may("across", &T::across,
          ChoiceValue<Across>{{{"first", Across::first},
                               {"second", Across::second},
                               {"third", Across::third},
                               {"shortest", Across::shortest}}}),
  };
  return keys;
}

/// The kind alone, or a map.
template <class T>
struct IntegrationValue {
  MapValue<T> map{integration_keys<T>};

  bool read(const Reader& reader, const std::string& name, const Node& node, T& out) const {
    if (node.kind != Node::Kind::scalar) return map.read(reader, name, node, out);
    Integration kind{};
    if (!integration_kind<T>().read(reader, name, node, kind)) return false;
    out.integration = kind;
    return true;
  }
  std::string takes() const { return integration_kind<T>().takes() + ", or a map"; }
  Form form() const { return any_form({integration_kind<T>().form(), map.form()}); }
};

/// T: ElementDeck or PartElementDeck, whose members have the same names.
template <class T>
const Keys<T>& hourglass_keys() {
  static const Keys<T> keys = {
      may("kind", &T::hourglass, hourglass_kind()),
      may("coefficient", &T::hourglass_coefficient, NumberValue{{"from 0 to 1", 0, 1}}),
  };
  return keys;
}

/// The kind alone, or a map.
template <class T>
struct HourglassValue {
  MapValue<T> map{hourglass_keys<T>};

  bool read(const Reader& reader, const std::string& name, const Node& node, T& out) const {
    if (node.kind != Node::Kind::scalar) return map.read(reader, name, node, out);
    Hourglass kind{};
    if (!hourglass_kind().read(reader, name, node, kind)) return false;
    out.hourglass = kind;
    return true;
  }
  std::string takes() const { return hourglass_kind().takes() + ", or a map"; }
  Form form() const { return any_form({hourglass_kind().form(), map.form()}); }
};

template <class T>
const Keys<T>& viscosity_keys() {
  static const Keys<T> keys = {
      may("linear", &T::linear_viscosity, NumberValue{not_negative}),
      may("quadratic", &T::quadratic_viscosity, NumberValue{not_negative}),
  };
  return keys;
}

/// Those that a part may have too.
template <class T>
Keys<T> settings_keys() {
  return {
      group<T>("integration", IntegrationValue<T>{}),
      group<T>("hourglass", HourglassValue<T>{}),
      group<T>("bulk_viscosity", MapValue<T>{viscosity_keys<T>}),
      may("stiffness_damping", &T::stiffness_damping, NumberValue{not_negative}),
      may("shell_hourglass", &T::shell_hourglass, NumberValue{{"above 0 and at most 1", 0, 1, true, false}}),
  };
}

const Keys<ElementDeck>& element_keys() {
  static const Keys<ElementDeck> keys = [] {
    Keys<ElementDeck> all = settings_keys<ElementDeck>();
    all.push_back(may("resist_folding", &ElementDeck::resist_folding, BooleanValue{}));
    all.push_back(may("skip_resting", &ElementDeck::skip_resting, BooleanValue{}));
    all.push_back(may("tetrahedra", &ElementDeck::tetrahedra,
                      ChoiceValue<ElementDeck::Tetrahedra>{
                          {{"mixed", ElementDeck::Tetrahedra::mixed}, {"plain", ElementDeck::Tetrahedra::plain}}}));
    return all;
  }();
  return keys;
}

/// What only thick shells have.
void check_thick_keys(const Reader& reader, const Node& node, const ElementDeck& deck) {
  const Node* integration = node.find("integration");
  if (integration == nullptr || integration->kind != Node::Kind::map || integration->broken) return;
  if (deck.integration == Integration::thick_shell) return;
  for (const char* key : {"points", "across"})
    if (const Node* given = integration->find(key))
      reader.error(given->key,
                   fmt::format("{} has no effect{} (only thick shells have points across a thickness): give "
                               "kind: thick_shell, or leave it out",
                               reader.name_of(std::string("integration.") + key), reader.in()));
}

/// Settings that do nothing beside the others that hold there.
void check_settings(const Reader& reader, const Node& node, const ElementDeck& deck) {
  check_thick_keys(reader, node, deck);
  const Node* hourglass = node.find("hourglass");
  if (hourglass == nullptr || hourglass->broken) return;
  if (deck.integration != Integration::one_point) {
    const char* const why = deck.integration == Integration::full ? "full, which leaves no hourglass modes"
                            : deck.integration == Integration::thick_shell
                                ? "thick_shell, which leaves no hourglass modes"
                                : "membrane; shell_hourglass is the key of shells";
    reader.error(hourglass->key,
                 fmt::format("{} has no effect{} (integration is {})", reader.name_of("hourglass"), reader.in(), why));
    return;
  }
  if (hourglass->kind != Node::Kind::map || deck.hourglass != Hourglass::assumed_strain) return;
  const Node *coefficient = hourglass->find("coefficient"), *kind = hourglass->find("kind");
  if (coefficient == nullptr || (kind != nullptr && kind->text != "assumed_strain")) return;
  reader.error(
      coefficient->key,
      fmt::format(
          "{} has no effect{} (assumed_strain follows from the material): give kind: stiffness or kind: viscous",
          reader.name_of("hourglass.coefficient"), reader.in()));
}

/// Membranes are shells, with one point across each layer and nothing that bends.
void check_membrane(const Reader& reader, const Node& node, const PartDeck& part) {
  if (!part.is_membrane()) return;
  const bool is_file = std::holds_alternative<FileMesh>(part.shape);
  if (!is_file && !is_shell_shape(part.shape))
    reader.error(node.find("integration")->key,
                 fmt::format("{} is membrane{} (membranes are shells, and it has none): give it a shape of shells, or "
                             "leave it out",
                             reader.name_of("integration"), reader.in()));
  if (const Node* points = node.find("points"))
    reader.error(points->key, fmt::format("{} has no effect{} (a layer of a membrane has one point): remove it",
                                          reader.name_of("points"), reader.in()));
  if (const Node* reference = node.find("reference"))
    reader.error(reference->key, fmt::format("{} has no effect{} (a membrane does not bend, wherever its mesh lies): "
                                             "remove it",
                                             reader.name_of("reference"), reader.in()));
}

/// Wedges and pyramids have one point and the stiffness form of hourglass control.
void check_one_point(const Reader& reader, const Node& node, const PartDeck& part) {
  const char* const elements = part.elements == PartDeck::Elements::wedges ? "wedges" : "pyramids";
  if (const Node* given = node.find("integration"))
    reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}; the key is for hexahedra)",
                                         reader.name_of("integration"), reader.in(), elements));
  const Node* given = node.find("hourglass");
  if (given == nullptr || part.own_elements.hourglass == Hourglass::stiffness) return;
  reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}, which have the stiffness form alone): "
                                       "give kind: stiffness with its coefficient, or leave it out",
                                       reader.name_of("hourglass"), reader.in(), elements));
}

/// What has no hexahedra has no hourglass modes; shells and beams have no bulk viscosity either.
void check_kind(const Reader& reader, const Node& node, const PartDeck& part) {
  if (std::holds_alternative<FileMesh>(part.shape)) return;
  const bool is_shell = is_shell_shape(part.shape);
  const Node* of_shells = node.find("shell_hourglass");
  if (of_shells != nullptr && !is_shell)
    reader.error(of_shells->key, fmt::format("{} has no effect{} (it applies to shells): remove it",
                                             reader.name_of("shell_hourglass"), reader.in()));
  const bool is_line = std::holds_alternative<LineShape>(part.shape), is_solid = !is_shell && !is_line;
  if (is_solid && part.elements == PartDeck::Elements::hexahedra) return;
  if (is_solid && !part.is_cut_into_tetrahedra()) return check_one_point(reader, node, part);
  for (const std::string key : {"integration", "hourglass", "bulk_viscosity"}) {
    const Node* given = node.find(key);
    const bool is_viscosity = key == "bulk_viscosity";
    if (given == nullptr || (is_solid && is_viscosity) || (key == "integration" && part.is_membrane())) continue;
    reader.error(given->key, fmt::format("{} has no effect{} (its elements are {}; this applies to hexahedra{})",
                                         reader.name_of(key), reader.in(),
                                         is_shell  ? "shells"
                                         : is_line ? "beams"
                                                   : "tetrahedra",
                                         is_viscosity ? " and tetrahedra" : ""));
  }
}

const Keys<AuditDeck>& audit_keys() {
  static const Keys<AuditDeck> keys = {
      may("max_energy_error", &AuditDeck::max_energy_error, NumberValue{positive}),
      may("max_momentum_error", &AuditDeck::max_momentum_error, NumberValue{positive}),
      may("max_contact_gain", &AuditDeck::max_contact_gain, NumberValue{positive}),
  };
  return keys;
}

/// [x, y, z], each a number or a curve.
struct GravityValue {
  TupleValue<CurveValue, 3> values;

  bool read(const Reader& reader, const std::string& name, const Node& node, Deck& out) const {
    return values.read(reader, name, node, out.gravity.along);
  }
  std::string takes() const { return values.takes(); }
  Form form() const { return values.form(); }
};

const Keys<Deck>& load_keys() {
  static const Keys<Deck> keys = {
      group<Deck>("gravity", GravityValue{}),
      may("pressure", &Deck::pressures, ListValue<MapValue<PressureDeck>>{pressure_value()}),
      may("nodal", &Deck::nodal_loads, ListValue<MapValue<NodalLoadDeck>>{nodal_load_value()}),
  };
  return keys;
}

/// Names of rules, each of which a warning may have.
struct RulesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, Deck& out) const {
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    const std::vector<std::string> known = list_names();
    bool good = true;
    for (const Node& item : node.items) {
      if (item.broken) {
        good = false;
      } else if (item.kind != Node::Kind::scalar || std::find(known.begin(), known.end(), item.text) == known.end()) {
        const std::string near = item.kind == Node::Kind::scalar ? nearest_name(item.text, known) : "";
        const std::string hint = near.empty() ? "docs/checks.md lists them" : "did you mean '" + near + "'?";
        reader.error(item.spot, fmt::format("{} names {} (no warning has this rule): {}", name, describe(item), hint));
        good = false;
      } else {
        out.silenced.insert(item.text);
      }
    }
    return good;
  }
  std::string takes() const { return "a list of rules"; }
  Form form() const { return list_form(word_form(list_names())); }

 private:
  static std::vector<std::string> list_names() {
    std::vector<std::string> names;
    for (const WarningRule& rule : warning_rules()) names.push_back(rule.name);
    return names;
  }
};

void list_keys(const Form& form, const std::string& path, std::vector<DeckKey>& out) {
  if (form.listed_as) return;
  for (const FormKey& key : form.keys) {
    const std::string full = path.empty() ? key.name : path + "." + key.name;
    out.push_back({full, key.takes, key.required});
    list_keys(key.form, full, out);
  }
  const std::string step = form.kind == Form::Kind::list ? ".N" : form.kind == Form::Kind::named_maps ? ".NAME" : "";
  for (const Form& inner : form.inner) list_keys(inner, path + step, out);
}

/// Units by their names; kept in the form of Units::text().
struct UnitsValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
    if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
    const std::optional<Units> units = find_units(node.text);
    if (!units) {
      reader.refuse(node, name,
                    fmt::format("a length, a mass and a time, such as '{}', or others of {}, in this order",
                                fmt::join(list_unit_systems(), "', '"), list_base_units()));
      return false;
    }
    out = units->text();
    return true;
  }
  std::string takes() const { return "a system of units"; }
  Form form() const { return TextValue{}.form(); }
};

}  // namespace

MapValue<TimeDeck> time_value() { return {time_keys}; }
MapValue<MassScalingDeck> mass_scaling_value() { return {mass_scaling_keys, note_place}; }
MapValue<AuditDeck> audit_value() { return {audit_keys}; }
MapValue<ElementDeck> element_value() { return {element_keys}; }

Keys<PartElementDeck> part_element_keys() { return settings_keys<PartElementDeck>(); }

void check_element_settings(const Deck& deck, const Node& root, Reading& reading) {
  const Node *elements = root.find("elements"), *parts = root.find("parts");
  if (elements != nullptr && elements->kind == Node::Kind::map)
    check_settings(Reader(reading).inside("elements"), *elements, deck.elements);
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartDeck& part = deck.parts[p];
    const Node* node = parts->find(part.name);
    if (node == nullptr || node->kind != Node::Kind::map || reading.shapeless.contains(part.name)) continue;
    const Reader reader = Reader(reading).inside_named("part", part.name);
    check_settings(reader, *node, deck.find_elements(p));
    check_kind(reader, *node, part);
    check_membrane(reader, *node, part);
  }
}

const Keys<Deck>& deck_keys() {
  static const Keys<Deck> keys = {
      may("title", &Deck::title, TextValue{}),
      may("units", &Deck::units, UnitsValue{}),
      group<Deck>("silence", RulesValue{}),
      need("time", &Deck::time, time_value()),
      need("parts", &Deck::parts, NamedMapValue<PartDeck, PartValue>{"part", {}}),
      need("materials", &Deck::materials, NamedMapValue<MaterialDeck, MaterialValue>{"material", {}}),
      may("mirror", &Deck::mirrors, ListValue<MapValue<MirrorDeck>>{mirror_value()}),
      may("pattern", &Deck::patterns, ListValue<MapValue<PatternDeck>>{pattern_value()}),
      may("place", &Deck::placements, ListValue<MapValue<PlaceDeck>>{place_value()}),
      may("join", &Deck::joins, JoinValue{}),
      may("imperfections", &Deck::imperfections, ListValue<MapValue<ImperfectionDeck>>{imperfection_value()}),
      may("added_mass", &Deck::added_masses, ListValue<MapValue<AddedMassDeck>>{added_mass_value()}),
      may("rigid_sets", &Deck::rigid_sets, rigid_sets_value()),
      may("springs", &Deck::springs, springs_value()),
      may("welds", &Deck::welds, welds_value()),
      may("constraints", &Deck::constraints, constraints_value()),
      may("embedded", &Deck::embedded, embedded_value()),
      may("joints", &Deck::joints, joints_value()),
      may("turn_springs", &Deck::turn_springs, turn_springs_value()),
      may("elements", &Deck::elements, element_value()),
      may("erosion", &Deck::erosion, erosion_value()),
      may("initial", &Deck::initial, ListValue<MapValue<InitialDeck>>{initial_value()}),
      may("start", &Deck::start, start_value()),
      may("sensors", &Deck::sensors, sensors_value()),
      group<Deck>("loads", MapValue<Deck>{load_keys}),
      may("conditions", &Deck::conditions, ListValue<ConditionValue>{}),
      may("damping", &Deck::dampings, ListValue<MapValue<DampingDeck>>{damping_value()}),
      may("walls", &Deck::walls, ListValue<MapValue<WallDeck>>{wall_value()}),
      may("contact", &Deck::contact, ContactValue{}),
      may("output", &Deck::output, output_value()),
      may("audit", &Deck::audit, audit_value()),
  };
  return keys;
}

std::vector<DeckKey> list_deck_keys() {
  std::vector<DeckKey> all;
  list_keys(form_of(deck_keys()), "", all);
  list_keys(form_of(selector_keys()), "SELECTOR", all);
  return all;
}

}  // namespace percuss
