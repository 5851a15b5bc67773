#pragma once
// Traction and separation of two glued surfaces, with damage (docs/theory_contact.md, section 6).
//
// Undamaged, the tractions are K_n and K_s times the separations. Damage begins where (t_n / N)^2 + (t_s / S)^2 = 1, or
// where the larger of both ratios is 1, and is complete where the energy of the mix is spent. With e = K_n <d_n>^2 / 2
// + K_s d_s^2 / 2 and the share B of shear in it, this is the mixed-mode law of Camanho and Davila
// (NASA/TM-2002-211737) with effective separations in ratio to that of the onset: r = sqrt(e / e_0(B)). Exponential
// softening leaves exp(-(e - e_0) / (G - e_0)) of the stiffness: the tractions then spend e_0 + integral of that over e
// = G.

#include <cmath>

#include "kernels/core/views.hpp"

namespace percuss {

struct CohesiveLaw {
  enum class Mix { benzeggagh_kenane, power_law };
  enum class Onset { quadratic, maximum };
  enum class Softening { linear, exponential };
  static constexpr double least_share = 1e-5;        // of the stiffness: with less of it a place has failed
  static constexpr double unbreakable = 1e100;       // as a strength: its square has an inverse
  double normal_stiffness = 0, shear_stiffness = 0;  // traction / separation
  double normal_strength = 0, shear_strength = 0;    // tractions at which damage begins, each alone
  double normal_energy = 0, shear_energy = 0;        // spent until failure, by area, each alone
  double plateau = 0;                                // share of the energy that is spent at constant traction
  Mix mix = Mix::benzeggagh_kenane;
  double exponent = 1;
  Onset onset = Onset::quadratic;
  Softening softening = Softening::linear;

  /// Energies by area where damage begins, each alone.
  KOKKOS_INLINE_FUNCTION double normal_onset() const {
    return 0.5 * normal_strength * normal_strength / normal_stiffness;
  }
  KOKKOS_INLINE_FUNCTION double shear_onset() const { return 0.5 * shear_strength * shear_strength / shear_stiffness; }
};

/// State of a point of a glued surface: traction and energies by area.
struct CohesivePoint {
  double normal = 0, shear = 0;  // tractions
  double whole = 0;              // energy that the tension and shear of now would store without damage
  double pressed = 0;            // energy stored in compression
  double damage = 0;
  /// Stored energy.
  KOKKOS_INLINE_FUNCTION double stored() const { return (1 - damage) * whole + pressed; }
};

/// Energy spent until failure at a share of shear.
KOKKOS_INLINE_FUNCTION double find_cohesive_energy(const CohesiveLaw& law, double share) {
  if (law.mix == CohesiveLaw::Mix::benzeggagh_kenane)
    return law.normal_energy + (law.shear_energy - law.normal_energy) * std::pow(share, law.exponent);
  return std::pow(
      std::pow((1 - share) / law.normal_energy, law.exponent) + std::pow(share / law.shear_energy, law.exponent),
      -1 / law.exponent);
}

/// Damage that a separation alone gives: from its undamaged energy and the share of shear in that.
KOKKOS_INLINE_FUNCTION double find_cohesive_damage(const CohesiveLaw& law, double energy, double share) {
  const double of_tension = (1 - share) / law.normal_onset(), of_shear = share / law.shear_onset();
  const double onset = law.onset == CohesiveLaw::Onset::quadratic ? 1 / (of_tension + of_shear)
                       : of_tension > of_shear                    ? 1 / of_tension
                                                                  : 1 / of_shear;
  if (!(energy > onset)) return 0;
  const double whole = find_cohesive_energy(law, share);
  if (law.softening == CohesiveLaw::Softening::exponential) {
    const double left = std::exp(-(energy - onset) / (whole - onset));
    return left > CohesiveLaw::least_share ? 1 - left : 1;
  }
  const double r = std::sqrt(energy / onset), spent = 0.5 * whole / onset;
  const double end_of_plateau = 1 + law.plateau * spent, end = (2 - law.plateau) * spent;
  if (r >= end) return 1;
  if (r <= end_of_plateau) return 1 - 1 / r;
  return 1 - (end - r) / (r * (end - end_of_plateau));
}

/// opening: along the normal, negative in compression, which damage leaves as it is; slide: amount across it. before:
/// the damage so far, which does not heal.
KOKKOS_INLINE_FUNCTION CohesivePoint separate(const CohesiveLaw& law, double opening, double slide, double before) {
  const double tension = opening > 0 ? law.normal_stiffness * opening : 0;
  const double of_tension = 0.5 * tension * opening, of_shear = 0.5 * law.shear_stiffness * slide * slide;
  CohesivePoint point;
  point.whole = of_tension + of_shear;
  const double now = point.whole > 0 ? find_cohesive_damage(law, point.whole, of_shear / point.whole) : 0;
  point.damage = now > before ? now : before;
  point.shear = (1 - point.damage) * law.shear_stiffness * slide;
  if (opening > 0) {
    point.normal = (1 - point.damage) * tension;
  } else {
    point.normal = law.normal_stiffness * opening;
    point.pressed = 0.5 * point.normal * opening;
  }
  return point;
}

}  // namespace percuss
