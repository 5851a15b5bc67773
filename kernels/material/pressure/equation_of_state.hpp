#pragma once
// Equations of state p(J, e): pressure from J = V / V(0) and the internal energy e per volume at the start.
//
// Each is a struct with the constants that a deck gives, their table of keys, and operator(). The energy comes from the
// first law, by the trapezoid with the pressure at both ends of the step and the mean viscous pressure:
//   e(n+1) = e(n) + w - ((p(n) + p(n+1)) / 2 + q) (J(n+1) - J(n)),   w: work of the deviatoric stress
// which is solved for p(n+1) together with the equation of state (Wilkins 1964).

#include <limits>

#include "kernels/material/material_key.hpp"
#include "kernels/material/point_step.hpp"

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

/// The pressure below which none falls, of every equation of state, where the deck gives none.
inline constexpr double no_cutoff = -std::numeric_limits<double>::infinity();
template <class State>
constexpr MaterialKey<State> cutoff_key() {
  return may("least_pressure", &State::least_pressure, KeyRange::not_positive, "pressure",
             "Cutoff of tension: the pressure stays level there, and nothing fails.");
}

/// p = K (1/J - 1).
struct LinearState {
  static constexpr const char* name = "linear";
  using Constants = LinearState;
  double bulk_modulus = 0;
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    return std::array{
        need("bulk_modulus", &LinearState::bulk_modulus, KeyRange::positive, "pressure", "K of p = K (V0 / V - 1)."),
        cutoff_key<LinearState>()};
  }
  double find_start_energy() const { return 0; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& /*e*/, const StatePoint<T>& /*at*/) const {
    const T inverse = T(1) / j;
    return {T(bulk_modulus) * (inverse - T(1)), T(-bulk_modulus) * inverse * inverse, T(0)};
  }
};

/// Mie and Grueneisen about the Hugoniot Us = c + (s + s2 h + s3 h^2) up with h = 1 - J, m = 1/J - 1:
///   p = rho0 c^2 h / (1 - s h - s2 h^2 - s3 h^3)^2 (1 - Gamma h / 2 - a h m / 2) + (Gamma + a m) e
/// in compression, and rho0 c^2 m + (Gamma + a m) e in expansion (Steinberg, UCRL-MA-106439, 1996). With a = 0 Gamma
/// rho is constant (Meyers, Dynamic Behavior of Materials, 1994).
struct MieGrueneisenState {
  static constexpr const char* name = "mie_grueneisen";
  using Constants = MieGrueneisenState;
  double sound_speed = 0, slope = 0, grueneisen = 0, start_energy = 0;
  double slope_2 = 0, slope_3 = 0, grueneisen_slope = 0;
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    using M = MieGrueneisenState;
    return std::array{
        need("sound_speed", &M::sound_speed, KeyRange::positive, "velocity", "c of the Hugoniot Us = c + s up."),
        need("slope", &M::slope, KeyRange::not_negative, "-", "s of the Hugoniot Us = c + s up."),
        need("grueneisen", &M::grueneisen, KeyRange::not_negative, "-",
             "Gamma at the start; Gamma times density is constant."),
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start."),
        may("slope_2", &M::slope_2, KeyRange::any, "-",
            "s2 of the Hugoniot Us = c + (s + s2 h + s3 h^2) up, h = 1 - V / V0."),
        may("slope_3", &M::slope_3, KeyRange::any, "-", "s3 of the Hugoniot; see slope_2."),
        may("grueneisen_slope", &M::grueneisen_slope, KeyRange::any, "-",
            "a of Gamma + a m, by which the energy acts; m = V0 / V - 1."),
        cutoff_key<M>()};
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& at) const {
    constexpr double least_gap = 1e-3;  // least value of 1 - s h - ..., which vanishes where no shock can get
    const T k(at.density * sound_speed * sound_speed), h = T(1) - j, inverse = T(1) / j, m = inverse - T(1);
    const T gap = T(1) / larger(T(1) - (T(slope) + (T(slope_2) + T(slope_3) * h) * h) * h, T(least_gap));
    const T hugoniot = k * h * gap * gap;
    const T half_gamma = T(0.5) * T(grueneisen), half_a = T(0.5 * grueneisen_slope);
    const T factor = (T(1) - half_gamma * h) - half_a * h * m, heat = T(grueneisen) + T(grueneisen_slope) * m;
    // of the Hugoniot and of the factor over h
    const T steepness = k * gap * gap * gap * (T(1) + (T(slope) + (T(3 * slope_2) + T(5 * slope_3) * h) * h) * h);
    const T fall = half_gamma + half_a * m * (T(2) - h) * inverse;
    const auto compressed = h > T(0);
    const T by_volume = select(compressed, fall * hugoniot - steepness * factor, -k * inverse * inverse);
    return {select(compressed, hugoniot * factor, k * m) + heat * e,
            by_volume - T(grueneisen_slope) * inverse * inverse * e, heat};
  }
};

/// p = c0 + c1 m + c2 m^2 + c3 m^3 + (c4 + c5 m + c6 m^2) e with m = 1/J - 1; c2 and c6 in compression only.
struct PolynomialState {
  static constexpr const char* name = "polynomial";
  using Constants = PolynomialState;
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0, c4 = 0, c5 = 0, c6 = 0, start_energy = 0;
  double least_pressure = no_cutoff;

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
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start."),
        cutoff_key<M>()};
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

/// p = C(ln J) + gamma T(ln J) e: straight lines between the rows, and beyond them.
struct TabulatedState {
  static constexpr const char* name = "tabulated";
  using Constants = TabulatedState;
  MaterialTable cold, heat;
  double gamma = 0, start_energy = 0;
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    using M = TabulatedState;
    return std::array{
        need("cold", &M::cold, KeyRange::any, "-, pressure",
             "C of p = C + gamma T e over ln(V / V0), falling; the first and the last slope continue."),
        may("heat", &M::heat, KeyRange::any, "-, -", "T over ln(V / V0); see cold. Without it, C is all."),
        may("gamma", &M::gamma, KeyRange::any, "-", "gamma of the pressure; see cold."),
        may("start_energy", &M::start_energy, KeyRange::any, "energy / volume", "Internal energy at the start."),
        cutoff_key<M>()};
  }
  const char* find_fault() const {
    if (cold.rows < 2) return "a curve cold of one row (it has no slope)";
    for (int i = 0; i + 1 < cold.rows; ++i)
      if (cold.y[i + 1] >= cold.y[i]) return "a curve cold that does not fall (a volume that grows would be pushed)";
    return "";
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION static MaterialTable::Value<T> extend(const MaterialTable& table, const T& at) {
    if (table.rows == 0) return {T(0), T(0)};
    if (table.rows == 1) return {T(table.y[0]), T(0)};
    const int n = table.rows;
    const T first((table.y[1] - table.y[0]) / (table.x[1] - table.x[0]));
    const T last((table.y[n - 1] - table.y[n - 2]) / (table.x[n - 1] - table.x[n - 2]));
    const MaterialTable::Value<T> inside = table(at);
    const auto before = at < T(table.x[0]), behind = at >= T(table.x[n - 1]);
    const T y = select(before, T(table.y[0]) + first * (at - T(table.x[0])), inside.y);
    return {select(behind, T(table.y[n - 1]) + last * (at - T(table.x[n - 1])), y),
            select(before, first, select(behind, last, inside.slope))};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& /*at*/) const {
    const T strain = logarithm(j), inverse = T(1) / j;
    const MaterialTable::Value<T> c = extend(cold, strain), t = extend(heat, strain);
    const T by_energy = T(gamma) * t.y;
    return {c.y + by_energy * e, (c.slope + T(gamma) * t.slope * e) * inverse, by_energy};
  }
};

/// p = (gamma - 1) e / J.
struct IdealGasState {
  static constexpr const char* name = "ideal_gas";
  using Constants = IdealGasState;
  double gamma = 0, start_energy = 0;
  double least_pressure = no_cutoff;

  static constexpr auto keys() {
    using M = IdealGasState;
    return std::array{
        need("gamma", &M::gamma, KeyRange::above_one, "-", "Ratio of specific heats."),
        need("start_energy", &M::start_energy, KeyRange::positive, "energy / volume", "Internal energy at the start."),
        cutoff_key<M>()};
  }
  double find_start_energy() const { return start_energy; }

  template <class T>
  KOKKOS_INLINE_FUNCTION StatePressure<T> operator()(const T& j, const T& e, const StatePoint<T>& /*at*/) const {
    const T by_energy = T(gamma - 1) / j, pressure = by_energy * e;
    return {pressure, -pressure / j, by_energy};
  }
};

}  // namespace percuss
