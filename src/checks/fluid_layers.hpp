#pragma once
// Parts that begin with hydrostatic pressure, as layers along the axis of gravity.

#include <optional>

#include "src/checks/checked_scene.hpp"

namespace percuss {

/// The axis that a vector is nearest to.
std::size_t find_axis(const Vec3& v);

bool names_part(const Deck& deck, const Selector& where, std::size_t part);

/// A part of `start.hydrostatic` between its highest and its lowest nodes, along the axis of gravity.
struct FluidLayer {
  const HydrostaticDeck* fluid;
  std::size_t part, axis;
  double top, bottom;  // depth below the surface [length]
  double weight;       // density times gravity [pressure / length]

  double find_pressure(double depth) const { return fluid->pressure + weight * depth; }
};

std::vector<FluidLayer> list_fluid_layers(const CheckedScene& scene);

/// The pressure that acts on the top of a layer; nothing: it is not known, as where something else holds the fluid.
std::optional<double> find_pressure_above(const CheckedScene& scene, const std::vector<FluidLayer>& layers,
                                          const FluidLayer& layer);

}  // namespace percuss
