// Keys of `failure` in a material, of `erosion`, and of `start`: dynamic relaxation and preloads.

#include "src/deck/keys/table_value.hpp"
#include "src/deck/make_material.hpp"
#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

const Keys<JohnsonCookDamageDeck>& damage_keys() {
  static const Keys<JohnsonCookDamageDeck> keys = {
      need("d1", &JohnsonCookDamageDeck::d1, NumberValue{}),
      may("d2", &JohnsonCookDamageDeck::d2, NumberValue{not_negative}),
      may("d3", &JohnsonCookDamageDeck::d3, NumberValue{}),
      may("d4", &JohnsonCookDamageDeck::d4, NumberValue{}),
      may("d5", &JohnsonCookDamageDeck::d5, NumberValue{not_negative}),
      may("reference_rate", &JohnsonCookDamageDeck::reference_rate, NumberValue{positive}),
  };
  return keys;
}

bool check_damage(const Reader& reader, const Node& node, JohnsonCookDamageDeck& damage) {
  if (damage.d1 > 0 || damage.d2 > 0) return true;
  reader.error(
      node.find("d1")->spot,
      fmt::format("neither {} nor d2 is positive (the material would fail at zero strain): make one of them positive",
                  reader.name_of("d1")));
  return false;
}

const Keys<BeamFailureDeck>& beam_failure_keys() {
  static const Keys<BeamFailureDeck> keys = {
      may("axial", &BeamFailureDeck::axial, NumberValue{positive}),
      may("shear_y", &BeamFailureDeck::shear_y, NumberValue{positive}),
      may("shear_z", &BeamFailureDeck::shear_z, NumberValue{positive}),
      may("torque", &BeamFailureDeck::torque, NumberValue{positive}),
      may("moment_y", &BeamFailureDeck::moment_y, NumberValue{positive}),
      may("moment_z", &BeamFailureDeck::moment_z, NumberValue{positive}),
  };
  return keys;
}

bool check_resultants(const Reader& reader, const Node& node, BeamFailureDeck& limits) {
  if (limits.axial || limits.shear_y || limits.shear_z || limits.torque || limits.moment_y || limits.moment_z)
    return true;
  reader.error(node.spot, fmt::format("{} names no limit (no beam would ever fail): give axial, shear_y, shear_z, "
                                      "torque, moment_y or moment_z",
                                      reader.self()));
  return false;
}

const Keys<FailureDeck>& failure_keys() {
  static const Keys<FailureDeck> keys = {
      may("plastic_strain", &FailureDeck::plastic_strain, NumberValue{positive}),
      may("principal_stress", &FailureDeck::principal_stress, NumberValue{positive}),
      may("principal_strain", &FailureDeck::principal_strain, NumberValue{positive}),
      may("thinning", &FailureDeck::thinning, NumberValue{positive}),
      may("mean_thinning", &FailureDeck::mean_thinning, NumberValue{positive}),
      may("pressure", &FailureDeck::pressure, NumberValue{positive}),
      may("johnson_cook", &FailureDeck::johnson_cook, MapValue<JohnsonCookDamageDeck>{damage_keys, check_damage}),
      may("yield_time", &FailureDeck::yield_time, NumberValue{positive}),
      may("resultants", &FailureDeck::resultants, MapValue<BeamFailureDeck>{beam_failure_keys, check_resultants}),
      may("time", &FailureDeck::time, NumberValue{not_negative}),
      may("step", &FailureDeck::step, NumberValue{positive}),
      may("inverted", &FailureDeck::inverted, BooleanValue{}),
      may("fade_steps", &FailureDeck::fade_steps, IntegerValue{1, 1000000}),
      may("layers", &FailureDeck::layers, NumberValue{{"above 0, at most 1", 0, 1, true}}),
      may("size", &FailureDeck::size, TableValue{positive}),
  };
  return keys;
}

bool check_failure(const Reader& reader, const Node& node, FailureDeck& failure) {
  const bool has_strain = failure.plastic_strain || failure.principal_strain || failure.thinning ||
                          failure.mean_thinning || failure.johnson_cook;
  if (!failure.size.empty() && !has_strain) {
    reader.error(node.find("size")->spot,
                 fmt::format("{} scales failure strains (there are none): give plastic_strain, principal_strain, "
                             "thinning, mean_thinning or johnson_cook",
                             reader.name_of("size")));
    return false;
  }
  if (has_strain || failure.principal_stress || failure.pressure || failure.yield_time || failure.resultants ||
      failure.time || failure.step || failure.inverted)
    return true;
  reader.error(
      node.spot,
      fmt::format("{} names no criterion (nothing would ever fail): give plastic_strain, principal_stress, "
                  "principal_strain, thinning, mean_thinning, pressure, johnson_cook, yield_time, resultants, time, "
                  "step or inverted: true",
                  reader.self()));
  return false;
}

const Keys<ErosionDeck>& erosion_keys() {
  using FreeNodes = ErosionDeck::FreeNodes;
  static const Keys<ErosionDeck> keys = {
      may("free_nodes", &ErosionDeck::free_nodes,
          ChoiceValue<FreeNodes>{{{"keep", FreeNodes::keep}, {"remove", FreeNodes::remove}}}),
  };
  return keys;
}

const Keys<RelaxationDeck>& relaxation_keys() {
  using Unsettled = RelaxationDeck::Unsettled;
  static const Keys<RelaxationDeck> keys = {
      may("tolerance", &RelaxationDeck::tolerance, NumberValue{{"above 0 and below 1", 0, 1, true, true}}),
      may("max_steps", &RelaxationDeck::max_steps, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("unsettled", &RelaxationDeck::unsettled,
          ChoiceValue<Unsettled>{{{"refuse", Unsettled::refuse}, {"warn", Unsettled::warn}}}),
      may("ramp", &RelaxationDeck::ramp, IntegerValue{0, std::numeric_limits<int>::max()}),
      may("damping", &RelaxationDeck::damping, NumberValue{positive}),
      may("hold", &RelaxationDeck::hold, ListValue<SelectorValue>{}),
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

const Keys<StartDeck>& start_keys() {
  static const Keys<StartDeck> keys = {
      may("relaxation", &StartDeck::relaxation, MapValue<RelaxationDeck>{relaxation_keys}),
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

}  // namespace

MapValue<FailureDeck> failure_value() { return {failure_keys, check_failure}; }
MapValue<ErosionDeck> erosion_value() { return {erosion_keys}; }

MapValue<StartDeck> start_value() { return {start_keys, check_preloads}; }

void check_start(const Deck& deck, const Node& root, Reading& reading) {
  for (const PreloadDeck& preload : deck.start.preloads) {
    const Node& given = *root.find("start")->find("preload")->find(preload.name);
    if (given.find("part") == nullptr || given.find("force") == nullptr) continue;  // which is told already
    const Spot spot = given.key;
    const auto refuse = [&](const std::string& why) {
      reading.errors.add(spot, fmt::format("preload '{}' {}", preload.name, why));
    };
    if (preload.force == 0) refuse("has force 0 (must pull or push): leave it out");
    const auto part =
        std::find_if(deck.parts.begin(), deck.parts.end(), [&](const PartDeck& of) { return of.name == preload.part; });
    if (part == deck.parts.end()) {
      if (preload.part.empty()) refuse("is of part all (must be of one part): name the part");
      continue;  // an unknown name is told already
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
