#pragma once
// Tillotson's equation of state for hypervelocity impact (Tillotson, General Atomic GA-3216, 1962).

#include "kernels/material/pressure/equation_of_state.hpp"

namespace percuss {

/// With E = e / rho0, r = 1/J, m = r - 1 and g = E / (E0 r^2) + 1:
///   compressed or cold:  p1 = (a + b / g) rho E + A m + B m^2
///   expanded and hot:    p2 = a rho E + (b rho E / g + A m exp(-beta (J - 1))) exp(-alpha (J - 1)^2)
/// In expansion p1 holds up to E = incipient_energy, p2 from vapour_energy, and between them what is linear in E.
struct TillotsonState {
  static constexpr const char* name = "tillotson";
  using Constants = TillotsonState;
  double a = 0, b = 0, bulk_a = 0, bulk_b = 0, reference_energy = 0, alpha = 0, beta = 0;
  double incipient_energy = 0, vapour_energy = 0, start_energy = 0;
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    using M = TillotsonState;
    return std::array{
        need("heat_a", &M::a, KeyRange::positive, "-", "a of Tillotson's pressure; see theory.md."),
        need("heat_b", &M::b, KeyRange::not_negative, "-", "b of Tillotson's pressure; see theory.md."),
        need("bulk_a", &M::bulk_a, KeyRange::positive, "pressure",
             "A of Tillotson's pressure, the bulk modulus at the start."),
        need("bulk_b", &M::bulk_b, KeyRange::not_negative, "pressure", "B of Tillotson's pressure; see theory.md."),
        need("reference_energy", &M::reference_energy, KeyRange::positive, "energy / mass",
             "E0 of Tillotson's pressure; see theory.md."),
        need("alpha", &M::alpha, KeyRange::not_negative, "-", "Alpha of Tillotson's pressure; see theory.md."),
        need("beta", &M::beta, KeyRange::not_negative, "-", "Beta of Tillotson's pressure; see theory.md."),
        need("incipient_energy", &M::incipient_energy, KeyRange::positive, "energy / mass",
             "Where an expanded material begins to vaporise."),
        need("vapour_energy", &M::vapour_energy, KeyRange::positive, "energy / mass",
             "Where it is all vapour; above incipient_energy."),
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start."),
        cutoff_key<M>()};
  }
  const char* find_fault() const {
    return vapour_energy > incipient_energy ? "" : "a vapour_energy that is not above its incipient_energy";
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION T find_pressure(const T& j, const T& e, double density) const {
    const T ratio = T(1) / j, m = ratio - T(1), expansion = j - T(1);
    const T energy = larger(e * T(1 / density), T(0)), heat = e * ratio;  // rho E
    const T g = energy / (T(reference_energy) * ratio * ratio) + T(1);
    const T dense = (T(a) + T(b) / g) * heat + m * (T(bulk_a) + T(bulk_b) * m);
    const T faded = exponential(T(-alpha) * expansion * expansion);
    const T vapour =
        T(a) * heat + (T(b) * heat / g + T(bulk_a) * m * exponential(T(-beta) * larger(expansion, T(0)))) * faded;
    const T hot =
        smaller(larger((energy - T(incipient_energy)) * T(1 / (vapour_energy - incipient_energy)), T(0)), T(1));
    return select(m >= T(0), dense, hot * vapour + (T(1) - hot) * dense);
  }

  /// Derivatives by differences: they serve the search for the pressure and the step.
  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& at) const {
    constexpr double part = 1e-6;
    const double energy_step = part * at.density * reference_energy;
    const T pressure = find_pressure(j, e, at.density), step = T(part) * j;
    const T by_volume =
        (find_pressure(j + step, e, at.density) - find_pressure(j - step, e, at.density)) / (T(2) * step);
    return {pressure, by_volume, (find_pressure(j, e + T(energy_step), at.density) - pressure) * T(1 / energy_step)};
  }
};

}  // namespace percuss
