// Fluids under gravity: what they begin with, and what holds the pressure that they begin with.

#include <algorithm>
#include <cmath>

#include "src/checks/fluid_layers.hpp"
#include "src/checks/rules.hpp"
#include "src/deck/laws/fluid_at_rest.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {
namespace {

/// Whether a condition holds nodes of a part along an axis.
bool is_held(const Deck& deck, std::size_t part, std::size_t axis) {
  return std::any_of(deck.conditions.begin(), deck.conditions.end(), [&](const ConditionDeck& condition) {
    return condition.active[axis] && names_part(deck, condition.where, part);
  });
}

}  // namespace

std::vector<Warning> check_standing_fluids(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.start.relaxation || deck.gravity.at(0) == Vec3{}) return warnings;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const PartDeck& part = deck.parts[p];
    const MaterialDeck& material = find_material(deck, part);
    if (part.rigid || !find_traits(material).needs_equation_of_state || !can_rest(material, 0)) continue;
    if (!is_held(deck, p, find_axis(deck.gravity.at(0))) || deck.start.find_hydrostatic(part.name) != nullptr) continue;
    warnings.push_back(warn_at(
        deck, "standing_fluid", "parts." + part.name,
        fmt::format("part '{0}' is a fluid that is held against gravity and begins without pressure (its weight comes "
                    "as a wave, which rings on): give start: {{hydrostatic: [{{parts: [{0}], surface: POINT}}]}}, or "
                    "start: {{relaxation: {{}}}}",
                    part.name)));
  }
  return warnings;
}

std::vector<Warning> check_fluid_surfaces(const CheckedScene& scene) {
  constexpr double negligible = 0.01;  // of the weight of the part
  const Deck& deck = scene.deck;
  std::vector<Warning> warnings;
  if (deck.start.hydrostatic.empty()) return warnings;
  const std::vector<FluidLayer> layers = list_fluid_layers(scene);
  for (const FluidLayer& layer : layers) {
    const std::string& name = deck.parts[layer.part].name;
    const auto other = std::find_if(layers.begin(), layers.end(), [&](const FluidLayer& of) {
      return of.fluid == layer.fluid && of.part < layer.part && of.weight != layer.weight;
    });
    if (other != layers.end()) {
      warnings.push_back(warn_at(
          deck, "fluid_surface", "parts." + name,
          fmt::format("parts '{}' and '{}' of one entry of start.hydrostatic have other densities (each begins with "
                      "the pressure of its own weight up to the surface): give each layer an entry, the lower one with "
                      "the pressure of the upper one",
                      deck.parts[other->part].name, name)));
      continue;
    }
    const std::optional<double> above = find_pressure_above(scene, layers, layer);
    const double begins = layer.find_pressure(layer.top);
    if (!above || std::abs(*above - begins) <= negligible * layer.weight * (layer.bottom - layer.top)) continue;
    warnings.push_back(
        warn_at(deck, "fluid_surface", "parts." + name,
                fmt::format("part '{}' begins with a pressure of {:.4g} at its top, on which {:.4g} acts (the "
                            "difference throws the fluid): put the surface of start.hydrostatic at its top, and give "
                            "what acts there as its pressure and by loads.pressure",
                            name, begins, *above)));
  }
  return warnings;
}

}  // namespace percuss
