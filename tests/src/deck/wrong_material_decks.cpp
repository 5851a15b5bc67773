// Wrong decks: constants of materials.

#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

/// The right deck with other keys of its material.
std::string material(const std::string& keys) {
  return change("model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3", keys);
}

/// A material with tables for several rates.
std::string rate_table(const std::string& keys) {
  return material("model: rate_table_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, " + keys);
}

std::string rate_foam(const std::string& keys) {
  return material("model: rate_table_foam, density: 60, youngs_modulus: 5e6, " + keys);
}

/// Curves of one row at the rates 0, 1, 2, ...
std::string repeat_curves(int count) {
  std::string text;
  for (int k = 0; k < count; ++k) text += (k > 0 ? ", [" : "[") + std::to_string(k) + ", [[0, 1e8]]]";
  return text;
}

}  // namespace

std::vector<WrongDeck> wrong_material_decks() {
  return {
      {"TableOfNothing",
       material(
           "model: tabulated_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: []"),
       "5:110", "hardening has 0 rows in material 'steel' (must have 1 to 32)"},
      {"TableThatGoesBack",
       material("model: tabulated_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: "
                "[[0, 1e8], [0, 2e8]]"),
       "5:121", "hardening.1 begins with 0 after 0 in material 'steel' (rows must ascend)"},
      {"TableOfNegativeStress",
       material("model: tabulated_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: "
                "[[0, 1e8], [1, -2e8]]"),
       "5:121", "hardening.1 has the value -200000000 in material 'steel' (must be positive)"},
      {"TableIsANumber",
       material(
           "model: tabulated_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: 4e8"),
       "5:110", "hardening is 4e8 in material 'steel' (must be a list"},
      {"RatesThatGoBack", rate_table("hardening_at_rates: [[1, [[0, 1e8]]], [1, [[0, 2e8]]]]"), "5:138",
       "hardening_at_rates.1 begins with the rate 1 after 1 in material 'steel' (rates must ascend)"},
      {"NegativeRateOfACurve", rate_table("hardening_at_rates: [[-1, [[0, 1e8]]]]"), "5:122",
       "hardening_at_rates.0.0 is -1 in material 'steel' (must be zero or positive)"},
      {"CurveOfARateThatGoesBack", rate_table("hardening_at_rates: [[1, [[0, 1e8], [0, 2e8]]]]"), "5:136",
       "hardening_at_rates.0.1.1 begins with 0 after 0 in material 'steel' (rows must ascend)"},
      {"CurveWithoutRate", rate_table("hardening_at_rates: [[[0, 1e8], [1, 2e8]]]"), "5:122",
       "hardening_at_rates.0.0 is [0, 1e8] in material 'steel' (must be a number)"},
      {"ThirteenRates", rate_table("hardening_at_rates: [" + repeat_curves(13) + "]"), "5:120",
       "hardening_at_rates has 13 rates and 13 rows in material 'steel' (must have 1 to 12 rates, and at most 240 rows "
       "in "
       "all)"},
      {"LogarithmOfNoRate", rate_table("rate_interpolation: logarithmic, hardening_at_rates: [[0, [[0, 1e8]]]]"), "5:3",
       "material 'steel' has logarithmic rate_interpolation beside a rate of 0"},
      {"UnknownInterpolation", rate_table("rate_interpolation: log, hardening_at_rates: [[1, [[0, 1e8]]]]"), "5:120",
       "rate_interpolation is 'log' in material 'steel' (must be linear | logarithmic"},
      {"PowerLawWithoutExponent",
       material("model: power_law_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: "
                "1e8, hardening_coefficient: 1e8"),
       "5:3", "hardening_exponent is missing in material 'steel'"},
      {"KinematicShareAboveOne",
       material("model: combined_hardening, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: "
                "1e8, kinematic_share: 1.5"),
       "5:133", "kinematic_share is 1.5 in material 'steel' (must be from 0 to 1)"},
      {"TsaiAndWuWithoutCompression",
       material("model: orthotropic, density: 1600, moduli: [140e9, 10e9, 10e9], poissons_ratios: [0.3, 0.4, 0.3], "
                "shear_moduli: [5e9, 3.5e9, 5e9], matrix_tension: 6e7, shear: 8e7, matrix_criterion: tsai_wu"),
       "5:3", "material 'steel' has matrix_criterion tsai_wu without matrix_tension and matrix_compression"},
      {"TooManyBackStresses",
       material("model: chaboche, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 1e8, "
                "back_stresses: [[1, 1e8], [2, 1e8], [3, 1e8], [4, 1e8], [5, 1e8]]"),
       "5:3", "material 'steel' has more than 4 rows of back_stresses"},
      {"NegativeRecovery",
       material("model: chaboche, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 1e8, "
                "back_stresses: [[-1, 1e8]]"),
       "5:3", "material 'steel' has a rate of back_stresses that is negative"},
      {"SoftensToNothing",
       material("model: chaboche, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 1e8, "
                "back_stresses: [[1, 1e8]], cyclic_stress: -1e8"),
       "5:3", "material 'steel' has a sum of yield_stress and cyclic_stress that is not positive"},
      {"CriticalVoidsAtTheStart",
       material("model: gurson, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, 1e8]], "
                "void_fraction: 0.1, critical_void_fraction: 0.1"),
       "5:3", "material 'steel' has a void_fraction that is not below critical_void_fraction"},
      {"FailsBeforeVoidsCoalesce",
       material("model: gurson, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, 1e8]], "
                "critical_void_fraction: 0.2, failure_void_fraction: 0.1"),
       "5:3", "material 'steel' has a failure_void_fraction that is not above critical_void_fraction"},
      {"VoidsThatKeepStrength",
       material("model: gurson, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, 1e8]], "
                "q1: 1.4"),
       "5:3", "material 'steel' has a q3 above the square of q1"},
      {"NegativeRate",
       material("model: voce_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 1e8, "
                "saturation_stress: 1e8, saturation_rate: 3, cowper_symonds_rate: -1"),
       "5:178", "cowper_symonds_rate is -1 in material 'steel' (must be zero or positive)"},
      {"RateWithoutExponent",
       material("model: voce_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 1e8, "
                "saturation_stress: 1e8, saturation_rate: 3, cowper_symonds_rate: 40.4"),
       "5:157",
       "cowper_symonds_rate has no cowper_symonds_exponent in material 'steel' (1 + (rate / 40.4)^(1/q) needs q"},
      {"StrainRatiosBesideYieldRatios",
       material(
           "model: anisotropic_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, "
           "1e8]], r_values: [2, 1, 1], yield_ratios: [1, 1, 1.1]"),
       "5:124", "r_values is given beside yield_ratios in material 'steel' (which says how the material yields)"},
      {"StrainRatiosBesideBarlat",
       material(
           "model: anisotropic_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, "
           "1e8]], barlat: [1, 1, 1], r_values: [2, 1, 1]"),
       "5:143", "r_values is given beside barlat in material 'steel'"},
      {"ShearYieldRatiosAlone",
       material(
           "model: anisotropic_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: [[0, "
           "1e8]], shear_yield_ratios: [2, 1, 1]"),
       "5:124", "shear_yield_ratios has no effect without yield_ratios in material 'steel': give both"},
      {"EnergyWithoutStrength",
       material(
           "model: orthotropic, density: 1600, moduli: [1, 1, 1], poissons_ratios: [0, 0, 0], shear_moduli: [1, 1, 1], "
           "fibre_tension: 0, fibre_tension_energy: 100"),
       "5:136", "fibre_tension_energy has no effect without fibre_tension in material 'steel': give both"},
      {"TransverseShearAlone",
       material(
           "model: orthotropic, density: 1600, moduli: [1, 1, 1], poissons_ratios: [0, 0, 0], shear_moduli: [1, 1, 1], "
           "transverse_shear: 1"),
       "5:118", "transverse_shear has no effect without matrix_compression in material 'steel'"},
      {"MeltsBelowRoomTemperature",
       material("model: johnson_cook, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, a: 1e8, b: 1e8, n: "
                "0.2, specific_heat: 460, melt_temperature: 200"),
       "5:3", "material 'steel' has a melt_temperature that is not above its room_temperature"},
      {"StartsMolten",
       material("model: johnson_cook, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, a: 1e8, b: 1e8, n: "
                "0.2, specific_heat: 460, melt_temperature: 900, start_temperature: 900"),
       "5:3", "material 'steel' has a melt_temperature that is not above its start_temperature"},
      {"KeyOfAnotherPlasticity",
       material("model: power_law_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: "
                "1e8, hardening_coefficient: 1e8, hardening_exponent: 1, kinematic_share: 1"),
       "5:169", "a key of model combined_hardening, not of power_law_plasticity"},
      {"FluidWithoutState", material("model: fluid, density: 1"), "5:3",
       "equation_of_state is missing in material 'steel'"},
      {"ElasticWithState",
       material("model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, equation_of_state: {kind: "
                "linear, bulk_modulus: 1}"),
       "5:86", "material 'steel' has an equation_of_state, which model elastic does not take"},
      {"StateWithoutKind", material("model: fluid, density: 1, equation_of_state: {gamma: 1.4}"), "5:37",
       "equation_of_state.kind is missing in material 'steel'"},
      {"UnknownState", material("model: fluid, density: 1, equation_of_state: {kind: ideal}"), "5:63",
       "did you mean 'ideal_gas'?"},
      {"KeyOfAnotherState",
       material("model: fluid, density: 1, equation_of_state: {kind: linear, bulk_modulus: 1, gamma: 1.4}"), "5:88",
       "a key of kind ideal_gas, not of linear"},
      {"GammaOfOne",
       material("model: fluid, density: 1, equation_of_state: {kind: ideal_gas, gamma: 1, start_energy: 1}"), "5:81",
       "gamma is 1 in material 'steel' (must be above 1)"},
      {"VapourBeforeIncipient",
       material("model: fluid, density: 1, equation_of_state: {kind: tillotson, heat_a: 0.5, heat_b: 1, bulk_a: 1, "
                "bulk_b: 1, reference_energy: 1, alpha: 5, beta: 5, incipient_energy: 3, vapour_energy: 2}"),
       "5:37", "has a vapour_energy that is not above its incipient_energy"},
      {"DetonationInAPlane",
       material("model: fluid, density: 1, equation_of_state: {kind: jwl, a: 1, b: 1, r1: 4, r2: 1, omega: 0.3, "
                "energy: 1, detonation_velocity: 1, detonation_point: [0, 0]}"),
       "5:159", "detonation_point is [0, 0] in material 'steel' (must be a list of 3"},
      {"SoilThatStartsUnderPressure",
       material("model: soil_and_foam, density: 1, shear_modulus: 1, unloading_bulk_modulus: 2, a0: 1, compaction: "
                "[[0, 1], [1, 2]]"),
       "5:3", "material 'steel' has a compaction that does not begin with [0, 0]"},
      {"SoilSteeperThanItsRelease",
       material("model: soil_and_foam, density: 1, shear_modulus: 1, unloading_bulk_modulus: 2, a0: 1, compaction: "
                "[[0, 0], [1, 3]]"),
       "5:3", "material 'steel' has a compaction that is steeper than its unloading_bulk_modulus"},
      {"SoilWhosePressureFalls",
       material("model: soil_and_foam, density: 1, shear_modulus: 1, unloading_bulk_modulus: 2, a0: 1, compaction: "
                "[[0, 0], [1, 1], [2, 0.5]]"),
       "5:3", "material 'steel' has a compaction whose pressure falls"},
      {"FoamOfOneRow", material("model: low_density_foam, density: 1, youngs_modulus: 1, compression: [[0, 0]]"), "5:3",
       "material 'steel' has a compression that does not begin with [0, 0] and a second row"},
      {"FoamThatGivesBackMoreThanItTook",
       material("model: low_density_foam, density: 1, youngs_modulus: 1, compression: [[0, 0], [1, 1]], "
                "hysteretic_unloading: 1.2"),
       "5:120", "hysteretic_unloading is 1.2 in material 'steel' (must be from 0 to 1)"},
      {"FoamWhoseSlowCurveFalls", rate_foam("compression_at_rates: [[1, [[0, 0], [0.1, 2], [0.2, 1]]]]"), "5:3",
       "material 'steel' has a curve of the lowest rate whose stress falls"},
      {"FoamWhoseRatesGoBack", rate_foam("compression_at_rates: [[1, [[0, 0], [1, 1]]], [0.5, [[0, 0], [1, 2]]]]"),
       "5:115", "compression_at_rates.1 begins with the rate 0.5 after 1 in material 'steel' (rates must ascend)"},
      {"FoamThatFailsWithoutALimit", rate_foam("after_cutoff: none, compression_at_rates: [[1, [[0, 0], [1, 1]]]]"),
       "5:3", "material 'steel' has after_cutoff without a tension_cutoff"},
      {"FoamThatReleasesTooFast", rate_foam("unloading_exponent: 0.5, compression_at_rates: [[1, [[0, 0], [1, 1]]]]"),
       "5:3", "material 'steel' has an unloading_exponent below 1"},
      {"CelsiusWithAnEquationOfState",
       material("model: johnson_cook, density: 1, youngs_modulus: 1, poissons_ratio: 0.3, a: 1, b: 1, n: 1, "
                "melt_temperature: 1000, specific_heat: 1, start_temperature: 20, room_temperature: 20, "
                "equation_of_state: {kind: linear, bulk_modulus: 1}"),
       "5:3", "absolute_zero is -273.15 for degrees Celsius"},
      {"TooManyRelaxations",
       material("model: viscoelastic, density: 1, bulk_modulus: 1, long_term_shear_modulus: 1, relaxation: [[1, 1], "
                "[2, 1], [3, 1], [4, 1], [5, 1], [6, 1], [7, 1]]"),
       "5:3", "material 'steel' has more than 6 rows of relaxation"},
      {"RelaxationInNoTime",
       material("model: viscoelastic, density: 1, bulk_modulus: 1, long_term_shear_modulus: 1, relaxation: [[0, 1]]"),
       "5:3", "material 'steel' has a relaxation time that is not positive"},
      {"NothingRelaxes", material("model: viscoelastic, density: 1, bulk_modulus: 1, long_term_shear_modulus: 1"),
       "5:3", "material 'steel' has neither relaxation nor bulk_relaxation"},
      {"OgdenWithoutStiffness", material("model: ogden, density: 1, bulk_modulus: 1, terms: [[-2, 1], [1, 2]]"), "5:3",
       "material 'steel' has terms whose shear modulus, half the sum of mu alpha, is not positive"},
      {"OgdenOfExponentZero", material("model: ogden, density: 1, bulk_modulus: 1, terms: [[0, 1], [1, 2]]"), "5:3",
       "material 'steel' has an exponent of terms that is 0"},
      {"FoamThatSwells", material("model: hyperfoam, density: 1, poissons_ratio: -0.4, terms: [[2, 1]]"), "5:3",
       "material 'steel' has a poissons_ratio that is not above -1/3"},
      {"CurveOfTensionAlone",
       material("model: tabulated_rubber, density: 1, bulk_modulus: 1, uniaxial: [[0, 0], [1, 1], [2, 2]]"), "5:3",
       "material 'steel' has a uniaxial curve without a row of compression and one of tension"},
      {"CurveThatMissesItsOrigin",
       material("model: tabulated_rubber, density: 1, bulk_modulus: 1, uniaxial: [[-0.5, -1], [1, 1], [2, 2]]"), "5:3",
       "material 'steel' has a uniaxial curve without the row [0, 0]"},
  };
}

}  // namespace percuss
