// `failure` of materials and `erosion`.

#include "src/deck/keys/table_value.hpp"
#include "src/deck/sections/deck_keys.hpp"

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

const Keys<DamageEvolutionDeck>& evolution_keys() {
  static const Keys<DamageEvolutionDeck> keys = {
      may("displacement", &DamageEvolutionDeck::displacement, NumberValue{positive}),
      may("energy", &DamageEvolutionDeck::energy, NumberValue{positive}),
      may("plastic_strain", &DamageEvolutionDeck::plastic_strain, NumberValue{positive}),
  };
  return keys;
}

bool check_evolution(const Reader& reader, const Node& node, DamageEvolutionDeck& evolution) {
  const int count =
      evolution.displacement.has_value() + evolution.energy.has_value() + evolution.plastic_strain.has_value();
  if (count == 1) return true;
  reader.error(node.spot,
               fmt::format("{} has {} of its keys (damage grows by one of them): give displacement, energy or "
                           "plastic_strain",
                           reader.self(), count == 0 ? "none" : "several"));
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
      may("triaxiality", &FailureDeck::triaxiality, TableValue{positive}),
      may("evolution", &FailureDeck::evolution, MapValue<DamageEvolutionDeck>{evolution_keys, check_evolution}),
      may("yield_time", &FailureDeck::yield_time, NumberValue{positive}),
      may("fibre_damage", &FailureDeck::fibre_damage, NumberValue{{"above 0, at most 1", 0, 1, true}}),
      may("volume_below", &FailureDeck::volume_below,
          NumberValue{{"between 0 and 1, both excluded", 0, 1, true, true}}),
      may("volume_above", &FailureDeck::volume_above,
          NumberValue{{"above 1", 1, std::numeric_limits<double>::infinity(), true}}),
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
  const bool damages = failure.plastic_strain || failure.johnson_cook || !failure.triaxiality.empty();
  const bool has_strain = damages || failure.principal_strain || failure.thinning || failure.mean_thinning;
  if (failure.evolution && (!damages || failure.fade_steps > 1)) {
    reader.error(node.find("evolution")->spot,
                 damages
                     ? fmt::format("{} stands beside fade_steps (both say how the force is lost): remove one of them",
                                   reader.name_of("evolution"))
                     : fmt::format("{} has no onset (its damage would never grow): give plastic_strain, "
                                   "johnson_cook or triaxiality",
                                   reader.name_of("evolution")));
    return false;
  }
  if (!failure.size.empty() && !has_strain) {
    reader.error(node.find("size")->spot,
                 fmt::format("{} scales failure strains (there are none): give plastic_strain, principal_strain, "
                             "thinning, mean_thinning, johnson_cook or triaxiality",
                             reader.name_of("size")));
    return false;
  }
  if (has_strain || failure.principal_stress || failure.pressure || failure.yield_time || failure.fibre_damage ||
      failure.volume_below || failure.volume_above || failure.resultants || failure.time || failure.step ||
      failure.inverted)
    return true;
  reader.error(
      node.spot,
      fmt::format(
          "{} names no criterion (nothing would ever fail): give plastic_strain, principal_stress, "
          "principal_strain, thinning, mean_thinning, pressure, johnson_cook, triaxiality, yield_time, fibre_damage, "
          "volume_below, volume_above, resultants, time, step or inverted: true",
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

}  // namespace

MapValue<FailureDeck> failure_value() { return {failure_keys, check_failure}; }
MapValue<ErosionDeck> erosion_value() { return {erosion_keys}; }

}  // namespace percuss
