#pragma once
// Materials and their failure.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/selector.hpp"

namespace percuss {

/// The constants of a law by the keys of its table (kernels/material), those that have defaults included.
struct LawDeck {
  std::string model;  // its name in the deck
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<std::array<double, 2>>> tables;
  std::map<std::string, Vec3> vectors;
  std::map<std::string, std::vector<double>> lists;
  std::map<std::string, std::string> texts;  // files too
  Place place;
};
struct JohnsonCookDamageDeck {
  double d1 = 0, d2 = 0, d3 = 0, d4 = 0, d5 = 0;
  double reference_rate = 1;  // [1/time]
};
/// Forces of the section of a beam at which it fails, each of them alone.
struct BeamFailureDeck {
  std::optional<double> axial;  // of a tension
  std::optional<double> shear_y, shear_z, torque, moment_y, moment_z;
};
/// Measure over which an element loses its force after the onset of damage; one of them.
struct DamageEvolutionDeck {
  std::optional<double> displacement, energy, plastic_strain;  // plastic; by area
  std::optional<double> exponent;                              // the force falls exponentially
  std::vector<std::array<double, 2>> table;  // rows [share of that, share of the force that is lost]; none: straight
};
/// How an element loses force before its damage is 1: from a plastic strain or from a damage on.
struct DamageCouplingDeck {
  std::vector<std::array<double, 2>> strain;  // rows [mean by von Mises stress, plastic strain]
  std::optional<double> damage;
  double damage_exponent = 1;                           // damage is its sum over the plastic strain to this power
  double exponent = 1;                                  // of the loss of force
  std::vector<std::array<double, 2>> exponent_of_size;  // rows [size of an element, exponent]; none: as above
};
/// Failure by shear.
struct ShearDamageDeck {
  std::vector<std::array<double, 2>> strain;  // rows [ratio of stresses, plastic strain]
  double pressure_factor = 0;
};
/// When an element of a material fails: at the first of the criteria that are given.
struct FailureDeck {
  std::optional<double> plastic_strain;    // equivalent
  std::optional<double> principal_stress;  // largest, tension positive
  std::optional<double> principal_strain;  // largest, logarithmic
  std::optional<double> thinning;          // of a layer of a shell, logarithmic
  std::optional<double> mean_thinning;     // of a shell over its thickness, logarithmic
  std::optional<double> pressure;          // below minus this
  std::optional<JohnsonCookDamageDeck> johnson_cook;
  std::vector<std::array<double, 2>>
      triaxiality;  // rows [mean by von Mises stress, plastic strain]; none: no criterion
  std::optional<ShearDamageDeck> shear;
  std::vector<std::array<double, 2>> rate;  // rows [plastic strain rate, factor of the strains of tables]; none: 1
  std::optional<DamageEvolutionDeck> evolution;
  std::optional<DamageCouplingDeck> coupling;
  std::optional<double> yield_time;           // at yield, in all
  std::optional<double> fibre_damage;         // of plies of shells: damage of the fibres
  std::optional<double> volume_below;         // of solids: V / V(0) falls below this
  std::optional<double> volume_above;         // of solids: V / V(0) rises above this
  std::optional<BeamFailureDeck> resultants;  // of beams
  std::optional<double> time;                 // of beams: at this time
  std::optional<double> step;                 // the step that the element allows falls below this
  bool inverted = false;                      // no positive volume: the element fails, and the run continues
  int fade_steps = 1;                         // steps in which its force falls to zero
  double layers = 1;                          // of shells: share of the thickness that has to fail
  std::vector<std::array<double, 2>> size;    // rows [size of an element, factor of the failure strains]; none: 1
};
/// Treatment of nodes whose elements are all eroded.
struct ErosionDeck {
  enum class FreeNodes { keep, remove };
  FreeNodes free_nodes = FreeNodes::keep;
};

/// A ply of a laminate.
struct LaminatePly {
  std::string material;
  LawDeck law;
  double density = 0;
  double share = 1;  // of the thickness
  double angle = 0;  // as PlyDeck::angle
};
struct MaterialDeck {
  std::string name;
  double density = 0;
  LawDeck law;
  std::optional<LawDeck> equation_of_state;
  Place place;
  std::optional<FailureDeck> failure;
  std::vector<LaminatePly> plies;  // of a laminate (src/deck/laws/laminates.hpp); density: their mean
};

}  // namespace percuss
