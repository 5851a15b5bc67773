#include "src/deck/reading/deck_keys.hpp"

#include <algorithm>
#include <optional>

#include "src/deck/connections/constraint_keys.hpp"
#include "src/deck/connections/joint_keys.hpp"
#include "src/deck/connections/spring_keys.hpp"
#include "src/deck/connections/turn_spring_keys.hpp"
#include "src/deck/connections/weld_keys.hpp"
#include "src/deck/contact/contact_keys.hpp"
#include "src/deck/contact/wall_keys.hpp"
#include "src/deck/keys/selector_keys.hpp"
#include "src/deck/loads/condition_keys.hpp"
#include "src/deck/loads/initial_keys.hpp"
#include "src/deck/loads/load_keys.hpp"
#include "src/deck/loads/sensor_keys.hpp"
#include "src/deck/loads/start_keys.hpp"
#include "src/deck/materials/failure_keys.hpp"
#include "src/deck/materials/material_keys.hpp"
#include "src/deck/output/output_keys.hpp"
#include "src/deck/parts/element_keys.hpp"
#include "src/deck/parts/mass_keys.hpp"
#include "src/deck/parts/mesh_change_keys.hpp"
#include "src/deck/parts/part_image_keys.hpp"
#include "src/deck/parts/part_keys.hpp"
#include "src/deck/parts/placement_keys.hpp"
#include "src/deck/parts/rigid_keys.hpp"
#include "src/deck/reading/time_keys.hpp"
#include "src/deck/units.hpp"
#include "src/deck/warning_rules.hpp"

namespace percuss {
namespace {

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
      group<Deck>("loads", loads_value()),
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
