// Constants of materials and numerical settings outside their usual ranges.

#include <optional>

#include "kernels/material/laws/johnson_cook.hpp"
#include "kernels/material/laws/tabulated_plasticity.hpp"
#include "src/checks/rules.hpp"

namespace percuss {
namespace {

struct NamedValue {
  std::string key;
  double value = 0;
};

/// The stress at first yield of a material that yields.
std::optional<NamedValue> find_yield_stress(const LawDeck& law) {
  if (law.model == TabulatedPlasticity::name) return NamedValue{"hardening", law.tables.at("hardening").front()[1]};
  const std::string key = law.model == JohnsonCook::name ? "a" : "yield_stress";
  const auto found = law.numbers.find(key);
  if (found == law.numbers.end()) return std::nullopt;
  return NamedValue{key, found->second};
}

/// Young's modulus that the law names, as that of the compacted solid of a honeycomb, or else that of its start.
double find_youngs_modulus(const MaterialDeck& material) {
  const auto found = material.law.numbers.find("youngs_modulus");
  return found == material.law.numbers.end() ? find_stiffness(material) : found->second;
}

std::string find_key_path(const MaterialDeck& material, const std::string& key) {
  return "materials." + material.name + "." + key;
}

}  // namespace

std::vector<Warning> check_yield_stress(const CheckedScene& scene) {
  constexpr double most = 0.1,
                   least = 1e-6;  // of Young's modulus: the strongest fibres and glasses, and softest solder
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto yield = find_yield_stress(material.law);
    const double stiffness = find_youngs_modulus(material);
    if (!yield || (yield->value <= most * stiffness && yield->value >= least * stiffness)) continue;
    warnings.push_back(warn_at(
        scene.deck, "yield_stress", find_key_path(material, yield->key),
        fmt::format("material '{}' yields at {:g}, which is {:.2g} of its Young's modulus {:g} (materials have 1e-6 to "
                    "0.1): check the units of both",
                    material.name, yield->value, yield->value / stiffness, stiffness)));
  }
  return warnings;
}

std::vector<Warning> check_hardening(const CheckedScene& scene) {
  constexpr double most = 0.5;  // of Young's modulus: then yield hardly changes the slope of the stress
  std::vector<Warning> warnings;
  for (const MaterialDeck& material : scene.deck.materials) {
    const auto found = material.law.numbers.find("hardening_modulus");
    if (found == material.law.numbers.end() || found->second <= most * find_youngs_modulus(material)) continue;
    warnings.push_back(warn_at(
        scene.deck, "hardening_modulus", find_key_path(material, found->first),
        fmt::format(
            "material '{}' hardens with {:g}, {:.2g} of its Young's modulus (metals have a hundredth; it is the "
            "slope over the plastic strain): check it",
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
        {"plastic_strain", material.failure->plastic_strain}, {"principal_strain", material.failure->principal_strain}};
    for (const auto& [key, strain] : strains) {
      if (!strain || *strain <= most) continue;
      warnings.push_back(
          warn_at(scene.deck, "failure_strain", find_key_path(material, std::string("failure.") + key),
                  fmt::format("material '{}' fails at a strain of {:g} (that is {:.0f} %; strains are no "
                              "percentages): give 0.2 for 20 %",
                              material.name, *strain, 100 * *strain)));
    }
  }
  return warnings;
}

std::vector<Warning> check_viscosity(const CheckedScene& scene) {
  // Usual: 0.06 and 1.2 to 1.5; hourglass control 0.03 to 0.1. Much more damps what is to be seen.
  constexpr double most_linear = 0.5, most_quadratic = 10, least_hourglass = 0.005, most_hourglass = 0.2;
  std::vector<Warning> warnings;
  const auto warn = [&](const std::string& key, double value, const char* usual) {
    warnings.push_back(warn_at(scene.deck, "viscosity", key,
                               fmt::format("{} is {:g} (usual: {}; outside, waves or bending change): leave it "
                                           "out or check it",
                                           key, value, usual)));
  };
  const auto check = [&](const ElementDeck& all, const PartElementDeck& given, const std::string& path) {
    if (given.linear_viscosity.value_or(0) > most_linear)
      warn(path + "bulk_viscosity.linear", *given.linear_viscosity, "0 to 0.1");
    if (given.quadratic_viscosity.value_or(0) > most_quadratic)
      warn(path + "bulk_viscosity.quadratic", *given.quadratic_viscosity, "0 to 2");
    const double coefficient = given.hourglass_coefficient.value_or(most_hourglass);
    if (all.hourglass != ElementDeck::Hourglass::assumed_strain &&
        (coefficient < least_hourglass || coefficient > most_hourglass))
      warn(path + "hourglass.coefficient", coefficient, "0.03 to 0.1");
  };
  const ElementDeck& all = scene.deck.elements;
  check(all, {{}, {}, all.hourglass_coefficient, all.linear_viscosity, all.quadratic_viscosity}, "elements.");
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p)
    check(scene.deck.find_elements(p), scene.deck.parts[p].own_elements, "parts." + scene.deck.parts[p].name + ".");
  return warnings;
}

std::vector<Warning> check_mass_scaling(const CheckedScene& scene) {
  constexpr double most = 0.25;  // of a part's mass: then the motion is another one
  std::vector<Warning> warnings;
  const auto check = [&](const std::optional<MassScalingDeck>& scaling, const std::string& path) {
    if (!scaling || scaling->max_added <= most) return;
    warnings.push_back(warn_at(
        scene.deck, "mass_scaling", path + ".max_added",
        fmt::format("mass scaling may add {:.0f} % to the mass of a part (beyond some 5 % its motion is another "
                    "one): lower max_added, or step",
                    100 * scaling->max_added)));
  };
  check(scene.deck.time.mass_scaling, "time.mass_scaling");
  for (const PartDeck& part : scene.deck.parts) check(part.mass_scaling, "parts." + part.name + ".mass_scaling");
  return warnings;
}

}  // namespace percuss
