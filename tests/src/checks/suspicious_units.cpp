// Units and materials.

#include "tests/src/checks/suspicious_decks.hpp"

namespace percuss {
namespace {

const std::pair<std::string, std::string> no_units{"units: m, kg, s\n", ""};
const std::string aluminium =
    "density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 120e6, hardening_modulus: 400e6";
const std::string aluminium_in_mm =
    "density: 2.7e-9, youngs_modulus: 70e3, poissons_ratio: 0.33, yield_stress: 120, hardening_modulus: 400";
const std::pair<std::string, std::string> steel_in_mm{"density: 7850, youngs_modulus: 210e9",
                                                      "density: 7.85e-9, youngs_modulus: 210e3"};

const std::string steel = "elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3";
const std::pair<std::string, std::string> cold_gas{
    steel, "fluid, density: 1.2, equation_of_state: {kind: ideal_gas, gamma: 1.4, start_energy: 1e-3}"};
const std::pair<std::string, std::string> spare_material{
    "materials:\n",
    "materials:\n  spare: {model: elastic, density: 7.85e-9, youngs_modulus: 210e9, poissons_ratio: 0.3}\n"};

/// steel as a honeycomb of a solid that yields at a stress.
std::pair<std::string, std::string> honeycomb(const std::string& yield_stress) {
  return {steel,
          "honeycomb, density: 100, youngs_modulus: 70e9, poissons_ratio: 0.3, compacted_volume: 0.2, "
          "crush_moduli: [1e9, 1e9, 1e9], shear_moduli: [4e8, 4e8, 4e8], crush_xx: [[0, 1e6]], "
          "crush_yy: [[0, 1e6]], crush_zz: [[0, 1e6]], crush_xy: [[0, 1e6]], crush_yz: [[0, 1e6]], crush_zx: [[0, "
          "1e6]], yield_stress: " +
              yield_stress};
}

const std::pair<std::string, std::string> porous{
    steel,
    "gurson, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, hardening: [[0, 3e8]], void_fraction: 0.01"};

/// A part of steel of 4 mm.
std::pair<std::string, std::string> small_part(const std::string& cells) {
  return {"  plate: {box", "  small: {box: {size: [0.004, 0.004, 0.004], cells: [" + cells + ", " + cells + ", " +
                               cells + "]}, at: [0.2, 0.2, 0.2], material: steel}\n  plate: {box"};
}

/// Foam of such curves.
std::string rate_foam(const std::string& curves) {
  return "rate_table_foam, density: 60, youngs_modulus: 5e6, compression_at_rates: " + curves;
}

/// steel with the heat of a law of Johnson and Cook.
std::pair<std::string, std::string> johnson_cook(const std::string& heat) {
  return {steel,
          "johnson_cook, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, a: 806e6, b: 614e6, n: 0.2, "
          "melt_temperature: 1500, " +
              heat};
}

std::vector<SuspiciousDeck> unit_decks() {
  return {
      {"DensityInTonnesPerCubicMillimetre",
       "unit_system",
       "density: 7.85e-9",
       {no_units, {"7850", "7.85e-9"}},
       {no_units}},
      {"ModulusInGigapascal",
       "unit_system",
       "density: 7850",
       {no_units, {"210e9", "210"}},
       {no_units, {"210e9", "2e9"}}},
      {"MaterialsInTwoSystems",
       "unit_system",
       "materials:",
       {no_units, steel_in_mm},
       {no_units, steel_in_mm, {aluminium, aluminium_in_mm}}},
      {"MaterialOfAnotherSystemThatAPartUses",
       "unit_system",
       "density: 7.85e-9",
       {no_units, {"7850", "7.85e-9"}},
       {no_units, spare_material}},
      {"DensityOfAnotherSystemThatAPartUses", "density", "density: 7.85e-9", {{"7850", "7.85e-9"}}, {spare_material}},
      {"WavesOfASolidAsSlowAsThoseOfAColdGas", "wave_speed", "steel: {", {{"210e9", "210"}}, {cold_gas}},
      {"SolidAsSoftAsAColdGas", "unit_system", "density: 7850", {no_units, {"210e9", "210"}}, {no_units, cold_gas}},
      {"DensityOfAnotherSystem", "density", "density: 7.85e-9", {{"7850", "7.85e-9"}}, {{"7850", "1.2"}}},
      {"DensityAThousandTimesTooLarge", "density", "density: 7850e3", {{"7850", "7850e3"}}, {{"7850", "22600"}}},
      {"ModulusInGigapascalBesideNamedUnits", "wave_speed", "steel: {", {{"210e9", "210"}}, {{"210e9", "3e9"}}},
      {"ModulusInMegapascal", "wave_speed", "steel: {", {{"210e9", "210e3"}}, {{"210e9", "2e9"}}},
      {"DensityInGramsPerCubicCentimetre", "wave_speed", "steel: {", {{"7850", "7.85"}}, {{"7850", "785"}}},
      {"ModulusAThousandTimesTooLarge", "wave_speed", "aluminium: {", {{"70e9", "70e12"}}, {{"70e9", "700e9"}}},
      {"LengthsInMetresBesideMillimetres",
       "scene_size",
       "parts:",
       {{"m, kg, s", "mm, t, s"}, steel_in_mm, {aluminium, aluminium_in_mm}},
       {{"m, kg, s", "cm, g, us"},
        {"density: 7850, youngs_modulus: 210e9", "density: 7.85, youngs_modulus: 2.1"},
        {aluminium,
         "density: 2.7, youngs_modulus: 0.7, poissons_ratio: 0.33, yield_stress: 1.2e-3, hardening_modulus: 4e-3"}}},
      {"LengthsInMetresOfADeckWithoutUnits",
       "scene_size",
       "parts:",
       {no_units, steel_in_mm, {aluminium, aluminium_in_mm}},
       {no_units}},
      {"ModulusOfSteelInMegapascalBesideMillimetres",
       "wave_speed",
       "steel: {",
       {{"m, kg, s", "mm, t, s"},
        {"density: 7850, youngs_modulus: 210e9", "density: 7.85e-9, youngs_modulus: 210"},
        {aluminium, aluminium_in_mm}},
       {{"density: 7850, youngs_modulus: 210e9", "density: 1200, youngs_modulus: 30e6"}}},
      {"BlockInMillimetresReadAsMetres",
       "scene_mass",
       "box: {size: [20, 20, 20]",
       {{"0.02, 0.02, 0.02]", "20, 20, 20]"}, {"7850", "19000"}},
       {{"0.02, 0.02, 0.02]", "20, 20, 20]"}}},
      {"GravityInMillimetres", "gravity_size", "gravity: [0, 0, -9810]", {{"-9.81", "-9810"}}, {{"-9.81", "-981"}}},
      {"GravityInMetresPerMillisecond",
       "gravity_size",
       "gravity: [0, 0, -9.81e-3]",
       {{"-9.81", "-9.81e-3"}},
       {{"-9.81", "-1.62"}}},
  };
}

/// Aluminium whose hardening depends on the rate.
Changes::value_type with_rate(const std::string& keys) {
  return {
      "j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 120e6, "
      "hardening_modulus: 400e6",
      "voce_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 120e6, "
      "saturation_stress: 50e6, saturation_rate: 10, " +
          keys};
}

/// Elements of the sheet far smaller than those of the plate, of one material.
const std::pair<std::string, std::string> fine_sheet{"cells: [5, 5]", "cells: [40, 40]"};

/// The plate as shells.
const std::string shells_of_plate[] = {
    "box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}",
    "shell_plate: {size: [0.1, 0.1], cells: [6, 6]}, at: [0, 0, 0.009], thickness: 0.002"};

std::vector<SuspiciousDeck> material_decks() {
  const std::string start = "elements: {";
  return {
      {"YieldStressInMegapascal", "yield_stress", "yield_stress: 120,", {{"120e6", "120"}}, {{"120e6", "12e6"}}},
      {"YieldStressInGigapascalBesideMegapascal",
       "yield_stress",
       "yield_stress: 120e3",
       {{"120e6", "120e3"}},
       {{"120e6", "7e6"}}},
      {"YieldStressAboveATenthOfTheModulus",
       "yield_stress",
       "yield_stress: 120e9",
       {{"120e6", "120e9"}},
       {{"120e6", "2e9"}}},
      {"YieldStressOfJohnsonAndCookInMegapascal",
       "yield_stress",
       "a: 806,",
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "johnson_cook, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, a: 806, b: 614e6, n: 0.2, "
         "melt_temperature: 1500, specific_heat: 460"}},
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "johnson_cook, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, a: 806e6, b: 614e6, n: 0.2, "
         "melt_temperature: 1500, specific_heat: 460"}}},
      {"YieldStressOfTheSolidOfAHoneycomb",
       "yield_stress",
       "yield_stress: 200}",
       {honeycomb("200")},
       {honeycomb("200e6")}},
      {"YieldStressOfATableInMegapascal",
       "yield_stress",
       "hardening: [[0, 120]",
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120], [0.1, 160]]"}},
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6], [0.1, 160e6]]"}}},
      {"HardeningModulusOfTheModulus",
       "hardening_modulus",
       "hardening_modulus: 70e9",
       {{"400e6", "70e9"}},
       {{"400e6", "10e9"}}},
      {"FailureStrainInPercent",
       "failure_strain",
       "plastic_strain: 20",
       {{"400e6}", "400e6, failure: {plastic_strain: 20}}"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 2}}"}}},
      {"LinearViscosityOfSix",
       "viscosity",
       "linear: 6",
       {{"initial:", start + "bulk_viscosity: {linear: 6}}\ninitial:"}},
       {{"initial:", start + "bulk_viscosity: {linear: 0.3}}\ninitial:"}}},
      {"QuadraticViscosityOfAHundred",
       "viscosity",
       "quadratic: 120",
       {{"initial:", start + "bulk_viscosity: {quadratic: 120}}\ninitial:"}},
       {{"initial:", start + "bulk_viscosity: {quadratic: 4}}\ninitial:"}}},
      {"HourglassCoefficientOfAHalf",
       "viscosity",
       "coefficient: 0.5",
       {{"initial:", start + "hourglass: {kind: viscous, coefficient: 0.5}}\ninitial:"}},
       {{"initial:", start + "hourglass: {kind: viscous, coefficient: 0.1}}\ninitial:"}}},
      {"MassScalingWithoutBound",
       "mass_scaling",
       "max_added: 3",
       {no_sheet, no_sheet_condition, {"2.0e-4}", "2.0e-4, mass_scaling: {step: 1e-9, max_added: 3}}"}},
       {no_sheet, no_sheet_condition, {"2.0e-4}", "2.0e-4, mass_scaling: {step: 1e-9, max_added: 0.1}}"}}},
      {"PoissonsRatioOfAnIncompressibleMetal",
       "poissons_ratio",
       "poissons_ratio: 0.49999",
       {{"poissons_ratio: 0.3}", "poissons_ratio: 0.49999}"}},
       {{"poissons_ratio: 0.3}", "poissons_ratio: 0.4995}"}}},
      {"PoissonsRatioWithAWrongSign",
       "poissons_ratio",
       "poissons_ratio: -0.3",
       {{"poissons_ratio: 0.3}", "poissons_ratio: -0.3}"}},
       {{"poissons_ratio: 0.3}", "poissons_ratio: 0}"}}},
      {"HardeningInPercent",
       "hardening_strain",
       "hardening: [[0, 120e6]",
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6], [20, 160e6]]"}},
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6], [2, 160e6]]"}}},
      {"StrainRatiosInPercent",
       "strain_ratios",
       "r_values: [180",
       {{"j2_plasticity", "anisotropic_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6]], r_values: [180, 120, 230]"}},
       {{"j2_plasticity", "anisotropic_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6]], r_values: [1.8, 1.2, 2.3]"}}},
      {"SpecificHeatInMillimetresBesideMetres",
       "specific_heat",
       "specific_heat: 460e6",
       {johnson_cook("specific_heat: 460e6")},
       {johnson_cook("specific_heat: 129")}},
      {"StartInCelsiusBesideKelvins",
       "start_temperature",
       "start_temperature: 20}",
       {johnson_cook("specific_heat: 460, start_temperature: 20")},
       {johnson_cook("specific_heat: 460, start_temperature: 200")}},
      {"DeckInCelsiusWithRoomTemperatureInKelvins",
       "start_temperature",
       "steel: {",
       {{"m, kg, s", "m, kg, s, C"}, johnson_cook("specific_heat: 460")},
       {{"m, kg, s", "m, kg, s, C"}, johnson_cook("specific_heat: 460, start_temperature: 20, room_temperature: 20")}},
      {"RateAndExponentSwapped",
       "cowper_symonds",
       "cowper_symonds_exponent: 40.4",
       {with_rate("cowper_symonds_rate: 5, cowper_symonds_exponent: 40.4")},
       {with_rate("cowper_symonds_rate: 40.4, cowper_symonds_exponent: 5")}},
      {"RateInMicrosecondsAndExponentSwapped",
       "cowper_symonds",
       "cowper_symonds_exponent: 4.04e-5",
       {with_rate("cowper_symonds_rate: 5, cowper_symonds_exponent: 4.04e-5")},
       {with_rate("cowper_symonds_rate: 4.04e-5, cowper_symonds_exponent: 5")}},
      {"ExponentWithoutRate",
       "cowper_symonds",
       "cowper_symonds_exponent: 5",
       {with_rate("cowper_symonds_exponent: 5")},
       {with_rate("cowper_symonds_rate: 6500, cowper_symonds_exponent: 4")}},
      {"OgdenThatSoftens",
       "unstable_rubber",
       "terms: [[-2, 4e5]",
       {{steel, "ogden, density: 1100, bulk_modulus: 2e7, terms: [[-2, 4e5], [2, 9e5]]"}},
       {{steel, "ogden, density: 1100, bulk_modulus: 2e7, terms: [[-2, -4e5], [2, 9e5]]"}}},
      {"FoamThatSoftens",
       "unstable_rubber",
       "terms: [[-8, 2e4]",
       {{steel, "hyperfoam, density: 60, terms: [[-8, 2e4], [2, 2e5]]"}},
       {{steel, "hyperfoam, density: 60, terms: [[-2, -2e4], [2, 2e5]]"}}},
      {"FoamWhoseCurvesCross",
       "foam_rates",
       "compression_at_rates",
       {{steel, rate_foam("[[0.01, [[0, 0], [0.5, 2e5], [0.8, 2e6]]], [10, [[0, 0], [0.5, 4e5], [0.8, 1.8e6]]]]")}},
       {{steel, rate_foam("[[0.01, [[0, 0], [0.5, 2e5], [0.8, 2e6]]], [10, [[0, 0], [0.5, 4e5], [0.8, 2.8e6]]]]")}}},
      {"FoamWithoutASlowCurve",
       "foam_rates",
       "compression_at_rates",
       {{steel, rate_foam("[[1e6, [[0, 0], [0.5, 2e5]]], [1e7, [[0, 0], [0.5, 4e5]]]]")}},
       {{steel, rate_foam("[[1, [[0, 0], [0.5, 2e5]]], [1e7, [[0, 0], [0.5, 4e5]]]]")}}},
      {"DamageOfAnotherSign",
       "damage_sign",
       "d3: 2.12",
       {{"400e6}", "400e6, failure: {johnson_cook: {d1: 0.05, d2: 3.44, d3: 2.12}}}"}},
       {{"400e6}", "400e6, failure: {johnson_cook: {d1: 0.05, d2: 3.44, d3: -2.12}}}"}}},
      {"FailureStrainOfTwoMeshes",
       "failure_size",
       "failure: {plastic_strain: 0.3}",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3}}"}, {"cells: [5, 5]", "cells: [40, 40]"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3}}"}, {"cells: [5, 5]", "cells: [12, 12]"}}},
      {"FailureStressOfTwoMeshes",
       "failure_size",
       "failure: {principal_stress: 300e6}",
       {{"400e6}", "400e6, failure: {principal_stress: 300e6}}"}, {"cells: [5, 5]", "cells: [40, 40]"}},
       {{"400e6}", "400e6, failure: {principal_stress: 300e6}}"}, {"cells: [5, 5]", "cells: [12, 12]"}}},
      {"CutOffPressureOfTwoMeshes",
       "failure_size",
       "failure: {pressure: 300e6}",
       {{"400e6}", "400e6, failure: {pressure: 300e6}}"}, fine_sheet},
       {{"400e6}", "400e6, failure: {yield_time: 1e-4}}"}, fine_sheet}},
      {"VoidsOfTwoMeshes",
       "failure_size",
       "steel: {model: gurson",
       {porous, small_part("2")},
       {porous, small_part("1")}},
      {"PrincipalStrainOfTwoMeshes",
       "failure_size",
       "failure: {principal_strain: 0.3}",
       {{"400e6}", "400e6, failure: {principal_strain: 0.3}}"}, fine_sheet},
       {{"400e6}", "400e6, failure: {principal_strain: 0.3, size: [[1e-6, 2], [1e6, 1]]}}"}, fine_sheet}},
      {"DamageOfTwoMeshes",
       "failure_size",
       "failure: {johnson_cook",
       {{"400e6}", "400e6, failure: {johnson_cook: {d1: 0.3}}}"}, fine_sheet},
       {{"400e6}", "400e6, failure: {johnson_cook: {d1: 0.3}, size: [[1e-6, 2], [1e6, 1]]}}"}, fine_sheet}},
      {"ThinningOfTwoMeshes",
       "failure_size",
       "failure: {thinning: 0.3}",
       {{"400e6}", "400e6, failure: {thinning: 0.3}}"}, {shells_of_plate[0], shells_of_plate[1]}, fine_sheet},
       {{"400e6}", "400e6, failure: {thinning: 0.3}}"}, {shells_of_plate[0], shells_of_plate[1]}}},
      {"MeanThinningOfTwoMeshes",
       "failure_size",
       "failure: {mean_thinning: 0.3}",
       {{"400e6}", "400e6, failure: {mean_thinning: 0.3}}"}, {shells_of_plate[0], shells_of_plate[1]}, fine_sheet},
       {{"400e6}", "400e6, failure: {mean_thinning: 0.3}}"}, {shells_of_plate[0], shells_of_plate[1]}}},
      {"FailureStrainOfTwoMeshesWithSizes",
       "failure_size",
       "failure: {plastic_strain: 0.3}",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3}}"}, {"cells: [5, 5]", "cells: [40, 40]"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, size: [[1e-6, 2], [1e6, 1]]}}"},
        {"cells: [5, 5]", "cells: [40, 40]"}}},
      {"EnergyOfDamageThatElementsHold",
       "softening_size",
       "evolution: {energy: 1}",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {energy: 1}}}"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {energy: 1e5}}}"}}},
      {"ExponentialDamageThatElementsOutrun",
       "softening_size",
       "evolution: {displacement: 1e-3",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {displacement: 1e-3, exponent: 50}}}"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {displacement: 1e-3}}}"}}},
      {"DamageOverAStrain",
       "softening_strain",
       "plastic_strain: 0.1",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {plastic_strain: 0.1}}}"}},
       {{"400e6}",
         "400e6, failure: {plastic_strain: 0.3, size: [[1e-3, 1], [0.1, 0.5]], evolution: {plastic_strain: 0.1}}}"}}},
      {"HardeningThatFalls",
       "softening_strain",
       "hardening: [[0, 120e6]",
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6], [0.1, 160e6], [0.5, 40e6]]"}},
       {{"j2_plasticity", "tabulated_plasticity"},
        {"yield_stress: 120e6, hardening_modulus: 400e6", "hardening: [[0, 120e6], [0.1, 160e6], [0.5, 159e6]]"}}},
      {"CouplingThatBeginsBehindFailure",
       "late_softening",
       "strain: [[0, 0.3], [1, 0.2]]",
       {{"400e6}", "400e6, failure: {triaxiality: [[0, 0.2], [0.6, 0.1]], coupling: {strain: [[0, 0.3], [1, 0.2]]}}}"}},
       {{"400e6}",
         "400e6, failure: {triaxiality: [[0, 0.3], [1, 0.2]], coupling: {strain: [[0, 0.2], [0.6, 0.1]]}}}"}}},
      {"DamageByAStrainOfTwoMeshes",
       "failure_size",
       "failure: {plastic_strain: 0.3",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {plastic_strain: 0.1}}}"}, fine_sheet},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, evolution: {energy: 1e5}}}"}, fine_sheet}},
      {"SizesOfFailureThatElementsLeave",
       "failure_size",
       "size: [[1e-6, 2], [2e-6, 1]]",
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, size: [[1e-6, 2], [2e-6, 1]]}}"}},
       {{"400e6}", "400e6, failure: {plastic_strain: 0.3, size: [[1e-6, 2], [1e6, 1]]}}"}}},
      {"MaterialOfNoPart", "unused_material", "steel: {", {{"material: steel", "material: aluminium"}}, {}},
      {"FluidHeldByItsHourglassControl",
       "fluid_hourglass",
       "block: {",
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2e9}"},
        {"initial:", start + "hourglass: stiffness}\ninitial:"}},
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2e9}"},
        {"initial:", start + "hourglass: viscous}\ninitial:"}}},
      {"FluidOfTetrahedra",
       "fluid_hourglass",
       "block: {",
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2e9}"},
        {"initial:", start + "hourglass: assumed_strain}\ninitial:"}},
       {{"elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3",
         "fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2e9}"},
        {"initial:", start + "hourglass: assumed_strain}\ninitial:"},
        {"block: {", "block: {elements: tetrahedra, "}}},
  };
}

}  // namespace

std::vector<SuspiciousDeck> suspicious_units() {
  std::vector<SuspiciousDeck> all = unit_decks();
  for (const SuspiciousDeck& deck : material_decks()) all.push_back(deck);
  return all;
}

}  // namespace percuss
