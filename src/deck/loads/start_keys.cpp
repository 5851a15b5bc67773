#include "src/deck/loads/start_keys.hpp"

#include "src/deck/keys/file_value.hpp"
#include "src/deck/laws/fluid_at_rest.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {
namespace {

const Keys<RelaxationDeck>& relaxation_keys() {
  using Unsettled = RelaxationDeck::Unsettled;
  static const Keys<RelaxationDeck> keys = {
      may("tolerance", &RelaxationDeck::tolerance, NumberValue{{"above 0 and below 1", 0, 1, true, true}}),
      may("max_steps", &RelaxationDeck::max_steps, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("unsettled", &RelaxationDeck::unsettled,
          ChoiceValue<Unsettled>{{{"refuse", Unsettled::refuse}, {"warn", Unsettled::warn}}}),
      may("ramp", &RelaxationDeck::ramp, IntegerValue{0, std::numeric_limits<int>::max()}),
      may("damping", &RelaxationDeck::damping, NumberValue{positive}),
      may("hold", &RelaxationDeck::hold, ListValue<SelectorValue>{{Chosen::nodes}}),
  };
  return keys;
}

const Keys<PreloadDeck>& preload_keys() {
  static const Keys<PreloadDeck> keys = {
      need("part", &PreloadDeck::part, PartNameValue{}),
      may("point", &PreloadDeck::point, vector3()),
      may("normal", &PreloadDeck::normal, DirectionValue{}),
      need("force", &PreloadDeck::force, NumberValue{}),
  };
  return keys;
}

/// A plane has a point and a normal.
bool check_plane(const Reader& reader, const Node& node, PreloadDeck&) {
  const Node *point = node.find("point"), *normal = node.find("normal");
  if ((point == nullptr) == (normal == nullptr)) return true;
  reader.error(node.key,
               fmt::format("{} is missing (a section has point and normal; without both, each beam of the part "
                           "has the force)",
                           reader.name_of(point == nullptr ? "point" : "normal")));
  return false;
}

std::vector<std::pair<std::string, StartQuantity>> start_quantities() {
  return {{"stress", StartQuantity::stress},
          {"equivalent_plastic_strain", StartQuantity::plastic_strain},
          {"temperature", StartQuantity::temperature},
          {"velocity", StartQuantity::velocity}};
}

const Keys<StartFieldsDeck>& start_fields_keys() {
  static const Keys<StartFieldsDeck> keys = {
      need("file", &StartFieldsDeck::file, FileValue{}),
      may("part", &StartFieldsDeck::part, PartNameValue{}),
      may("time", &StartFieldsDeck::time, NumberValue{}),
      may("take", &StartFieldsDeck::take, ListValue<ChoiceValue<StartQuantity>>{{start_quantities()}}),
  };
  return keys;
}

bool note_fields_place(const Reader&, const Node& node, StartFieldsDeck& fields) {
  fields.place = node.spot.place;
  return true;
}

const Keys<HydrostaticDeck>& hydrostatic_keys() {
  static const Keys<HydrostaticDeck> keys = {
      need("parts", &HydrostaticDeck::parts, ListValue<PartNameValue>{}),
      need("surface", &HydrostaticDeck::surface, vector3()),
      may("pressure", &HydrostaticDeck::pressure, NumberValue{not_negative}),
  };
  return keys;
}

bool note_hydrostatic_place(const Reader&, const Node& node, HydrostaticDeck& hydrostatic) {
  hydrostatic.place = node.spot.place;
  return true;
}

const Keys<StartDeck>& start_keys() {
  static const Keys<StartDeck> keys = {
      may("relaxation", &StartDeck::relaxation, MapValue<RelaxationDeck>{relaxation_keys}),
      may("hydrostatic", &StartDeck::hydrostatic,
          ListValue<MapValue<HydrostaticDeck>>{{hydrostatic_keys, note_hydrostatic_place}}),
      may("fields", &StartDeck::fields, ListValue<MapValue<StartFieldsDeck>>{{start_fields_keys, note_fields_place}}),
      may("preload", &StartDeck::preloads,
          NamedMapValue<PreloadDeck, MapValue<PreloadDeck>>{"preload", {preload_keys, check_plane}}),
  };
  return keys;
}

/// A preload needs the damped steps, in which the rest of the scene comes into balance with it.
bool check_preloads(const Reader& reader, const Node& node, StartDeck& start) {
  if (start.preloads.empty() || start.relaxation) return true;
  reader.error(node.find("preload")->key,
               fmt::format("{} has no effect (it acts during a relaxation): give the key relaxation as well, for "
                           "example relaxation: {{}}",
                           reader.name_of("preload")));
  return false;
}

/// Why a part cannot begin as a fluid at rest; empty: it can. Names that are wrong are reported already.
std::string find_obstacle(const Deck& deck, const HydrostaticDeck& hydrostatic, const std::string& name) {
  if (name.empty()) return "all is given (must be parts by their names): name the fluids";
  const auto part = std::find_if(deck.parts.begin(), deck.parts.end(), [&](const auto& of) { return of.name == name; });
  if (part == deck.parts.end()) return "";
  const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                     [&](const MaterialDeck& of) { return of.name == part->material; });
  if (material == deck.materials.end()) return "";
  const std::string of_material = fmt::format("part '{}' of material '{}'", name, part->material);
  if (part->rigid || !find_traits(*material).needs_equation_of_state || !material->equation_of_state)
    return of_material + " is no fluid (only a fluid has the pressure of its depth everywhere): leave it out";
  if (can_rest(*material, hydrostatic.pressure)) return "";
  return fmt::format("{} cannot rest with the pressure {:g} (its equation of state does not reach it without heat): {}",
                     of_material, hydrostatic.pressure, "give pressure, the pressure on its surface, or leave it out");
}

void check_hydrostatic(const Deck& deck, const Node& root, Reading& reading) {
  if (!reading.errors.empty()) return;  // equations of state are evaluated
  std::vector<std::string> known;
  for (const HydrostaticDeck& hydrostatic : deck.start.hydrostatic) {
    for (const std::string& name : hydrostatic.parts) {
      std::string why = find_obstacle(deck, hydrostatic, name);
      if (std::find(known.begin(), known.end(), name) != known.end())
        why = fmt::format("part '{}' is named twice (it has one surface): leave one out", name);
      known.push_back(name);
      if (!why.empty()) reading.errors.add({hydrostatic.place}, "start.hydrostatic: " + why);
    }
  }
  if (deck.start.hydrostatic.empty() || deck.gravity.at(0) != Vec3{}) return;
  reading.errors.add(root.find("start")->find("hydrostatic")->key,
                     "start.hydrostatic has no effect (loads.gravity is 0 at time 0): give gravity, or leave it out");
}

}  // namespace

MapValue<StartDeck> start_value() { return {start_keys, check_preloads}; }

void check_start(const Deck& deck, const Node& root, Reading& reading) {
  check_hydrostatic(deck, root, reading);
  for (const PreloadDeck& preload : deck.start.preloads) {
    const Node& given = *root.find("start")->find("preload")->find(preload.name);
    if (given.find("part") == nullptr || given.find("force") == nullptr) continue;  // which is reported already
    const Spot spot = given.key;
    const auto refuse = [&](const std::string& why) {
      reading.errors.add(spot, fmt::format("preload '{}' {}", preload.name, why));
    };
    if (preload.force == 0) refuse("has force 0 (must pull or push): leave it out");
    const auto part =
        std::find_if(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& of) { return of.name == preload.part; });
    if (part == deck.parts.end()) {
      if (preload.part.empty()) refuse("is of part all (must be of one part): name the part");
      continue;  // an unknown name is reported already
    }
    if (part->rigid) refuse(fmt::format("is of part '{}' (which is rigid and has no stresses)", part->name));
    if (!preload.point && !part->section)
      refuse(fmt::format("has no plane and is of part '{}' (only beams have a force each): give it point and normal",
                         part->name));
    const auto material = std::find_if(deck.materials.begin(), deck.materials.end(),
                                       [&](const MaterialDeck& of) { return of.name == part->material; });
    if (material == deck.materials.end() || grows_in_increments(*material)) continue;
    refuse(
        fmt::format("is of part '{}' of material '{}' (whose stress does not grow in increments): use elastic or a "
                    "plastic law without an equation of state",
                    part->name, material->name));
  }
}

}  // namespace percuss
