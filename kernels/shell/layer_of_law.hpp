#pragma once
// The layer of shells, and the ply of a laminate, that a law becomes, where it has one.

#include "kernels/material/laws/j2_plasticity.hpp"
#include "kernels/shell/fabric.hpp"
#include "kernels/shell/laminate.hpp"
#include "kernels/shell/skin.hpp"

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

inline FabricLayer make_layer(const Fabric& law, double /*density*/) { return FabricLayer::make(law); }

/// The layer of a skin, which has no stress and is not computed.
inline ElasticLayer make_layer(const Skin& /*law*/, double /*density*/) { return {}; }

/// As a ply of a laminate.
inline PlyMaterial make_ply(const Orthotropic& law, double /*density*/) {
  PlyMaterial ply;
  ply.orthotropic = OrthotropicPly::make(law.constants);
  return ply;
}

inline PlyMaterial make_ply(const Elastic& law, double /*density*/) {
  PlyMaterial ply;
  ply.orthotropic = OrthotropicPly::make(find_layer_elasticity(law.moduli()));
  return ply;
}

inline PlyMaterial make_ply(const J2Plasticity& law, double density) {
  PlyMaterial ply;
  ply.kind = PlyMaterial::Kind::linear_hardening;
  ply.linear_hardening = make_layer(law, density);
  return ply;
}

inline PlyMaterial make_ply(const AnisotropicPlasticity& law, double /*density*/) {
  PlyMaterial ply;
  ply.kind = PlyMaterial::Kind::anisotropic_metal;
  ply.anisotropic_metal = MetalPly::make(law, find_layer_elasticity(law.moduli()));
  return ply;
}

template <FlowLaw Law>
PlyMaterial make_ply(const Law& law, double density) {
  PlyMaterial ply;
  ply.kind = PlyMaterial::Kind::hardening;
  ply.hardening = make_layer(law, density);
  return ply;
}

/// Whether shells know the law.
template <class Law>
concept LayerLaw = requires(const Law& law) {
  make_ply(law, 1.0);
};

}  // namespace percuss
