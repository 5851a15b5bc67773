#include "src/checks/unit_systems.hpp"

#include <algorithm>

#include "kernels/material/pressure/equation_of_state.hpp"
#include "src/checks/checked_scene.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {

std::vector<const MaterialDeck*> list_used_materials(const Deck& deck) {
  std::vector<const MaterialDeck*> used;
  for (const MaterialDeck& material : deck.materials) {
    const auto uses = [&](const PartDeck& part) { return part.material == material.name; };
    if (find_traits(material).is_skin) continue;  // its mass may be that of air, its stiffness none
    if (std::any_of(deck.parts.begin(), deck.parts.end(), uses)) used.push_back(&material);
  }
  return used;
}

bool has_wave_speed(const MaterialDeck& material) {
  return !material.equation_of_state || material.equation_of_state->model != IdealGasState::name;
}

bool is_plausible(const MaterialDeck& material, const Units& units) {
  const double density = material.density * units.in_si(dimensions::density);
  const double speed = find_wave_speed(material) * units.in_si(dimensions::velocity);
  if (density < least_density || density > largest_density) return false;
  return !has_wave_speed(material) || (speed >= find_least_wave_speed(density) && speed <= largest_wave_speed);
}

std::vector<Units> find_plausible_units(const Deck& deck) {
  const std::vector<const MaterialDeck*> used = list_used_materials(deck);
  std::vector<Units> plausible;
  for (const std::string& name : list_unit_systems()) {
    const Units units = find_units(name).value();
    if (std::all_of(used.begin(), used.end(),
                    [&](const MaterialDeck* material) { return is_plausible(*material, units); }))
      plausible.push_back(units);
  }
  return plausible;
}

bool is_dimensionless(const Deck& deck) {
  constexpr double least = 0.01, most_density = 100, most_stiffness = 1e6;
  if (!deck.units.empty()) return false;
  const std::vector<const MaterialDeck*> used = list_used_materials(deck);
  return std::all_of(used.begin(), used.end(), [&](const MaterialDeck* material) {
    if (material->density < least || material->density > most_density) return false;
    const double stiffness = find_stiffness(*material);
    return !has_wave_speed(*material) || (stiffness >= least && stiffness <= most_stiffness);
  });
}

std::vector<Units> find_meant_units(const Deck& deck) {
  if (const auto named = find_units(deck.units)) return {*named};
  return is_dimensionless(deck) ? std::vector<Units>{} : find_plausible_units(deck);
}

}  // namespace percuss
