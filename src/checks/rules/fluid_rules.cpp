// Fluids under gravity: what they begin with, and what holds the pressure that they begin with.

#include <algorithm>
#include <cmath>

#include "src/checks/rules.hpp"
#include "src/deck/laws/fluid_at_rest.hpp"
#include "src/deck/laws/law_traits.hpp"

namespace percuss {
namespace {

/// The axis that a vector is nearest to.
std::size_t find_axis(const Vec3& v) {
  const auto steeper = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(v.begin(), v.end(), steeper) - v.begin());
}

bool names_part(const Deck& deck, const Selector& where, std::size_t part) {
  const std::vector<std::size_t> parts = find_named_parts(deck, where);
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Whether a condition holds nodes of a part along an axis.
bool is_held(const Deck& deck, std::size_t part, std::size_t axis) {
  return std::any_of(deck.conditions.begin(), deck.conditions.end(), [&](const ConditionDeck& condition) {
    return condition.active[axis] && names_part(deck, condition.where, part);
  });
}

/// A part of `start.hydrostatic` between its highest and its lowest nodes, along the axis of gravity.
struct Layer {
  const HydrostaticDeck* fluid;
  std::size_t part, axis;
  double top, bottom;  // depth below the surface [length]
  double weight;       // density times gravity [pressure / length]

  double find_pressure(double depth) const { return fluid->pressure + weight * depth; }
};

std::vector<Layer> list_layers(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const Vec3 gravity = deck.gravity.at(0);
  const std::size_t axis = find_axis(gravity);
  std::vector<Layer> layers;
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {
    const HydrostaticDeck* const fluid = deck.start.find_hydrostatic(deck.parts[p].name);
    if (fluid == nullptr) continue;
    const PartMeasures& measures = scene.measures->parts[p];
    const double down = gravity[axis] > 0 ? 1 : -1, low = down * (measures.low[axis] - fluid->surface[axis]),
                 high = down * (measures.high[axis] - fluid->surface[axis]);
    layers.push_back({fluid, p, axis, std::min(low, high), std::max(low, high),
                      find_material(deck, deck.parts[p]).density * std::abs(gravity[axis])});
  }
  return layers;
}

/// The pressure that acts on the top of a layer; nothing: it is not known, as where something else holds the fluid.
std::optional<double> find_pressure_above(const CheckedScene& scene, const std::vector<Layer>& layers,
                                          const Layer& layer) {
  constexpr double close = 1e-3;  // of the height of the part
  const Deck& deck = scene.deck;
  const double near = close * (layer.bottom - layer.top), down = deck.gravity.at(0)[layer.axis] > 0 ? 1 : -1;
  const double top = layer.fluid->surface[layer.axis] + down * layer.top;
  for (const Layer& other : layers) {
    const double bottom = other.fluid->surface[layer.axis] + down * other.bottom;
    if (other.part != layer.part && std::abs(bottom - top) <= near) return other.find_pressure(other.bottom);
  }
  for (std::size_t p = 0; p < deck.parts.size(); ++p) {  // a lid, or a body that floats
    const PartMeasures& measures = scene.measures->parts[p];
    const bool is_above =
        down * (measures.low[layer.axis] - top) < -near || down * (measures.high[layer.axis] - top) < -near;
    if (p != layer.part && is_above && deck.contact.surfaces != ContactDeck::Surfaces::none) return std::nullopt;
  }
  for (std::size_t c = 0; c < deck.conditions.size(); ++c) {
    const ConditionMeasures& box = scene.measures->selections.conditions[c];
    const double high = down > 0 ? box.low[layer.axis] : box.high[layer.axis];
    if (deck.conditions[c].active[layer.axis] && names_part(deck, deck.conditions[c].where, layer.part) &&
        down * (high - top) <= near)
      return std::nullopt;
  }
  double pressure = 0;
  for (const PressureDeck& load : deck.pressures) {
    if (!names_part(deck, load.where, layer.part)) continue;
    if (load.blast || load.when.any()) return std::nullopt;
    pressure = std::max(pressure, load.value(0));
  }
  return pressure;
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
  const std::vector<Layer> layers = list_layers(scene);
  for (const Layer& layer : layers) {
    const std::string& name = deck.parts[layer.part].name;
    const auto other = std::find_if(layers.begin(), layers.end(), [&](const Layer& of) {
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
