#pragma once
// Systems of units in which a deck can be meant, by what its numbers would be in SI.

#include <string>
#include <vector>

#include "src/deck/deck.hpp"

namespace percuss {

/// A system of units by its base units in SI.
struct UnitSystem {
  std::string name;  // "mm, t, s"
  double length = 1, mass = 1, time = 1;

  double speed() const { return length / time; }
  double acceleration() const { return length / time / time; }
  double density() const { return mass / length / length / length; }
  double pressure() const { return mass / length / time / time; }
};

/// Densities, wave speeds and moduli of materials that a run may hold, in SI: from a gas at a thousandth of an
/// atmosphere to osmium, from soft foam to diamond.
inline constexpr double least_density = 1e-3, largest_density = 23000;
inline constexpr double least_wave_speed = 10, largest_wave_speed = 20000;

/// The system that the deck names, if it is a known one.
const UnitSystem* find_named_units(const Deck& deck);

/// Whether a material is one that exists if the deck is meant in these units.
bool is_plausible(const MaterialDeck& material, const UnitSystem& units);

/// The known systems in which all materials that parts use are plausible.
std::vector<UnitSystem> find_plausible_units(const Deck& deck);

/// Whether the deck seems to have no units on purpose: it names none, and its densities and moduli are near 1.
bool is_dimensionless(const Deck& deck);

}  // namespace percuss
