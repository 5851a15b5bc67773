#include "src/checks/fluid_layers.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {

std::size_t find_axis(const Vec3& v) {
  const auto steeper = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(v.begin(), v.end(), steeper) - v.begin());
}

bool names_part(const Deck& deck, const Selector& where, std::size_t part) {
  const std::vector<std::size_t> parts = find_named_parts(deck, where);
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

std::vector<FluidLayer> list_fluid_layers(const CheckedScene& scene) {
  const Deck& deck = scene.deck;
  const Vec3 gravity = deck.gravity.at(0);
  const std::size_t axis = find_axis(gravity);
  std::vector<FluidLayer> layers;
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

std::optional<double> find_pressure_above(const CheckedScene& scene, const std::vector<FluidLayer>& layers,
                                          const FluidLayer& layer) {
  constexpr double close = 1e-3;  // of the height of the part
  const Deck& deck = scene.deck;
  const double near = close * (layer.bottom - layer.top), down = deck.gravity.at(0)[layer.axis] > 0 ? 1 : -1;
  const double top = layer.fluid->surface[layer.axis] + down * layer.top;
  for (const FluidLayer& other : layers) {
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

}  // namespace percuss
