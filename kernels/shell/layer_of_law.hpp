#pragma once
// The layer of shells that a law becomes, where it has one.

#include "kernels/material/laws/j2_plasticity.hpp"
#include "kernels/shell/hardening_layer.hpp"

namespace percuss {

inline PlaneElasticity find_layer_elasticity(const LameConstants& c) {
  return find_plane_elasticity(find_youngs_modulus(c), 0.5 * c.lambda / (c.lambda + c.mu));
}

inline ElasticLayer make_layer(const Elastic& law, double /*density*/) { return {find_layer_elasticity(law.moduli())}; }

inline J2Layer make_layer(const J2Plasticity& law, double /*density*/) {
  return {find_layer_elasticity(law.moduli()), law.yield_stress, law.hardening_modulus};
}

template <FlowLaw Law>
HardeningLayer make_layer(const Law& law, double density) {
  return HardeningLayer::make(law, find_layer_elasticity(law.moduli()), density);
}

/// Whether shells know the law.
template <class Law>
concept LayerLaw = requires(const Law& law) {
  make_layer(law, 1.0);
};

}  // namespace percuss
