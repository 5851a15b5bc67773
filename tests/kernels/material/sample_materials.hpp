#pragma once
// Constants of every material and equation of state of the lists, for tests that go through all of them. A new one has
// no sample until it gets its overload here, and those tests do not compile.

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "kernels/material/laws/materials.hpp"
#include "kernels/material/pressure/equations_of_state.hpp"
#include "kernels/material/user/export_law.hpp"

namespace percuss::test {

template <class Law>
struct Of {};

inline constexpr double sample_density = 2000;

// They yield, crush, relax and feel their rate within some hundredths of strain at about 1 / s.
inline Elastic::Constants make_sample(Of<Elastic>) { return {20e9, 0.3}; }
inline J2Plasticity::Constants make_sample(Of<J2Plasticity>) { return {20e9, 0.3, 200e6, 1e9}; }
inline PowerLawPlasticity make_sample(Of<PowerLawPlasticity>) { return {20e9, 0.3, 150e6, 300e6, 0.4, 2, 3}; }
inline VocePlasticity make_sample(Of<VocePlasticity>) { return {20e9, 0.25, 150e6, 100e6, 30, 0.5e9, 2, 3}; }
inline TabulatedPlasticity make_sample(Of<TabulatedPlasticity>) {
  return {20e9, 0.3, {3, {0, 0.02, 0.06}, {150e6, 220e6, 250e6}}, 2, 4};
}
inline RateTablePlasticity make_sample(Of<RateTablePlasticity>) {
  using Rows = std::vector<std::array<double, 2>>;
  RateTablePlasticity law{20e9, 0.3, {}, true};
  law.hardening.add_curve(0.1, Rows{{0, 150e6}, {0.02, 220e6}, {0.06, 250e6}});
  law.hardening.add_curve(2, Rows{{0, 200e6}, {0.05, 300e6}});
  return law;
}
inline CombinedHardening make_sample(Of<CombinedHardening>) { return {20e9, 0.3, 150e6, 2e9, 0.6, 2, 3}; }
inline Chaboche make_sample(Of<Chaboche>) {
  return {20e9, 0.3, 100e6, {3, {0, 40, 300}, {0.5e9, 3e9, 20e9}}, 60e6, 20, 0.5e9, 2, 3};
}
inline Gurson make_sample(Of<Gurson>) {
  Gurson law{20e9, 0.3, {3, {0, 0.02, 0.06}, {150e6, 220e6, 250e6}}};
  law.void_fraction = 0.01, law.nucleation_fraction = 0.02, law.nucleation_strain = 0.03;
  law.nucleation_deviation = 0.02, law.cowper_symonds_rate = 2, law.cowper_symonds_exponent = 3;
  return law;
}
inline JohnsonCook make_sample(Of<JohnsonCook>) {
  JohnsonCook law{20e9, 0.3, 150e6, 200e6, 0.4, 0.02, 1.1};
  law.reference_rate = 0.1;
  law.melt_temperature = 900;
  law.specific_heat = 200;
  return law;
}
inline NeoHookean make_sample(Of<NeoHookean>) { return {3e6, 0.4}; }
inline MooneyRivlin make_sample(Of<MooneyRivlin>) { return {0.4e6, 0.1e6, 20e6}; }
inline Yeoh make_sample(Of<Yeoh>) { return {0.4e6, -0.02e6, 0.01e6, 20e6}; }
inline ArrudaBoyce::Constants make_sample(Of<ArrudaBoyce>) { return {0.8e6, 3, 20e6}; }
inline Ogden make_sample(Of<Ogden>) { return {{2, {-2, 3}, {-0.2e6, 0.4e6}}, 20e6}; }
inline TabulatedRubber::Constants make_sample(Of<TabulatedRubber>) {
  return {{4, {-0.4, 0, 0.5, 1}, {-2e6, 0, 1e6, 2.5e6}}, 20e6};
}
inline Hyperfoam make_sample(Of<Hyperfoam>) { return {{2, {-1.5, 6}, {-0.05e6, 0.06e6}}, 0.2}; }
inline Viscoelastic make_sample(Of<Viscoelastic>) {
  return {1e9, 1e7, {2, {0.01, 0.2}, {5e7, 2e7}}, {1, {0.05}, {4e8}}};
}
inline SoilAndFoam make_sample(Of<SoilAndFoam>) {
  return {1e9, 5e9, 2e6, 0.6, -1e-9, 1e6, {3, {0, 0.02, 0.1}, {0, 40e6, 300e6}}};
}
inline Honeycomb make_sample(Of<Honeycomb>) {
  return {7e9,
          0.33,
          20e6,
          0.2,
          {1e9, 2e9, 1.5e9},
          {0.3e9, 0.5e9, 0.4e9},
          {2, {0, 0.7}, {1e6, 2e6}},
          {2, {0, 0.7}, {3e6, 9e6}},
          {2, {0, 0.7}, {5e6, 6e6}},
          {2, {0, 0.7}, {0.8e6, 1.5e6}},
          {2, {0, 0.7}, {2.2e6, 0.4e6}},
          {2, {0, 0.7}, {0.3e6, 2.4e6}}};
}
inline OrthotropicConstants make_sample(Of<Orthotropic>) {
  OrthotropicConstants law{{30e9, 12e9, 15e9}, {0.25, 0.3, 0.2}, {4e9, 5e9, 6e9}};
  const double first[3] = {1, 0.5, 0.2}, second[3] = {-0.3, 1, 0};
  for (int k = 0; k < 3; ++k) {
    law.first_axis[k] = first[k];
    law.second_axis[k] = second[k];
  }
  return law;
}
inline AnisotropicPlasticityConstants make_sample(Of<AnisotropicPlasticity>) {
  AnisotropicPlasticityConstants law{10e9, 0.3, {2, {0, 0.1}, {20e6, 60e6}}, {0.7, 1.6, 1.1}};
  const double first[3] = {1, 0.5, 0.2}, second[3] = {-0.3, 1, 0};
  for (int k = 0; k < 3; ++k) {
    law.first_axis[k] = first[k];
    law.second_axis[k] = second[k];
  }
  return law;
}
inline LowDensityFoam make_sample(Of<LowDensityFoam>) {
  return {5e6, 0.2, 2, {4, {0, 0.05, 0.6, 0.8}, {0, 0.2e6, 0.3e6, 2e6}}};
}
inline RateTableFoam make_sample(Of<RateTableFoam>) {
  using Rows = std::vector<std::array<double, 2>>;
  RateTableFoam law{};
  law.youngs_modulus = 5e6, law.hysteretic_unloading = 0.2, law.unloading_shape = 2;
  law.compression.add_curve(0.1, Rows{{0, 0}, {0.05, 0.2e6}, {0.6, 0.3e6}, {0.8, 2e6}});
  law.compression.add_curve(2, Rows{{0, 0}, {0.05, 0.4e6}, {0.7, 0.8e6}, {0.8, 3e6}});
  return law;
}
inline Fluid make_sample(Of<Fluid>) { return {}; }

/// What a user would bring: St. Venant and Kirchhoff's law as a VUMAT, of the increments of strain. PROPS: lambda, mu;
/// STATEV: strain along x, which only grows.
inline void sample_vumat(const int* points, const int*, const int*, const int*, const int*, const int*, const int*,
                         const double*, const double*, const double*, const char*, const double*, const double*,
                         const double* constant, const double*, const double* strain, const double*, const double*,
                         const double*, const double*, const double*, const double* stress_old, const double* state_old,
                         const double*, const double*, const double*, const double*, const double*, const double*,
                         double* stress_new, double* state_new, double*, double*, std::size_t) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double volume = strain[i] + strain[n + i] + strain[2 * n + i];
    for (int k = 0; k < 6; ++k)
      stress_new[k * n + i] =
          stress_old[k * n + i] + (k < 3 ? constant[0] * volume : 0) + 2 * constant[1] * strain[k * n + i];
    state_new[i] = state_old[i] + (strain[i] > 0 ? strain[i] : 0);
  }
}
inline UserLaw make_sample(Of<UserLaw>) {
  static int outside = 0;
  UserLaw law;
  law.code = {sample_vumat, sample_density, &outside};
  law.constants = {2, {6e9, 4e9}};
  law.states = 1;
  return law;
}

/// What a user would bring: Voce's growth times a linear rate and a softening that is linear in the temperature, which
/// is that of the end of the step. PROPS: yield, growth, its rate, 1 / rate, 1 / temperature; STATEV: the mean strain
/// of the yield.
inline void sample_vuhard(const int* points, const int*, const int*, const int*, const int*, const int*, const double*,
                          const double*, const double*, const char*, const int* states, const int*, const int*,
                          const double* c, const double*, const double* temperature, const double*, const double*,
                          const double*, const double* strain, const double* rate, double* yield,
                          double* by_temperature, double* by_strain, double* state_new, std::size_t) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double at_rest = c[0] + c[1] * (1 - std::exp(-c[2] * strain[i]));
    const double faster = 1 + c[3] * rate[i], softer = 1 - c[4] * temperature[i];
    yield[i] = at_rest * faster * softer;
    by_strain[i] = c[1] * c[2] * std::exp(-c[2] * strain[i]) * faster * softer;
    by_strain[n + i] = at_rest * c[3] * softer;
    by_temperature[i] = -at_rest * faster * c[4];
    if (*states > 0) state_new[i] = 2 * strain[i];
  }
}
inline UserHardening make_sample(Of<UserHardening>) {
  static int outside = 0;
  UserHardening law;
  law.youngs_modulus = 20e9;
  law.poissons_ratio = 0.25;
  law.code.vuhard = sample_vuhard;
  law.code.has_written_outside = &outside;
  law.constants = {5, {150e6, 100e6, 30, 0.1, 1e-3}};
  law.states = 1;
  law.specific_heat = 200;
  return law;
}
inline LibraryLaw make_sample(Of<LibraryLaw>) {
  static const LawLibrary library = ExportedLaw<NeoHookean>::list();
  static const NeoHookean law = make_sample(Of<NeoHookean>());
  static int outside = 0;
  return {{&library, &law, &outside}};
}

inline LinearState make_sample(Of<LinearState>) { return {10e9}; }
inline MieGrueneisenState make_sample(Of<MieGrueneisenState>) { return {3000, 1.5, 2, 1e8}; }
inline PolynomialState make_sample(Of<PolynomialState>) { return {1e8, 10e9, 5e9, 20e9, 0.5, 0.3, 0.1, 1e9}; }
inline TabulatedState make_sample(Of<TabulatedState>) {
  return {{3, {-0.2, 0, 0.1}, {4e9, 0.1e9, -0.5e9}}, {2, {-0.3, 0.3}, {1.5, 0.6}}, 0.8, 2e8};
}
inline IdealGasState make_sample(Of<IdealGasState>) { return {1.4, 2.5e5}; }
inline TillotsonState make_sample(Of<TillotsonState>) { return {0.5, 1.5, 18e9, 18e9, 16e6, 5, 5, 3.5e6, 18e6, 1e8}; }
inline JwlState make_sample(Of<JwlState>) { return {371.2e9, 3.231e9, 4.15, 0.95, 0.3, 7e9, 6930, {0, 0, 0}}; }

template <class Law>
Law make_sample_law() {
  if constexpr (std::is_same_v<Law, typename Law::Constants>) {
    return make_sample(Of<Law>());
  } else {
    return Law::make(make_sample(Of<Law>()));
  }
}

template <class Law>
inline constexpr bool needs_state = requires {
  requires Law::needs_equation_of_state;
};

/// A law with an equation of state, or none: void.
template <class L, class S>
struct Pairing {
  using Law = L;
  using State = S;
};

/// Every law by itself, or with a gas if it must have an equation of state.
template <class Law>
using OwnPairing = Pairing<Law, std::conditional_t<needs_state<Law>, IdealGasState, void>>;

template <class... Law, class... State>
TypeList<OwnPairing<Law>..., Pairing<Fluid, State>..., Pairing<JohnsonCook, State>...> list_pairings(
    TypeList<Law...>, TypeList<State...>);

/// Every law, and every equation of state without strength and with that of a material that it heats.
using Pairings = decltype(list_pairings(Materials(), EquationsOfState()));

}  // namespace percuss::test
