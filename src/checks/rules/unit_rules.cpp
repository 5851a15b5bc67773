// Numbers that do not fit one system of units.

#include <algorithm>
#include <cmath>
#include <string>

#include "src/checks/rules.hpp"
#include "src/checks/unit_systems.hpp"

namespace percuss {
namespace {

std::string join_names(const std::vector<Units>& systems) {
  std::string names;
  for (const Units& system : systems) names += (names.empty() ? "" : " or ") + system.text();
  return names;
}

/// Whether a quantity is outside a range of SI in each of the systems; false if there is none.
bool is_outside(double value, const Dimension& quantity, const std::vector<Units>& systems, double least, double most) {
  return !systems.empty() && std::all_of(systems.begin(), systems.end(), [&](const Units& units) {
    const double si = value * units.in_si(quantity);
    return si < least || si > most;
  });
}

}  // namespace

std::vector<Warning> check_unit_system(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  if (!deck.units.empty() || is_dimensionless(deck) || !find_plausible_units(deck).empty()) return {};
  std::vector<Warning> warnings;
  for (const MaterialDeck* used : list_used_materials(deck)) {
    const MaterialDeck& material = *used;
    Deck alone;
    alone.parts.emplace_back().material = material.name;
    alone.materials = {material};
    if (!find_plausible_units(alone).empty()) continue;
    warnings.push_back(warn_at(
        deck, "unit_system", "materials." + material.name + ".density",
        fmt::format("material '{}' has density {:g} and stiffness {:g} (such a material exists in no known system of "
                    "units; its wave speed is {:.3g}): write all values in one system and name it in units",
                    material.name, material.density, find_stiffness(material), find_wave_speed(material))));
  }
  if (!warnings.empty()) return warnings;
  return {warn_at(deck, "unit_system", "materials",
                  "no system of units fits all materials (at least one seems to use other units than the rest): write "
                  "all values in one system and name it in units")};
}

std::vector<Warning> check_density(const CheckedScene& scene) {
  const auto units = find_units(scene.deck.units);
  std::vector<Warning> warnings;
  if (!units) return warnings;
  for (const MaterialDeck* used : list_used_materials(scene.deck)) {
    const MaterialDeck& material = *used;
    const double density = material.density * units->in_si(dimensions::density);
    if (density >= least_density && density <= largest_density) continue;
    warnings.push_back(
        warn_at(scene.deck, "density", "materials." + material.name + ".density",
                fmt::format("density {:g} of material '{}' is {:.3g} kg/m3 in {} (materials have {:g} to {:g}): check "
                            "it and units",
                            material.density, material.name, density, units->text(), least_density, largest_density)));
  }
  return warnings;
}

std::vector<Warning> check_wave_speed(const CheckedScene& scene) {
  const auto units = find_units(scene.deck.units);
  std::vector<Warning> warnings;
  if (!units) return warnings;
  for (const MaterialDeck* used : list_used_materials(scene.deck)) {
    const MaterialDeck& material = *used;
    if (!has_wave_speed(material)) continue;
    const double speed = find_wave_speed(material) * units->in_si(dimensions::velocity);
    const double density = material.density * units->in_si(dimensions::density), least = find_least_wave_speed(density);
    if (speed >= least && speed <= largest_wave_speed) continue;
    warnings.push_back(warn_at(
        scene.deck, "wave_speed", "materials." + material.name,
        fmt::format("the wave speed of material '{}' is {:.3g} m/s ({} have {:g} to {:g}; its density is {:g}, its "
                    "stiffness {:g} in {}): check both, and units",
                    material.name, speed, least > least_wave_speed ? "metals" : "solids", least, largest_wave_speed,
                    material.density, find_stiffness(material), units->text())));
  }
  return warnings;
}

std::vector<Warning> check_scene_size(const CheckedScene& scene) {
  constexpr double least = 5e-4, most = 1e4;  // [m] smaller than grains of sand, larger than what waves reach in a run
  const std::vector<Units> systems = find_meant_units(scene.deck);
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, scene.measures->high[k] - scene.measures->low[k]);
  if (!is_outside(size, dimensions::length, systems, least, most)) return {};
  return {warn_at(scene.deck, "scene_size", "parts",
                  fmt::format("the whole scene is {:.3g} long, which is {:.3g} m (the materials are in {}): check the "
                              "unit of lengths",
                              size, size * systems.front().length.in_si, join_names(systems)))};
}

std::vector<Warning> check_scene_mass(const CheckedScene& scene) {
  constexpr double most = 1e8;  // [kg] the largest ships; a kilogram with millimetres read as metres has 1e9
  const std::vector<Units> systems = find_meant_units(scene.deck);
  std::vector<Warning> warnings;
  for (std::size_t p = 0; p < scene.deck.parts.size(); ++p) {
    const PartDeck& part = scene.deck.parts[p];
    const double density = find_material(scene.deck, part).density, mass = scene.measures->parts[p].mass;
    const auto is_large = [&](const Units& units) {
      return density * units.in_si(dimensions::density) >= density_of_metals &&
             mass * units.in_si(dimensions::mass) > most;
    };
    if (systems.empty() || !std::all_of(systems.begin(), systems.end(), is_large)) continue;
    warnings.push_back(
        warn_at(scene.deck, "scene_mass", find_shape_path(part),
                fmt::format("part '{}' has a mass of {:.2g} kg and is {:.3g} long in {} (more metal than "
                            "in the largest ships): check the unit of lengths; mesh files have "
                            "`scale`",
                            part.name, mass * systems.front().in_si(dimensions::mass),
                            scene.measures->parts[p].extent(), join_names(systems))));
  }
  return warnings;
}

std::vector<Warning> check_gravity_size(const CheckedScene& scene) {
  constexpr double least = 0.1, most = 5000;  // [m/s2] a small moon, a centrifuge at 500 times the earth's gravity
  const std::vector<Units> systems = find_meant_units(scene.deck);
  constexpr int samples = 64;
  double size = 0;  // the largest of the run
  for (int i = 0; i <= samples; ++i) {
    const Vec3 g = scene.deck.gravity.at(scene.deck.time.end * i / samples);
    size = std::max(size, std::hypot(g[0], g[1], g[2]));
  }
  if (size == 0) return {};
  if (!is_outside(size, dimensions::acceleration, systems, least, most)) return {};
  return {warn_at(scene.deck, "gravity_size", "loads.gravity",
                  fmt::format("gravity is {:g}, which is {:.4g} m/s2 in {} (the earth's is 9.81 m/s2, here {:.4g}): "
                              "check it and units",
                              size, size * systems.front().in_si(dimensions::acceleration), join_names(systems),
                              9.81 / systems.front().in_si(dimensions::acceleration)))};
}

}  // namespace percuss
