// Constants of materials and numerical settings outside their usual ranges.

#include <algorithm>
#include <array>
#include <optional>

#include "kernels/material/laws/johnson_cook.hpp"
#include "src/checks/rules.hpp"
#include "src/checks/unit_systems.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/lost_force.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/material_properties.hpp"

namespace percuss {
namespace {

constexpr const char* rate_curves = "hardening_at_rates";

/// Young's modulus that the law names, as that of the compacted solid of a honeycomb, or else that of its start.
double find_youngs_modulus(const MaterialDeck& material) {
  const auto found = material.law.numbers.find("youngs_modulus");
  return found == material.law.numbers.end() ? find_stiffness(material) : found->second;
}

std::string find_key_path(const MaterialDeck& material, const std::string& key) {
  return "materials." + material.name + "." + key;
}

/// Size of the largest element of a material; 0: it has none that deforms.
double find_largest_element(const CheckedScene& scene, const MaterialDeck& material) {
  double largest = 0;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    if (part.material != material.name || part.rigid) continue;
    largest = std::max(largest, scene.measures->parts[p].largest_element);
  }
  return largest;
}

}  // namespace

std::vector<Warning> check_yield_stress(const CheckedScene& scene) {
  // Yield stress as a share of Young's modulus: the strongest fibres and glasses, and half of the softest of pure
  // metals, which have 1e-4. A material with an equation of state may flow at any stress.
  constexpr double most = 0.1, least = 5e-5, least_of_fluid = 1e-6;
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto yield = find_first_yield(material.law);
    const double stiffness = find_youngs_modulus(material);
    const double lowest = material.equation_of_state ? least_of_fluid : least;
    if (!yield || (yield->value <= most * stiffness && yield->value >= lowest * stiffness)) continue;
    warnings.push_back(warn_at(
        scene.deck, "yield_stress", find_key_path(material, yield->key),
        fmt::format(
            "material '{}' yields at {:g}, which is {:.2g} times its Young's modulus {:g} (materials have 1e-4 to "
            "0.1; GPa beside MPa are a thousandth): check the units of both",
            material.name, yield->value, yield->value / stiffness, stiffness)));
  }
  return warnings;
}

std::vector<Warning> check_hardening(const CheckedScene& scene) {
  constexpr double most = 0.5;  // share of Young's modulus: then yield hardly changes the slope of the stress
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto found = material.law.numbers.find("hardening_modulus");
    if (found == material.law.numbers.end() || found->second <= most * find_youngs_modulus(material)) continue;
    warnings.push_back(warn_at(
        scene.deck, "hardening_modulus", find_key_path(material, found->first),
        fmt::format("the hardening modulus of material '{}' is {:g}, {:.2g} times its Young's modulus (typical of "
                    "metals: 0.01; it is the slope over plastic strain): check it",
                    material.name, found->second, found->second / find_youngs_modulus(material))));
  }
  return warnings;
}

std::vector<Warning> check_failure_strain(const CheckedScene& scene) {
  constexpr double most = 5;  // five times the length: no mesh is of use long before
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (!material.failure) continue;
    const std::pair<const char*, std::optional<double>> strains[] = {
        {"plastic_strain", material.failure->plastic_strain},
        {"principal_strain", material.failure->principal_strain},
        {"thinning", material.failure->thinning},
        {"mean_thinning", material.failure->mean_thinning}};
    for (const auto& [key, strain] : strains) {
      if (!strain || *strain <= most) continue;
      warnings.push_back(warn_at(scene.deck, "failure_strain", find_key_path(material, std::string("failure.") + key),
                                 fmt::format("material '{}' fails at a strain of {:g} (that is {:.0f} %; strains are "
                                             "not percentages): write 0.2 for 20 %",
                                             material.name, *strain, 100 * *strain)));
    }
  }
  return warnings;
}

std::vector<Warning> check_cowper_symonds(const CheckedScene& scene) {
  constexpr double least = 1, most = 20;  // of the exponent: published are 2 to 10
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto rate = material.law.numbers.find("cowper_symonds_rate"),
               exponent = material.law.numbers.find("cowper_symonds_exponent");
    if (exponent == material.law.numbers.end()) continue;
    const bool has_rate = rate != material.law.numbers.end() && rate->second > 0;
    if (has_rate && exponent->second >= least && exponent->second <= most) continue;
    const std::string path = find_key_path(material, exponent->first);
    if (!has_rate) {
      warnings.push_back(warn_at(scene.deck, "cowper_symonds", path,
                                 fmt::format("material '{}' has a cowper_symonds_exponent and no cowper_symonds_rate "
                                             "(its flow stress does not depend on the rate): give the rate too",
                                             material.name)));
      continue;
    }
    warnings.push_back(warn_at(scene.deck, "cowper_symonds", path,
                               fmt::format("material '{}' has the cowper_symonds_exponent {:g} beside the rate {:g} "
                                           "(published exponents are 2 to 10, steel has 40.4 / s and 5): check "
                                           "whether rate and exponent are swapped",
                                           material.name, exponent->second, rate->second)));
  }
  return warnings;
}

std::vector<Warning> check_softening_size(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (!material.failure || !material.failure->evolution || material.failure->evolution->plastic_strain) continue;
    const auto yield = find_first_yield(material.law);
    if (!yield) continue;
    const DamageEvolutionDeck& evolution = *material.failure->evolution;
    const double share = find_mean_share(evolution),
                 opening = evolution.energy ? *evolution.energy / (share * yield->value) : *evolution.displacement;
    const double fall = opening / find_steepest_fall(evolution);  // as if the force fell straight at its steepest
    const double most = find_youngs_modulus(material) * fall / yield->value;
    const double largest = find_largest_element(scene, material);
    if (largest <= most) continue;
    warnings.push_back(warn_at(
        scene.deck, "softening_size", find_key_path(material, "failure.evolution"),
        fmt::format("elements of material '{}' are up to {:.3g} large and stretch elastically by {:.3g} at the yield "
                    "stress, more than the {:.3g} over which their damage takes it (they snap, and what is left of "
                    "their energy becomes vibration): use elements of {:.3g} at most, or more energy or displacement",
                    material.name, largest, yield->value / find_youngs_modulus(material) * largest, fall, most)));
  }
  return warnings;
}

std::vector<Warning> check_late_softening(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (!material.failure || !material.failure->coupling || material.failure->triaxiality.empty()) continue;
    const FailureDeck& failure = *material.failure;
    if (failure.coupling->strain.empty()) continue;
    const MaterialTable start = make_table(failure.coupling->strain), end = make_table(failure.triaxiality);
    const auto is_late = [&](const std::array<double, 2>& row) { return start(row[0]).y >= end(row[0]).y; };
    if (!std::all_of(failure.coupling->strain.begin(), failure.coupling->strain.end(), is_late) ||
        !std::all_of(failure.triaxiality.begin(), failure.triaxiality.end(), is_late))
      continue;
    warnings.push_back(warn_at(scene.deck, "late_softening", find_key_path(material, "failure.coupling.strain"),
                               fmt::format("material '{}' fails before its force begins to fall (at every mean stress "
                                           "the failure strain is not above that of coupling): check whether both "
                                           "tables are swapped",
                                           material.name)));
  }
  return warnings;
}

std::vector<Warning> check_damage_sign(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (!material.failure || !material.failure->johnson_cook) continue;
    const JohnsonCookDamageDeck& damage = *material.failure->johnson_cook;
    if (!(damage.d3 > 0) || damage.d2 == 0) continue;
    warnings.push_back(warn_at(scene.deck, "damage_sign", find_key_path(material, "failure.johnson_cook.d3"),
                               fmt::format("d3 of material '{}' is {:g}, so that tension raises the failure strain "
                                           "(metals fail earlier in tension: exp(d3 s) with the mean stress s falls "
                                           "with d3 below 0; Abaqus writes exp(-d3 s)): write {:g}",
                                           material.name, damage.d3, -damage.d3)));
  }
  return warnings;
}

std::vector<Warning> check_poissons_ratio(const CheckedScene& scene) {
  constexpr double most = 0.4999;  // rubber has 0.499; the bulk modulus is 1700 times Young's then
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto found = material.law.numbers.find("poissons_ratio");
    if (found == material.law.numbers.end() || (found->second >= 0 && found->second <= most)) continue;
    const std::string why = found->second < 0 ? "it would become thicker as it is stretched, as only special foams do"
                                              : fmt::format(
                                                    "its bulk modulus is {:.2g} times its Young's modulus, "
                                                    "and the step as much smaller as the root of it",
                                                    1 / (3 * (1 - 2 * found->second)));
    warnings.push_back(warn_at(scene.deck, "poissons_ratio", find_key_path(material, found->first),
                               fmt::format("material '{}' has Poisson's ratio {:g} ({}): check it; rubber has 0.49 to "
                                           "0.4995, metals 0.25 to 0.4",
                                           material.name, found->second, why)));
  }
  return warnings;
}

// Deep-drawing steel has up to 3, aluminium from 0.4 on, titanium up to 6.
std::vector<Warning> check_strain_ratios(const CheckedScene& scene) {
  constexpr double least = 0.1, most = 8;
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto found = material.law.vectors.find("r_values");
    if (found == material.law.vectors.end()) continue;
    const auto& r = found->second;
    const auto wrong = std::find_if(r.begin(), r.end(), [&](double value) { return value < least || value > most; });
    if (wrong == r.end()) continue;
    warnings.push_back(warn_at(
        scene.deck, "strain_ratios", find_key_path(material, found->first),
        fmt::format("material '{}' has an r-value of {:g} (plastic strain of the width over that of the thickness; "
                    "metals have 0.3 to 6): give ratios, not percentages or stresses; yield stresses are yield_ratios",
                    material.name, *wrong)));
  }
  return warnings;
}

std::vector<Warning> check_hardening_strain(const CheckedScene& scene) {
  constexpr double most = 10;  // 20 is meant as 20 %
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    double strain = 0;
    std::string key = "hardening";
    for (const auto& [name, rows] : material.law.tables) {
      if (name != key && !name.starts_with(rate_curves)) continue;
      strain = std::max(strain, rows.back()[0]);
      if (name != key) key = rate_curves;
    }
    if (strain <= most) continue;
    warnings.push_back(
        warn_at(scene.deck, "hardening_strain", find_key_path(material, key),
                fmt::format("the hardening of material '{}' goes on to a plastic strain of {:g} (that is "
                            "{:.0f} %; strains are no percentages): give 0.2 for 20 %",
                            material.name, strain, 100 * strain)));
  }
  return warnings;
}

std::vector<Warning> check_specific_heat(const CheckedScene& scene) {
  constexpr double least = 50, most = 2e4;  // [J/kg/K] lead has 129, hydrogen 14 000
  const std::vector<Units> systems = find_meant_units(scene.deck);
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto found = material.law.numbers.find("specific_heat");
    if (found == material.law.numbers.end() || systems.empty()) continue;
    const auto find_si = [&](const Units& units) { return found->second * units.in_si({2, 0, -2}); };
    if (std::any_of(systems.begin(), systems.end(),
                    [&](const Units& units) { return find_si(units) >= least && find_si(units) <= most; }))
      continue;
    const Units& units = systems.front();
    warnings.push_back(
        warn_at(scene.deck, "specific_heat", find_key_path(material, found->first),
                fmt::format("the specific heat {:g} of material '{}' is {:.3g} J/kg/K in {} (metals have 100 to 1000, "
                            "here {:.3g} to {:.3g}): check it, or units",
                            found->second, material.name, find_si(units), units.text(), 100 / units.in_si({2, 0, -2}),
                            1000 / units.in_si({2, 0, -2}))));
  }
  return warnings;
}

std::vector<Warning> check_start_temperature(const CheckedScene& scene) {
  constexpr double most = 150;  // tests so far below room temperature are not known
  const auto units = find_units(scene.deck.units);
  const bool in_celsius = units && units->temperature == "C";
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    if (material.law.model != JohnsonCook::name) continue;
    const auto& numbers = material.law.numbers;
    const auto find = [&](const char* key, double otherwise) {
      const auto found = numbers.find(key);
      return found == numbers.end() ? otherwise : found->second;
    };
    const JohnsonCook otherwise;
    const double start = find("start_temperature", otherwise.start_temperature),
                 room = find("room_temperature", otherwise.room_temperature);
    const bool is_kelvin = in_celsius && (start == otherwise.start_temperature || room == otherwise.room_temperature);
    if (!is_kelvin && start >= room - most) continue;
    const char* why = is_kelvin ? "293.15 is room temperature in kelvins, the deck is in degrees Celsius"
                                : "kelvins and degrees Celsius differ so much";
    warnings.push_back(warn_at(scene.deck, "start_temperature", find_key_path(material, "start_temperature"),
                               fmt::format("material '{}' starts at a temperature of {:g}, and softens from "
                                           "room_temperature {:g} on ({}): give both in one scale",
                                           material.name, start, room, why)));
  }
  return warnings;
}

std::vector<Warning> check_viscosity(const CheckedScene& scene) {
  // Usual: 0.06 and 1.2 to 1.5; hourglass control 0.03 to 0.1. Much more damps what is to be seen. Fluids need little.
  constexpr double most_linear = 0.5, most_quadratic = 10, least_hourglass = 0.005, most_hourglass = 0.2;
  std::vector<Warning> warnings;
  const auto warn = [&](const std::string& key, double value, const char* usual) {
    warnings.push_back(
        warn_at(scene.deck, "viscosity", key,
                fmt::format("{} is {:g} (usual: {}; other values distort waves or bending): check it or leave it out",
                            key, value, usual)));
  };
  const auto check = [&](const ElementDeck& all, const PartElementDeck& given, const std::string& path, double least) {
    if (given.linear_viscosity.value_or(0) > most_linear)
      warn(path + "bulk_viscosity.linear", *given.linear_viscosity, "0 to 0.1");
    if (given.quadratic_viscosity.value_or(0) > most_quadratic)
      warn(path + "bulk_viscosity.quadratic", *given.quadratic_viscosity, "0 to 2");
    const double coefficient = given.hourglass_coefficient.value_or(most_hourglass);
    if (all.hourglass != ElementDeck::Hourglass::assumed_strain &&
        (coefficient < least || coefficient > most_hourglass))
      warn(path + "hourglass.coefficient", coefficient, "0.03 to 0.1");
  };
  const ElementDeck& all = scene.deck.elements;
  PartElementDeck given;
  given.hourglass_coefficient = all.hourglass_coefficient;
  given.linear_viscosity = all.linear_viscosity;
  given.quadratic_viscosity = all.quadratic_viscosity;
  check(all, given, "elements.", least_hourglass);
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const bool is_fluid = find_traits(find_material(scene.deck, part)).needs_equation_of_state;
    check(scene.deck.find_elements(p), part.own_elements, "parts." + part.name + ".", is_fluid ? 0 : least_hourglass);
  }
  return warnings;
}

// The control of solids is a stiffness in shear, of 1 % of the bulk modulus and more: water becomes a jelly, whose
// waves are 3 to 6 times too fast. Nothing of it shows in an energy.
std::vector<Warning> check_fluid_hourglass(const CheckedScene& scene) {
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const PartMeasures& measures = scene.measures->parts[p];
    const ElementDeck elements = scene.deck.find_elements(p);
    if (part.rigid || measures.solids == measures.small_solids ||
        elements.integration != ElementDeck::Integration::one_point ||
        elements.hourglass == ElementDeck::Hourglass::viscous ||
        !find_traits(find_material(scene.deck, part)).needs_equation_of_state)
      continue;
    warnings.push_back(warn_at(
        scene.deck, "fluid_hourglass", "parts." + part.name,
        fmt::format("part '{}' is a fluid with hourglass: {} (which resists shear with a share of its bulk modulus: it "
                    "sloshes like a jelly, far too fast): give the part hourglass: {{kind: viscous, coefficient: "
                    "0.002}}, which is the default of fluids where elements names neither hourglass nor integration",
                    part.name,
                    elements.hourglass == ElementDeck::Hourglass::stiffness ? "stiffness" : "assumed_strain")));
  }
  return warnings;
}

// The limit moment of n Gauss points at z_i with weights w_i over that of the section: 2 sum w_i |z_i|, z from -1 to 1
// (Abramowitz and Stegun, Handbook of Mathematical Functions, table 25.4).
std::vector<Warning> check_shell_points(const CheckedScene& scene) {
  constexpr int least = 4;  // 4 % too much; 5, the default, 5.5 % too little
  static constexpr const char* faults[] = {"", "one point has no bending stress",
                                           "two give a limit moment 15 % too large",
                                           "three give a limit moment 14 % too small"};
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    if (!part.points || *part.points >= least || part.rigid || scene.measures->parts[p].shells == 0) continue;
    if (!find_first_yield(find_material(scene.deck, part).law)) continue;
    warnings.push_back(
        warn_at(scene.deck, "shell_points", "parts." + part.name + ".points",
                fmt::format("the shells of part '{}' have {} point{} through their thickness and yield "
                            "({}): take 5, the default, or more",
                            part.name, *part.points, *part.points == 1 ? "" : "s", faults[*part.points])));
  }
  return warnings;
}

// Central differences conserve the energy of linear motion; what rounds and what is not linear adds up over many steps.
std::vector<Warning> check_no_viscosity(const CheckedScene& scene) {
  constexpr double most = 1e5;  // steps: docs/limits.md
  const TimeDeck& time = scene.deck.time;
  const double steps = time.end / (time.step_scale * scene.stable_step);
  if (!(steps > most) || !scene.deck.dampings.empty()) return {};
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const ElementDeck elements = scene.deck.find_elements(p);
    const std::string& name = scene.deck.parts[p].name;
    const std::string own = "parts." + name + ".bulk_viscosity.linear";
    if (scene.deck.parts[p].rigid || scene.measures->parts[p].solids == 0) continue;
    if (elements.linear_viscosity > 0 || elements.stiffness_damping > 0) continue;
    return {
        warn_at(scene.deck, "no_viscosity", scene.deck.places.has(own) ? own : "elements.bulk_viscosity.linear",
                fmt::format("part '{}' has no linear bulk viscosity in some {:.2g} steps (a free vibration gains or "
                            "loses some per cent of its energy in 1e5 steps): keep the default 0.06, or halve "
                            "time.step_scale",
                            name, steps))};
  }
  return {};
}

std::vector<Warning> check_mass_scaling(const CheckedScene& scene) {
  constexpr double most = 0.25;     // share of a part's mass: then the motion is another one
  constexpr double no_limit = 100;  // times it: an import of a step without a limit writes 1e6
  std::vector<Warning> warnings;
  const auto check = [&](const std::optional<MassScalingDeck>& scaling, const std::string& path) {
    if (!scaling || scaling->max_added <= most) return;
    const std::string amount = scaling->max_added > no_limit
                                   ? fmt::format("any mass: its limit is {:g} times that of a part", scaling->max_added)
                                   : fmt::format("{:.0f} % to the mass of a part", 100 * scaling->max_added);
    warnings.push_back(warn_at(scene.deck, "mass_scaling", path + ".max_added",
                               fmt::format("mass scaling may add {} (above about 5 % its motion changes): lower "
                                           "max_added, or step; the run reports at its start how much it adds",
                                           amount)));
  };
  check(scene.deck.time.mass_scaling, "time.mass_scaling");
  for (const PartDeck& part : scene.deck.parts) check(part.mass_scaling, "parts." + part.name + ".mass_scaling");
  return warnings;
}

}  // namespace percuss
