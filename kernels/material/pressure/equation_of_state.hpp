#pragma once
// Equations of state p(J, e): pressure from J = V / V(0) and the internal energy e per volume at the start.
//
// Each is a struct with the constants that a deck gives, their table of keys, and operator(). The energy comes from the
// first law, by the trapezoid with the pressure at both ends of the step and the mean viscous pressure:
//   e(n+1) = e(n) + w - ((p(n) + p(n+1)) / 2 + q) (J(n+1) - J(n)),   w: work of the deviatoric stress
// which is solved for p(n+1) together with the equation of state (Wilkins 1964).

#include "kernels/material/point/material_key.hpp"
#include "kernels/material/point/point_step.hpp"

namespace percuss {

/// p and its derivatives.
template <class T>
struct StatePressure {
  T pressure;
  T by_volume;  // dp/dJ at constant e
  T by_energy;  // dp/de at constant J
};

/// What an equation of state may look at besides J and e.
template <class T>
struct StatePoint {
  double density;   // at the start
  double time;      // at n+1
  T length;         // thickness of the element
  T lighting_time;  // of an explosive: when the detonation arrives
};

/// p = K (1/J - 1).
struct LinearState {
  static constexpr const char* name = "linear";
  using Constants = LinearState;
  double bulk_modulus = 0;

  static constexpr auto keys() {
    return std::array{
        need("bulk_modulus", &LinearState::bulk_modulus, KeyRange::positive, "pressure", "K of p = K (V0 / V - 1).")};
  }
  double find_start_energy() const { return 0; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& /*e*/, const StatePoint<T>& /*at*/) const {
    const T inverse = T(1) / j;
    return {T(bulk_modulus) * (inverse - T(1)), T(-bulk_modulus) * inverse * inverse, T(0)};
  }
};

/// Mie and Grueneisen about the Hugoniot Us = c + s up, with Gamma rho constant: with h = 1 - J,
///   p = rho0 c^2 h / (1 - s h)^2 (1 - Gamma h / 2) + Gamma e
/// in compression, and rho0 c^2 (1/J - 1) + Gamma e in expansion (Meyers, Dynamic Behavior of Materials, 1994).
struct MieGrueneisenState {
  static constexpr const char* name = "mie_grueneisen";
  using Constants = MieGrueneisenState;
  double sound_speed = 0, slope = 0, grueneisen = 0, start_energy = 0;

  static constexpr auto keys() {
    using M = MieGrueneisenState;
    return std::array{
        need("sound_speed", &M::sound_speed, KeyRange::positive, "velocity", "c of the Hugoniot Us = c + s up."),
        need("slope", &M::slope, KeyRange::not_negative, "-", "s of the Hugoniot Us = c + s up."),
        need("grueneisen", &M::grueneisen, KeyRange::not_negative, "-",
             "Gamma at the start; Gamma times density is constant."),
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start.")};
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& at) const {
    constexpr double least_gap = 1e-3;  // of 1 - s h, which vanishes where no shock can get
    const T k(at.density * sound_speed * sound_speed), gamma(grueneisen), h = T(1) - j;
    const T gap = T(1) / larger(T(1) - T(slope) * h, T(least_gap));
    const T hugoniot = k * h * gap * gap, factor = T(1) - T(0.5) * gamma * h;
    const T steepness = k * gap * gap * gap * (T(1) + T(slope) * h);  // of the Hugoniot over h
    const T inverse = T(1) / j;
    const auto compressed = h > T(0);
    return {select(compressed, hugoniot * factor, k * (inverse - T(1))) + gamma * e,
            select(compressed, T(0.5) * gamma * hugoniot - steepness * factor, -k * inverse * inverse), gamma};
  }
};

/// p = c0 + c1 m + c2 m^2 + c3 m^3 + (c4 + c5 m + c6 m^2) e with m = 1/J - 1; c2 and c6 in compression only.
struct PolynomialState {
  static constexpr const char* name = "polynomial";
  using Constants = PolynomialState;
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0, c4 = 0, c5 = 0, c6 = 0, start_energy = 0;

  static constexpr auto keys() {
    using M = PolynomialState;
    return std::array{
        may("c0", &M::c0, KeyRange::any, "pressure",
            "c0 of p = c0 + c1 m + c2 m^2 + c3 m^3 + (c4 + c5 m + c6 m^2) e, m = V0 / V - 1."),
        need("c1", &M::c1, KeyRange::not_negative, "pressure", "c1 of the pressure; see c0."),
        may("c2", &M::c2, KeyRange::any, "pressure", "c2 of the pressure, in compression only; see c0."),
        may("c3", &M::c3, KeyRange::any, "pressure", "c3 of the pressure; see c0."),
        may("c4", &M::c4, KeyRange::not_negative, "-", "c4 of the pressure; see c0."),
        may("c5", &M::c5, KeyRange::any, "-", "c5 of the pressure; see c0."),
        may("c6", &M::c6, KeyRange::any, "-", "c6 of the pressure, in compression only; see c0."),
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start.")};
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& /*at*/) const {
    const T inverse = T(1) / j, m = inverse - T(1);
    const auto compressed = m > T(0);
    const T k2 = select(compressed, T(c2), T(0)), k6 = select(compressed, T(c6), T(0));
    const T heat = T(c4) + m * (T(c5) + m * k6);
    const T by_m = T(c1) + m * (T(2) * k2 + m * T(3 * c3)) + (T(c5) + T(2) * m * k6) * e;
    return {T(c0) + m * (T(c1) + m * (k2 + m * T(c3))) + heat * e, -by_m * inverse * inverse, heat};
  }
};

/// p = (gamma - 1) e / J.
struct IdealGasState {
  static constexpr const char* name = "ideal_gas";
  using Constants = IdealGasState;
  double gamma = 0, start_energy = 0;

  static constexpr auto keys() {
    using M = IdealGasState;
    return std::array{
        need("gamma", &M::gamma, KeyRange::above_one, "-", "Ratio of specific heats."),
        need("start_energy", &M::start_energy, KeyRange::positive, "energy / volume", "Internal energy at the start.")};
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& /*at*/) const {
    const T by_energy = T(gamma - 1) / j, pressure = by_energy * e;
    return {pressure, -pressure / j, by_energy};
  }
};

}  // namespace percuss
