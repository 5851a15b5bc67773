#pragma once
// Systems of units in which a deck can be meant, by what its numbers would be in SI.

#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/units.hpp"

namespace percuss {

/// Densities and wave speeds of materials that a run may hold, in SI: from a gas at a thousandth of an atmosphere to
/// osmium, from soft foam to diamond.
inline constexpr double least_density = 1e-3, largest_density = 23000;
inline constexpr double least_wave_speed = 10, largest_wave_speed = 20000;

/// Beyond the first density all solids are metals and their ores, whose waves run faster than the second: lead's at
/// 2000 m/s.
inline constexpr double density_of_metals = 5000, least_wave_speed_of_metals = 500;

/// Least wave speed of a solid of a density, both in SI.
inline double find_least_wave_speed(double density) {
  return density < density_of_metals ? least_wave_speed : least_wave_speed_of_metals;
}

/// The materials of parts.
std::vector<const MaterialDeck*> list_used_materials(const Deck& deck);

/// Whether the wave speed of a material identifies its units; not so for an ideal gas, which may have any temperature.
bool has_wave_speed(const MaterialDeck& material);

/// Whether a material is one that exists if the deck is meant in these units.
bool is_plausible(const MaterialDeck& material, const Units& units);

/// The usual systems in which all materials that parts use are plausible.
std::vector<Units> find_plausible_units(const Deck& deck);

/// Whether the deck seems to have no units on purpose: it names none, and the densities and moduli of
/// its parts are near 1.
bool is_dimensionless(const Deck& deck);

/// The units that the deck names, or else all in which it can be meant; none of a dimensionless deck.
std::vector<Units> find_meant_units(const Deck& deck);

}  // namespace percuss
