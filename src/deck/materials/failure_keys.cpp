#include "src/deck/keys/table_value.hpp"  // first: its names would hide those of keys/values.hpp

#include "src/deck/materials/failure_keys.hpp"

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
      may("exponent", &DamageEvolutionDeck::exponent, NumberValue{{"from 0.001 to 100", 1e-3, 100}}),
      may("table", &DamageEvolutionDeck::table, TableValue{{"from 0 to 1", 0, 1}}),
  };
  return keys;
}

/// Checks the table of an evolution.
bool check_lost_force(const Reader& reader, const Node& node, const DamageEvolutionDeck& evolution) {
  const auto& rows = evolution.table;
  std::string problem;
  if (evolution.exponent) problem = "stands beside exponent (both say how the force falls): remove one of them";
  if (rows.front()[0] != 0 || rows.front()[1] != 0 || rows.back()[0] != 1 || rows.back()[1] != 1)
    problem =
        "does not go from [0, 0] to [1, 1] (shares of what the evolution takes and of the force that is lost): "
        "begin and end there";
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i][1] < rows[i - 1][1]) problem = "falls (lost force does not come back): let it rise";
  if (problem.empty()) return true;
  reader.error(node.spot, fmt::format("{} {}", reader.name_of("table"), problem));
  return false;
}

bool check_evolution(const Reader& reader, const Node& node, DamageEvolutionDeck& evolution) {
  const int count =
      evolution.displacement.has_value() + evolution.energy.has_value() + evolution.plastic_strain.has_value();
  if (count != 1) {
    reader.error(node.spot, fmt::format("{} has {} of its measures (damage grows by one of them): give displacement, "
                                        "energy or plastic_strain",
                                        reader.self(), count == 0 ? "none" : "several"));
    return false;
  }
  if (evolution.table.empty()) return true;
  return check_lost_force(reader, *node.find("table"), evolution);
}

const Keys<ShearDamageDeck>& shear_keys() {
  static const Keys<ShearDamageDeck> keys = {
      need("strain", &ShearDamageDeck::strain, TableValue{positive}),
      may("pressure_factor", &ShearDamageDeck::pressure_factor, NumberValue{}),
  };
  return keys;
}

const Keys<DamageCouplingDeck>& coupling_keys() {
  static const Keys<DamageCouplingDeck> keys = {
      may("strain", &DamageCouplingDeck::strain, TableValue{positive}),
      may("damage", &DamageCouplingDeck::damage, NumberValue{{"from 0 to below 1", 0, 1, false, true}}),
      may("damage_exponent", &DamageCouplingDeck::damage_exponent, NumberValue{positive}),
      may("exponent", &DamageCouplingDeck::exponent, NumberValue{positive}),
      may("exponent_of_size", &DamageCouplingDeck::exponent_of_size, TableValue{positive}),
  };
  return keys;
}

bool check_coupling(const Reader& reader, const Node& node, DamageCouplingDeck& coupling) {
  if (coupling.damage.has_value() != coupling.strain.empty()) {
    reader.error(node.spot,
                 fmt::format("{} has {} of strain and damage (one of them is where the force begins to fall): give one",
                             reader.self(), coupling.damage ? "both" : "none"));
    return false;
  }
  if (node.find("exponent") == nullptr || coupling.exponent_of_size.empty()) return true;
  reader.error(node.find("exponent")->spot, fmt::format("{} stands beside exponent_of_size (which gives it for every "
                                                        "size): remove one of them",
                                                        reader.name_of("exponent")));
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
      may("shear", &FailureDeck::shear, MapValue<ShearDamageDeck>{shear_keys}),
      may("rate", &FailureDeck::rate, TableValue{positive}),
      may("coupling", &FailureDeck::coupling, MapValue<DamageCouplingDeck>{coupling_keys, check_coupling}),
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

bool adds_damage(const FailureDeck& failure) {
  return failure.johnson_cook || !failure.triaxiality.empty() || failure.shear;
}

/// Setting that contradicts damage that takes force; empty: none.
std::string find_clash(const FailureDeck& failure) {
  if (failure.evolution && failure.coupling)
    return "coupling stands beside evolution (both say how the force is lost): remove one of them";
  const char* const key = failure.evolution ? "evolution" : "coupling";
  const bool has_onset = failure.evolution ? adds_damage(failure) || failure.plastic_strain
                                           : failure.johnson_cook || !failure.triaxiality.empty();
  if ((failure.evolution || failure.coupling) && !has_onset)
    return fmt::format(
        "{} has no onset (its damage would never grow): give {}", key,
        failure.evolution ? "plastic_strain, johnson_cook, triaxiality or shear" : "johnson_cook or triaxiality");
  if ((failure.evolution || failure.coupling) && failure.fade_steps > 1)
    return fmt::format("{} stands beside fade_steps (both say how the force is lost): remove one of them", key);
  const bool begins_by_strain = failure.coupling && !failure.coupling->strain.empty();
  if (failure.shear.has_value() + failure.yield_time.has_value() + begins_by_strain > 1)
    return fmt::format("{} stands beside {} (an element keeps one of these sums): remove one of them",
                       begins_by_strain ? "coupling.strain" : "yield_time", failure.shear ? "shear" : "yield_time");
  if (!failure.rate.empty() && failure.triaxiality.empty() && !failure.shear)
    return "rate scales the failure strains of tables (there are none): give triaxiality or shear";
  return "";
}

bool check_failure(const Reader& reader, const Node& node, FailureDeck& failure) {
  const bool has_strain = failure.plastic_strain || adds_damage(failure) || failure.principal_strain ||
                          failure.thinning || failure.mean_thinning;
  if (const std::string clash = find_clash(failure); !clash.empty()) {
    reader.error(node.find(clash.substr(0, clash.find_first_of(" .")))->spot, reader.name_of(clash));
    return false;
  }
  if (!failure.size.empty() && !has_strain) {
    reader.error(node.find("size")->spot,
                 fmt::format("{} scales failure strains (there are none): give plastic_strain, principal_strain, "
                             "thinning, mean_thinning, johnson_cook, triaxiality or shear",
                             reader.name_of("size")));
    return false;
  }
  if (has_strain || failure.principal_stress || failure.pressure || failure.yield_time || failure.fibre_damage ||
      failure.volume_below || failure.volume_above || failure.resultants || failure.time || failure.step ||
      failure.inverted)
    return true;
  reader.error(
      node.spot,
      fmt::format("{} names no criterion (nothing would ever fail): give plastic_strain, principal_stress, "
                  "principal_strain, thinning, mean_thinning, pressure, johnson_cook, triaxiality, shear, yield_time, "
                  "fibre_damage, volume_below, volume_above, resultants, time, step or inverted: true",
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
