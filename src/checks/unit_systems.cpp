#include "src/checks/unit_systems.hpp"

#include <algorithm>
#include <iterator>

#include "src/checks/checked_scene.hpp"

namespace percuss {
namespace {

constexpr double inch = 0.0254, foot = 0.3048, pound_force = 4.4482216152605;

const std::vector<UnitSystem>& list_unit_systems() {
  static const std::vector<UnitSystem> systems = {
      {"m, kg, s", 1, 1, 1},
      {"mm, t, s", 1e-3, 1e3, 1},
      {"mm, kg, ms", 1e-3, 1, 1e-3},
      {"mm, g, ms", 1e-3, 1e-3, 1e-3},
      {"cm, g, us", 1e-2, 1e-3, 1e-6},
      {"cm, g, s", 1e-2, 1e-3, 1},
      {"in, lbf s^2/in, s", inch, pound_force / inch, 1},
      {"ft, slug, s", foot, pound_force / foot, 1},
  };
  return systems;
}

std::vector<const MaterialDeck*> list_used_materials(const Deck& deck) {
  std::vector<const MaterialDeck*> used;
  for (const MaterialDeck& material : deck.materials) {
    const auto uses = [&](const PartDeck& part) { return part.material == material.name; };
    if (std::any_of(deck.parts.begin(), deck.parts.end(), uses)) used.push_back(&material);
  }
  return used;
}

}  // namespace

const UnitSystem* find_named_units(const Deck& deck) {
  const auto& systems = list_unit_systems();
  const auto named = std::find_if(systems.begin(), systems.end(), [&](const UnitSystem& system) {
    return deck.units == system.name || deck.units.starts_with(system.name + ",");
  });
  return named == systems.end() ? nullptr : &*named;
}

bool is_plausible(const MaterialDeck& material, const UnitSystem& units) {
  const double density = material.density * units.density();
  const double speed = find_wave_speed(material) * units.speed();
  return density >= least_density && density <= largest_density && speed >= least_wave_speed &&
         speed <= largest_wave_speed;
}

std::vector<UnitSystem> find_plausible_units(const Deck& deck) {
  const std::vector<const MaterialDeck*> used = list_used_materials(deck);
  std::vector<UnitSystem> plausible;
  std::copy_if(list_unit_systems().begin(), list_unit_systems().end(), std::back_inserter(plausible),
               [&](const UnitSystem& units) {
                 return std::all_of(used.begin(), used.end(),
                                    [&](const MaterialDeck* material) { return is_plausible(*material, units); });
               });
  return plausible;
}

bool is_dimensionless(const Deck& deck) {
  constexpr double least = 0.01, most_density = 100, most_stiffness = 1e6;
  return find_named_units(deck) == nullptr &&
         std::all_of(deck.materials.begin(), deck.materials.end(), [](const MaterialDeck& material) {
           const double stiffness = find_stiffness(material);
           return material.density >= least && material.density <= most_density && stiffness >= least &&
                  stiffness <= most_stiffness;
         });
}

}  // namespace percuss
